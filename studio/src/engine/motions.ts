// Motions that are kept for whoever shows them: a few, the oldest go first.

import type { Motion, Shown as ShownType } from '../../dist/engine/engine.js';
import { Shown } from '../../dist/engine/engine.js';
import type { Anatomy, Row, ShownMotion } from './protocol.ts';
import type { Context } from './worker.ts';

// How many are kept besides those that somebody holds.
const KEPT = 3;
const kept = new Map<number, ShownType>();
const held = new Set<number>();
// Keys of several engines are never the same.
let next = Math.floor(Math.random() * 2 ** 40);

// `skinned`: the skin of a person is in the data.
export function keep(shown: ShownType, skinned = true): ShownMotion {
  const key = next++;
  kept.set(key, shown);
  const loose = [...kept.keys()].filter((other) => !held.has(other));
  for (const old of loose.slice(0, Math.max(0, loose.length - KEPT))) {
    kept.get(old)?.free();
    kept.delete(old);
  }
  return { key, title: shown.title, duration: shown.duration, data: shown.data(skinned) };
}

export function keepMotion(motion: Motion, title: string, skinned = true): ShownMotion {
  const shown = new Shown(motion, title);
  motion.free();
  return keep(shown, skinned);
}

export function shownBy(key: number): ShownType {
  const shown = kept.get(key);
  if (!shown) throw new Error('this motion is not there any more; make it again');
  return shown;
}

export const motions = {
  // Holds a motion for a comparison, or lets it go.
  hold(_: Context, key: number, hold: boolean): void {
    if (hold) held.add(key);
    else held.delete(key);
  },
  anatomy: (_: Context, key: number): Anatomy => JSON.parse(shownBy(key).anatomy()),
  save: (_: Context, key: number, format: string): Uint8Array => shownBy(key).save(format),
  page: (_: Context, key: number, script: string, style: string, rows: Row[]): string =>
    shownBy(key).page(
      script,
      style,
      rows.flatMap(({ label, value, unit, note }) => [label, value, unit, note]),
    ),
};
