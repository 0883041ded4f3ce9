// Files that were dropped.

import { Dropped, Shelf } from '../../dist/engine/engine.js';
import { pose } from './figures.ts';
import { keep } from './motions.ts';
import type { Anatomy, PosedFigure, ShownMotion } from './protocol.ts';
import type { Context } from './worker.ts';

// All files that were ever given: what scenes and models may name.
let known: Shelf | null = null;
export const shelf = (): Shelf => (known ??= new Shelf());
// The same for other engines, each with its number in the order in which they came.
const given = new Map<string, { bytes: Uint8Array; number: number }>();
let count = 0;

function add(name: string, bytes: Uint8Array): void {
  shelf().add(name, bytes);
  given.set(name, { bytes, number: (count += 1) });
}

export interface Shelved {
  count: number;
  files: { name: string; bytes: Uint8Array }[];
}

let dropped: Dropped | null = null;

function opened(): Dropped {
  if (!dropped) throw new Error('nothing is open; drop files or choose some');
  return dropped;
}

export interface OpenedFiles {
  files: { name: string; what: string; used: boolean }[];
  faults: string[];
  findings: string[];
  // Names of what there is.
  figure: string | null;
  motion: string | null;
  isCloud: boolean;
  // Whether forces were measured, and whether anybody knows where the feet meet the ground.
  measured: boolean;
  soles: boolean;
  // Texts.
  scene: string | null;
  page: string | null;
  profile: string | null;
}

export const files = {
  shelve(_: Context, name: string, bytes: Uint8Array): void {
    add(name, bytes);
  },
  shelved: (_: Context): string[] => shelf().names,
  // What came after the first so many.
  shelvedSince(_: Context, since: number): Shelved {
    const files = [...given].filter(([, { number }]) => number > since || since > count).map(([name, { bytes }]) => ({ name, bytes }));
    return { count, files };
  },
  // Opens files together; what has no figure of its own is of the one that is open.
  openFiles(_: Context, given: { name: string; bytes: Uint8Array }[]): OpenedFiles {
    const these = new Shelf();
    for (const { name, bytes } of given) {
      these.add(name, bytes);
      add(name, bytes);
    }
    if (dropped) dropped.and(these);
    else dropped = new Dropped(these);
    these.free();
    return JSON.parse(dropped.outline());
  },
  openedAnatomy: (_: Context): Anatomy => JSON.parse(opened().anatomy()),
  openedPosed: (_: Context): PosedFigure => pose(opened().posed()),
  openedMotion: (_: Context): ShownMotion => keep(opened().shown()),
  openedMoments(_: Context, ground: string, cutoff: number | null): ShownMotion & { external: string; findings: string[] } {
    const found = opened().moments(ground, cutoff ?? undefined);
    const moments = { external: found.external, findings: found.findings, ...keep(found.shown()) };
    found.free();
    return moments;
  },
};
