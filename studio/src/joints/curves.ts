// Curves of one degree of freedom that go through points: what the editor of curves shows and writes.

import { plain, position, scalar, type Node } from './ron.ts';

export interface Curve {
  kind: string;
  // Time (s) and position (rad, m) or force (N m, N).
  keys: [number, number][];
  // What else the text says of it.
  rest: Map<string, string>;
}

// With the fields that a kind may have beside its points; `keyed`: any number of points, else a beginning and an end.
export const CURVES: Record<string, { label: string; keyed: boolean; rest: string[] }> = {
  MonotoneCubic: { label: 'turns at points only', keyed: true, rest: [] },
  CatmullRom: { label: 'Catmull-Rom', keyed: true, rest: [] },
  Centripetal: { label: 'centripetal', keyed: true, rest: [] },
  NaturalSpline: { label: 'natural spline', keyed: true, rest: [] },
  ClampedSpline: { label: 'clamped spline', keyed: true, rest: ['start_velocity', 'end_velocity'] },
  KochanekBartels: { label: 'Kochanek-Bartels', keyed: true, rest: ['tension', 'continuity', 'bias', 'start_velocity', 'end_velocity'] },
  MinimumJerk: { label: 'least jerk', keyed: false, rest: [] },
  Trigonometric: { label: 'half a cosine', keyed: false, rest: [] },
  CubicHermite: { label: 'cubic', keyed: false, rest: ['start_velocity', 'end_velocity'] },
  Quintic: { label: 'quintic', keyed: false, rest: ['start_velocity', 'end_velocity', 'start_acceleration', 'end_acceleration'] },
  Line: { label: 'line', keyed: false, rest: [] },
};

export const isCurve = (name: string | undefined): boolean => name !== undefined && name in CURVES;

// Null where it says more than the editor shows.
export function readCurve(node: Node, said: (of: Node) => string): Curve | null {
  const kind = node.name!;
  const { keyed, rest } = CURVES[kind];
  const fields = node.fields ?? new Map<string, Node>();
  const own = keyed ? ['keys'] : ['from', 'to', 'duration'];
  if (![...fields.keys()].every((name) => own.includes(name) || rest.includes(name))) return null;
  const pairs = keyed
    ? (fields.get('keys')?.items ?? []).map(({ items }) => [scalar(items?.[0]), scalar(items?.[1])])
    : [[0, scalar(fields.get('from'))], [scalar(fields.get('duration')), scalar(fields.get('to'))]];
  if (pairs.length < 2 || !pairs.flat().every((value) => value !== null)) return null;
  const others = [...fields].filter(([name]) => rest.includes(name));
  return { kind, keys: pairs as [number, number][], rest: new Map(others.map(([name, value]) => [name, said(value)])) };
}

export function writeCurve({ kind, keys, rest }: Curve, turns: boolean): string {
  const others = [...rest].filter(([name]) => CURVES[kind].rest.includes(name)).map(([name, value]) => `, ${name}: ${value}`);
  if (CURVES[kind].keyed) {
    const points = keys.map(([time, value]) => `(${plain(time)}, ${position(value, turns)})`);
    return `${kind}(keys: [${points.join(', ')}]${others.join('')})`;
  }
  const [[, from], [duration, to]] = [keys[0], keys.at(-1)!];
  return `${kind}(from: ${position(from, turns)}, to: ${position(to, turns)}, duration: ${plain(duration)}${others.join('')})`;
}

// The same points as another kind; what only knows its ends keeps these.
export function asKind({ keys, rest }: Curve, kind: string): Curve {
  const begins = keys[0][0];
  const kept: [number, number][] = CURVES[kind].keyed ? keys : [[0, keys[0][1]], [keys.at(-1)![0] - begins, keys.at(-1)![1]]];
  return { kind, keys: kept, rest };
}
