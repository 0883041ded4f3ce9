// Scenes: their text while it is written, and what comes of it.

import { Script, completeScene, curve, type Alive } from '../../dist/engine/engine.js';
import { pose } from './figures.ts';
import { shelf } from './files.ts';
import { keep } from './motions.ts';
import type { PosedFigure, SceneOutline, ShownMotion, TextFault } from './protocol.ts';
import type { Context } from './worker.ts';

// The last text that was read.
let script: Script | null = null;
let text = '';
let alive: Alive | null = null;
const snapshots: Alive[] = [];
// The most snapshots that are kept: five seconds at sixty a second would be 300.
const SNAPSHOTS = 600;

function read(next: string): Script {
  if (!script || next !== text) {
    script?.free();
    script = new Script(next, shelf());
    text = next;
  }
  return script;
}

export interface Checked {
  faults: TextFault[];
  outline: SceneOutline | null;
}

export interface RanScene extends ShownMotion {
  report: Record<string, never>;
  remarks: string[];
}

export interface AliveFrame {
  poses: Float32Array;
  time: number;
  // Of motion, of height and springs, and all (J).
  energy: number[];
  // A link, its force (N) and centre of pressure (m), seven numbers each.
  contacts: number[];
  q: number[];
  // Of the joints (nv; N m, N).
  forces: number[];
  // Of the pull (N), where there is one.
  pull?: number[];
}

// A point of a link (m, in its frame) that is drawn to a place of the picture (m) by a spring (N/m).
export interface Pull {
  link: number;
  point: number[];
  place: number[];
  stiffness: number;
}

// A pull is found anew in such steps (s), and lags behind by so much (s): that is its damper.
const PULL_STEP = 1 / 240;
const PULL_LAG = 0.1;
// Where the point was that is pulled.
let pulled: { link: number; at: number[] } | null = null;

// Goes on under a pull, and gives its force (N).
function stepPulled(dt: number, { link, point, place, stiffness }: Pull): number[] {
  const parts = Math.max(1, Math.round(dt / PULL_STEP));
  const h = dt / parts;
  let force = [0, 0, 0];
  let speed = [0, 0, 0];
  for (let part = 0; part < parts; part += 1) {
    const to = place.map((x, axis) => x - PULL_LAG * speed[axis]);
    force = [...running().pull(link, new Float64Array(point), new Float64Array(to), stiffness)];
    const at = to.map((x, axis) => x - force[axis] / stiffness);
    const before = pulled?.link === link ? pulled.at : at;
    running().step(h);
    speed = at.map((x, axis) => (x - before[axis]) / h);
    pulled = { link, at };
  }
  return force;
}

const running = (): Alive => {
  if (!alive) throw new Error('nothing is simulated; begin anew');
  return alive;
};

function frame(): AliveFrame {
  const now = running();
  return {
    poses: now.poses(),
    time: now.time,
    energy: [...now.energy()],
    contacts: [...now.contacts()],
    q: [...now.q],
    forces: [...now.forces()],
  };
}

export const scenes = {
  checkScene(_: Context, source: string): Checked {
    const found = read(source);
    const faults = JSON.parse(found.faults()) as TextFault[];
    return { faults, outline: found.isWhole ? (JSON.parse(found.outline()) as SceneOutline) : null };
  },
  // Another value at each path, one after the other; null takes it away.
  editScene(_: Context, source: string, edits: { path: string[]; value: string | null }[]): string {
    let now = source;
    for (const { path, value } of edits) now = read(now).edit(path, value ?? undefined);
    return now;
  },
  completeScene: (_: Context, source: string, at: number): { from: number; to: number; items: { label: string; insert: string; detail: string }[] } =>
    JSON.parse(completeScene(source, at, shelf())),
  poseScene: (_: Context, source: string): PosedFigure => pose(read(source).posed()),
  runScene({ tell }: Context, source: string): RanScene {
    const ran = read(source).run((share: number, words: string | null) => tell(share, words));
    const shown = { report: JSON.parse(ran.report), remarks: [...ran.remarks], ...keep(ran.shown()) };
    ran.free();
    return shown;
  },
  // The page of error against run time.
  studyScene: ({ tell }: Context, source: string): string =>
    read(source).study(
      () => performance.now() / 1000,
      (share: number) => tell(share, null),
      (page: string) => tell(null, null, page),
    ),
  // A simulation that goes on frame by frame.
  startScene(_: Context, source: string): { data: string } {
    alive?.free();
    // What cannot begin leaves nothing.
    alive = null;
    snapshots.splice(0).forEach((old) => old.free());
    alive = read(source).alive();
    return { data: alive.data() };
  },
  aliveFrame(_: Context, dt: number, pull?: Pull): AliveFrame {
    snapshots.push(running().copy());
    if (snapshots.length > SNAPSHOTS) snapshots.shift()?.free();
    const force = pull ? stepPulled(dt, pull) : undefined;
    if (!pull) running().step(dt);
    return { ...frame(), pull: force };
  },
  // Back to how it was so many frames ago.
  aliveBack(_: Context, frames: number): AliveFrame {
    for (let i = 0; i < frames && snapshots.length > 0; i += 1) {
      alive?.free();
      alive = snapshots.pop() ?? null;
    }
    return frame();
  },
  alivePoint: (_: Context, link: number, place: number[]): number[] => [...running().inLink(link, place[0], place[1], place[2])],
  alivePull: (_: Context, link: number, point: number[], place: number[], stiffness: number): number[] => [
    ...running().pull(link, new Float64Array(point), new Float64Array(place), stiffness),
  ],
  aliveLetGo(_: Context): void {
    pulled = null;
    running().letGo();
  },
  aliveTarget: (_: Context, dof: number, to: number): void => running().setTarget(dof, to),
  aliveForce: (_: Context, dof: number, force: number): void => running().setForce(dof, force),
  curve: (_: Context, source: string, samples: number): unknown => JSON.parse(curve(source, samples)),
};
