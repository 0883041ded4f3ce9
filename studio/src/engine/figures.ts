// A figure that is posed by hand.

import { Posed } from '../../dist/engine/engine.js';
import type { Anatomy, PosedFigure } from './protocol.ts';
import type { Context } from './worker.ts';

export interface Pose {
  poses: Float32Array;
  q: number[];
  // What holds it up (nv; N m, N).
  moments: number[];
  // How far a point that is dragged still is from where it should be (m).
  off: number;
}

let posed: Posed | null = null;

export function poser(): Posed {
  if (!posed) throw new Error('no figure is posed');
  return posed;
}

// Poses another figure.
export function pose(next: Posed): PosedFigure {
  posed?.free();
  posed = next;
  return { ...JSON.parse(posed.outline()), data: posed.data(), q: [...posed.q] };
}

function now(off: number): Pose {
  const figure = poser();
  return { poses: figure.poses(), q: [...figure.q], moments: [...figure.moments()], off };
}

export const figures = {
  poseTo(_: Context, q: number[]): Pose {
    poser().setQ(new Float64Array(q));
    return now(0);
  },
  poseAnatomy: (_: Context): Anatomy => JSON.parse(poser().anatomy()),
  posePoint: (_: Context, link: number, place: number[]): number[] => [...poser().inLink(link, place[0], place[1], place[2])],
  poseDrag(_: Context, link: number, point: number[], place: number[], reach: number): Pose {
    return now(poser().drag(link, new Float64Array(point), new Float64Array(place), reach));
  },
};
