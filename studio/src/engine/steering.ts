// Somebody who is steered.

import { Steered, Walker } from '../../dist/engine/engine.js';
import type { Who } from './protocol.ts';
import { human } from './walks.ts';
import type { Context } from './worker.ts';

export type Steer =
  | { kind: 'stop' }
  | { kind: 'go'; left: number; forward: number; heading?: number }
  | { kind: 'to'; x: number; z: number; speed: number };

export interface SteeredFrame {
  poses: Float32Array;
  // Force (N) and centre of pressure (m).
  ground: Float64Array;
  // Where (x, z; m), which way it faces (rad), with which velocity it goes (x, z; m/s).
  place: ArrayLike<number>;
  heading: number;
  velocity: ArrayLike<number>;
  stands: boolean;
  bent: string[];
  // Of the pull (N), where there is one.
  pull?: number[];
}

// A point of a link (m, in its frame) that is drawn to a place of the picture (m) by a spring (N/m), up to a force (N).
export interface SteerPull {
  link: number;
  point: number[];
  place: number[];
  stiffness: number;
  most: number;
}

let steered: { walker: Walker; drawn: Steered } | null = null;

function walking(): { walker: Walker; drawn: Steered } {
  if (!steered) throw new Error('nobody is steered; begin anew');
  return steered;
}

export const steering = {
  // Somebody else, who stands; gives what a page holds of it, without the skin.
  steer(_: Context, who: Who): string {
    steered?.walker.free();
    steered?.drawn.free();
    steered = null;
    const figure = human(who);
    try {
      steered = { walker: new Walker(figure), drawn: new Steered(figure) };
      return steered.drawn.data(steered.walker);
    } finally {
      figure.free();
    }
  },
  steerBy(_: Context, command: Steer): void {
    const { walker } = walking();
    if (command.kind === 'stop') walker.stop();
    else if (command.kind === 'to') walker.goTo(command.x, command.z, command.speed);
    else walker.goOwn(command.left, command.forward);
    if (command.kind === 'go' && command.heading !== undefined) walker.face(command.heading);
  },
  // Lets a joint hang loose, or takes it back.
  loosen: (_: Context, joint: string, loose: boolean): void => walking().walker.loosen(joint, loose),
  steerPoint: (_: Context, link: number, place: number[]): number[] => [...walking().drawn.inLink(walking().walker, link, place[0], place[1], place[2])],
  steerFrame(_: Context, dt: number, held?: SteerPull): SteeredFrame {
    const { walker, drawn } = walking();
    const pull = held && [...drawn.pull(walker, held.link, new Float64Array(held.point), new Float64Array(held.place), held.stiffness, held.most)];
    if (!held) walker.letGo();
    walker.step(dt);
    return {
      pull,
      poses: drawn.poses(walker),
      ground: drawn.ground(walker),
      place: walker.place,
      heading: walker.heading,
      velocity: walker.velocity,
      stands: walker.isStanding,
      bent: walker.bent(),
    };
  },
};
