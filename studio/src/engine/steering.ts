// Somebody who is steered.

import { Steered } from '../../dist/engine/engine.js';
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
  // x, z, heading, vx, vz, stands, centre of mass.
  state: Float64Array;
  bent: string[];
}

let steered: Steered | null = null;

function walker(): Steered {
  if (!steered) throw new Error('nobody is steered; begin anew');
  return steered;
}

export const steering = {
  steer(_: Context, who: Who): string {
    steered?.free();
    steered = null;
    const figure = human(who);
    steered = new Steered(figure);
    figure.free();
    return steered.data();
  },
  steerBy(_: Context, command: Steer): void {
    const walking = walker();
    if (command.kind === 'stop') walking.stop();
    else if (command.kind === 'to') walking.goTo(command.x, command.z, command.speed);
    else walking.goOwn(command.left, command.forward);
    if (command.kind === 'go' && command.heading !== undefined) walking.face(command.heading);
  },
  // Lets a joint hang loose, or takes it back.
  loosen: (_: Context, joint: string, loose: boolean): void => walker().loosen(joint, loose),
  steerFrame(_: Context, dt: number): SteeredFrame {
    const walking = walker();
    const poses = walking.step(dt);
    return { poses, ground: walking.ground(), state: walking.state(), bent: walking.bent() };
  },
};
