// Quantities of a motion over its frames, by name; strides; places of points.

import type * as Three from 'three';
import { three, view, type Clock, type Data, type Frame } from './view.ts';

export interface Quantity {
  // Unique, and the same for the same quantity of another motion.
  name: string;
  unit: string;
  values: ArrayLike<number>;
}

// A point of a link, in the link's frame.
export interface Spot {
  link: string;
  at: Three.Vector3;
}

const sided = (label: string, side: string, many: boolean): string => (many && side !== 'middle' ? `${label}, ${side}` : label);

// All curves of a page's data, and velocities of what turns and slides.
export function quantities(data: Data): Quantity[] {
  const found: Quantity[] = [];
  for (const { label, position, effort, power } of data.joints) {
    const add = (kind: string, quantity: typeof position, from = quantity): void => {
      for (const { side, values } of quantity?.lines ?? []) {
        found.push({ name: `${sided(label, side, (from?.lines.length ?? 0) > 1)}${kind}`, unit: quantity!.unit, values });
      }
    };
    add('', position);
    for (const { side, values } of position?.lines ?? []) {
      found.push({ name: `${sided(label, side, position!.lines.length > 1)}: velocity`, unit: `${position!.unit}/s`, values: slope(data.time, values) });
    }
    add(effort?.unit.startsWith('N/') ? ': force' : ': moment', effort);
    add(': power', power);
  }
  for (const { label, unit, lines } of data.forces) {
    for (const { side, values } of lines) found.push({ name: sided(label, side, lines.length > 1), unit, values });
  }
  return found;
}

// By central differences.
export function slope(time: ArrayLike<number>, values: ArrayLike<number>): Float32Array {
  const last = values.length - 1;
  return Float32Array.from(values, (_, i) => {
    const [a, b] = [Math.max(0, i - 1), Math.min(last, i + 1)];
    return b > a ? (values[b] - values[a]) / (time[b] - time[a]) : 0;
  });
}

// Where a foot begins to bear: this share of the weight.
const BEARS = 0.05;

export interface Stride {
  from: number;
  to: number;
  side: string;
  // How fast it goes, over the root of gravity times the leg's length; null where the foot does not bear.
  speed: number | null;
}

// The middle one of all strides of a foot, from one strike to the next (s), of a foot of this side where one strikes twice; null where none does.
export function stride(data: Data, side: string): Stride | null {
  const feet = [...data.feet].sort((a, b) => Number(b.side === side) - Number(a.side === side));
  for (const { force, link, side, weight } of feet) {
    const size = (frame: number): number => Math.hypot(force[3 * frame], force[3 * frame + 1], force[3 * frame + 2]);
    const frames = data.time.length;
    let peak = 0;
    for (let i = 0; i < frames; i += 1) peak = Math.max(peak, size(i));
    const least = BEARS * (weight ?? data.weight ?? peak);
    const strikes: number[] = [];
    for (let i = 1; i < frames; i += 1) if (size(i) > least && size(i - 1) <= least) strikes.push(i);
    if (strikes.length < 2) continue;
    const middle = Math.floor((strikes.length - 2) / 2);
    const [first, last] = [strikes[middle], strikes[middle + 1]];
    return { from: data.time[first], to: data.time[last], side, speed: speed(data, link, (i) => i >= first && i < last && size(i) > least) };
  }
  return null;
}

// Gravity (m/s²).
const GRAVITY = 9.81;

// How fast the root goes over a foot that bears. A flat foot goes as the ground does, on a treadmill too; while it rolls it is slower against the root:
// the speed that three of four frames do not exceed. The leg is as long as the foot is ever below the root.
function speed(data: Data, link: string, bears: (frame: number) => boolean): number | null {
  const at = data.links.findIndex(({ name }) => name === link);
  if (at < 0) return null;
  const place = (frame: number, axis: number): number => data.positions[3 * (frame * data.links.length + at) + axis];
  const speeds: number[] = [];
  let leg = 0;
  for (let i = 0; i + 1 < data.time.length; i += 1) {
    leg = Math.max(leg, -place(i, 1));
    if (bears(i)) speeds.push(Math.hypot(place(i + 1, 0) - place(i, 0), place(i + 1, 2) - place(i, 2)) / (data.time[i + 1] - data.time[i]));
  }
  speeds.sort((a, b) => a - b);
  return leg > 0 && speeds.length > 0 ? speeds[Math.floor(0.75 * speeds.length)] / Math.sqrt(GRAVITY * leg) : null;
}

// A value between frames.
export function valueAt(values: ArrayLike<number>, { index, next, fraction }: Frame): number {
  return values[index] + (values[next] - values[index]) * fraction;
}

// Where a point of a link is (m, in the data's own coordinates); null where the figure has no such link.
export function placeOf(data: Data, { link, at }: Spot, frame: Frame, out: Three.Vector3): Three.Vector3 | null {
  const index = data.links.findIndex(({ name }) => name === link);
  if (index < 0) return null;
  const count = data.links.length;
  const [turn, next] = [frame.index, frame.next].map((which) => new three.Quaternion().fromArray(data.turns as unknown as number[], 4 * (which * count + index)));
  for (const part of ['x', 'y', 'z', 'w'] as const) turn[part] += (next[part] - turn[part]) * frame.fraction;
  out.copy(at).applyQuaternion(turn.normalize());
  const place = new three.Vector3();
  for (let axis = 0; axis < 3; axis += 1) {
    const [a, b] = [frame.index, frame.next].map((which) => data.root[3 * which + axis] + data.positions[3 * (which * count + index) + axis]);
    place.setComponent(axis, a + (b - a) * frame.fraction);
  }
  return out.add(place);
}

export const frameAt = (index: number): Frame => ({ index, next: index, fraction: 0 });

// The distance of two points over all frames (m).
export function distances(data: Data, [a, b]: Spot[]): Float32Array | null {
  const [from, to] = [new three.Vector3(), new three.Vector3()];
  const out = new Float32Array(data.time.length);
  for (let i = 0; i < out.length; i += 1) {
    if (!placeOf(data, a, frameAt(i), from) || !placeOf(data, b, frameAt(i), to)) return null;
    out[i] = from.distanceTo(to);
  }
  return out;
}

// A clock of another motion that goes with one: second by second, or from its beginning to its end in the same share.
export function follow(data: Data, clock: Clock): (by: 'time' | 'share') => Frame {
  const own = view.makeClock(data.time);
  return (by) => {
    const gone = clock.time() - clock.first;
    const length = clock.last - clock.first;
    own.seek(own.first + (by === 'time' ? gone : length > 0 ? (gone / length) * (own.last - own.first) : 0));
    return own.frame();
  };
}
