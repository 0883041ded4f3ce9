// Files that were dropped.

import { Shelf } from '../../dist/engine/engine.js';
import type { Context } from './worker.ts';

// What scenes and models may name.
export const shelf = (): Shelf => (known ??= new Shelf());
let known: Shelf | null = null;

export const files = {
  shelve(_: Context, name: string, bytes: Uint8Array): void {
    shelf().add(name, bytes);
  },
  shelved: (_: Context): string[] => shelf().names,
};
