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

// The middle one of all strides of a foot, from one strike to the next (s); null where no foot strikes twice.
export function stride(data: Data): [number, number] | null {
  for (const { force } of data.feet) {
    const size = (frame: number): number => Math.hypot(force[3 * frame], force[3 * frame + 1], force[3 * frame + 2]);
    const frames = data.time.length;
    let peak = 0;
    for (let i = 0; i < frames; i += 1) peak = Math.max(peak, size(i));
    const least = BEARS * (data.weight ?? peak);
    const strikes: number[] = [];
    for (let i = 1; i < frames; i += 1) if (size(i) > least && size(i - 1) <= least) strikes.push(data.time[i]);
    if (strikes.length < 2) continue;
    const middle = Math.floor((strikes.length - 2) / 2);
    return [strikes[middle], strikes[middle + 1]];
  }
  return null;
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
