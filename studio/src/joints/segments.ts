// The drives of a degree of freedom, one after the other, as the panel knows them; what is more than that stays text.

import type { Dof } from '../engine/protocol.ts';
import { isCurve, readCurve, writeCurve, type Curve } from './curves.ts';
import { parse, plain, position, quote, scalar, type Node } from './ron.ts';

export type Unit = 'position' | 'velocity' | 'acceleration' | 'time' | 'stiffness' | 'damping' | 'force' | 'number' | 'phase';

export interface FieldKind {
  name: string;
  label: string;
  unit: Unit;
  // What it may be, where it is no number.
  choices?: string[];
  // It may be left out.
  optional?: boolean;
}

export interface Kind {
  label: string;
  fields: FieldKind[];
}

const to: FieldKind = { name: 'to', label: 'To', unit: 'position' };
const over: FieldKind = { name: 'over', label: 'Over', unit: 'time' };
const rates: FieldKind[] = [
  { name: 'velocity', label: 'Velocity there', unit: 'velocity', optional: true },
  { name: 'acceleration', label: 'Acceleration there', unit: 'acceleration', optional: true },
];
const limit: FieldKind = { name: 'limit', label: 'Greatest force', unit: 'force', optional: true };
const choice = (name: string, label: string, ...choices: string[]): FieldKind => ({ name, label, unit: 'number', choices, optional: true });

export const KINDS: Record<string, Kind> = {
  Frozen: { label: 'Frozen', fields: [] },
  Free: { label: 'Free', fields: [] },
  Wait: { label: 'Wait', fields: [{ name: 'for', label: 'For', unit: 'time' }] },
  Move: { label: 'Move', fields: [to, over, choice('by', 'By', 'MinimumJerk', 'Cubic')] },
  Servo: {
    label: 'Spring, servo',
    fields: [to, { name: 'stiffness', label: 'Stiffness', unit: 'stiffness' }, { name: 'damping', label: 'Damping', unit: 'damping', optional: true }, limit],
  },
  Curve: { label: 'Along a curve', fields: [] },
  Sine: {
    label: 'Sine',
    fields: [
      { name: 'amplitude', label: 'Amplitude', unit: 'position' },
      { name: 'period', label: 'Period', unit: 'time' },
      { name: 'cycles', label: 'Cycles', unit: 'number', optional: true },
      { name: 'phase', label: 'Phase', unit: 'phase', optional: true },
      { name: 'offset', label: 'Offset', unit: 'position', optional: true },
    ],
  },
  TargetAngle: { label: 'Target angle', fields: [to, ...rates] },
  TimeOriented: { label: 'Time oriented', fields: [to, over, ...rates] },
  AccelerateDecelerate: { label: 'Accelerate, decelerate', fields: [to, choice('by', 'By', 'BangBang', 'HalfCosine', 'FullSine'), ...rates] },
  FreeStyle: { label: 'Free style', fields: [{ ...to, optional: true }, { name: 'for', label: 'For', unit: 'time' }, ...rates] },
  Intensive: { label: 'Intensive', fields: [to, over, choice('law', 'Law', 'Quintic', 'Cubic', 'Literal'), limit, ...rates] },
  Torque: { label: 'Constant torque', fields: [{ name: 'force', label: 'Torque', unit: 'force' }, { name: 'for', label: 'For', unit: 'time' }] },
  TorqueCurve: { label: 'Curved torque', fields: [] },
};

export type Until =
  | { kind: 'At' | 'Lasting'; time: number }
  | { kind: 'Passes' | 'PassesSpeed'; name: string; value: number; text: string };

export interface Segment {
  // Null: more than the panel knows.
  kind: string | null;
  // As it stands in the scene.
  text: string;
  // Of its fields, as they stand.
  values: Map<string, string>;
  curve: Curve | null;
  until: Until | null;
}

function readUntil(node: Node, text: string): Until | null | undefined {
  const [first, second] = node.items ?? [];
  if (node.name === 'Done') return null;
  if ((node.name === 'At' || node.name === 'Lasting') && first?.number !== undefined) return { kind: node.name, time: first.number };
  const value = scalar(second);
  if ((node.name === 'Passes' || node.name === 'PassesSpeed') && first?.text !== undefined && value !== null) {
    return { kind: node.name, name: first.text, value, text: text.slice(second.from, second.to) };
  }
  return undefined;
}

function readOne(node: Node, text: string): Segment {
  const said = (of: Node): string => text.slice(of.from, of.to);
  const unknown: Segment = { kind: null, text: said(node), values: new Map(), curve: null, until: null };
  const until = node.fields?.get('until');
  const found = until ? readUntil(until, text) : null;
  if (found === undefined) return unknown;
  const known = { ...unknown, until: found };
  const name = node.name ?? '';
  if (name === 'Wait' && node.items?.length === 1) return { ...known, kind: 'Wait', values: new Map([['for', said(node.items[0])]]) };
  const wraps = name === 'Kinematic' || name === 'Torque';
  const inner = wraps ? (node.items?.[0] ?? node.fields?.get('along')) : node;
  if (inner && (isCurve(inner.name) || inner.name === 'Sine') && (wraps || !until)) {
    if (inner.name === 'Sine') return name === 'Torque' ? unknown : { ...known, kind: 'Sine', values: fieldsOf(inner, said) };
    const curve = readCurve(inner, said);
    if (!curve) return unknown;
    const [first, last] = [curve.keys[0], curve.keys.at(-1)!];
    if (name === 'Torque' && curve.kind === 'Line' && first[1] === last[1]) {
      return { ...known, kind: 'Torque', values: new Map([['force', plain(last[1])], ['for', plain(last[0])]]) };
    }
    return { ...known, kind: name === 'Torque' ? 'TorqueCurve' : 'Curve', curve };
  }
  const kind = KINDS[name];
  if (!kind || node.items?.length || wraps || name === 'Wait') return unknown;
  const values = fieldsOf(node, said);
  values.delete('until');
  return [...values.keys()].every((one) => kind.fields.some((of) => of.name === one)) ? { ...known, kind: name, values } : unknown;
}

const fieldsOf = (node: Node, said: (of: Node) => string): Map<string, string> => new Map([...(node.fields ?? [])].map(([name, value]) => [name, said(value)]));

// The drives of a text: one, or a list of them.
export function readSegments(text: string): Segment[] {
  const node = parse(text);
  if (!node) return [{ kind: null, text, values: new Map(), curve: null, until: null }];
  return node.list ? node.items!.map((item) => readOne(item, text)) : [readOne(node, text)];
}

const writeUntil = (until: Until): string =>
  'time' in until ? `${until.kind}(${plain(until.time)})` : `${until.kind}(${quote(until.name)}, ${until.text})`;

function writeSegment({ kind, text, values, curve, until }: Segment, turns: boolean): string {
  if (!kind) return text;
  const end = until ? `until: ${writeUntil(until)}` : '';
  const along = (head: string, of: string): string => (end ? `${head}(along: ${of}, ${end})` : `${head}(${of})`);
  const fields = [...values].map(([name, value]) => `${name}: ${value}`);
  if (kind === 'Wait') return `Wait(${values.get('for')})`;
  if (kind === 'Curve') return along('Kinematic', writeCurve(curve!, turns));
  if (kind === 'TorqueCurve') return along('Torque', writeCurve(curve!, false));
  if (kind === 'Torque') return along('Torque', `Line(from: ${values.get('force')}, to: ${values.get('force')}, duration: ${values.get('for')})`);
  if (kind === 'Sine') return end ? along('Kinematic', `Sine(${fields.join(', ')})`) : `Sine(${fields.join(', ')})`;
  const all = [...fields, ...(end ? [end] : [])];
  return all.length > 0 ? `${kind}(${all.join(', ')})` : kind;
}

// Written anew; the others stay as they stand in the text.
export const renewed = (segment: Segment, turns: boolean): Segment => ({ ...segment, text: writeSegment(segment, turns) });

export const joined = (segments: Segment[]): string => (segments.length === 1 ? segments[0].text : `[${segments.map(({ text }) => text).join(', ')}]`);

// How long it lasts where that is known before the run (s), from `start` on.
export function lasts({ kind, values, curve, until }: Segment, start: number): number | null {
  const number = (name: string): number | null => scalar(parse(values.get(name) ?? '') ?? undefined);
  if (until?.kind === 'Lasting') return until.time;
  if (until?.kind === 'At') return Math.max(0, until.time - start);
  if (until) return null;
  if (kind === 'Sine') {
    const cycles = number('cycles');
    return cycles === null ? null : cycles * (number('period') ?? 0);
  }
  if (curve) return curve.keys.at(-1)![0];
  return number('over') ?? number('for');
}

// A drive of a kind to begin with, of a degree of freedom that is at `at`.
export function fresh(kind: string, dof: Dof, at: number, left: number): Segment {
  const turns = dof.turns;
  const way = turns ? Math.PI / 6 : 0.1;
  // Towards where there is more room, and not beyond it.
  const [above, below] = [(dof.upper ?? Infinity) - at, at - (dof.lower ?? -Infinity)];
  const gone = above >= Math.min(way, below) ? Math.min(way, Math.max(0, above)) : -Math.min(way, Math.max(0, below));
  const goal = position(at + gone, turns);
  const time = plain(Math.max(0.1, Math.min(1, left)));
  const texts: Record<string, string> = {
    to: goal,
    over: time,
    for: time,
    stiffness: turns ? '100.0' : '2000.0',
    damping: turns ? '10.0' : '200.0',
    amplitude: position(gone, turns),
    period: time,
    offset: position(at, turns),
    force: '1.0',
  };
  const given = KINDS[kind].fields.filter(({ name, optional }) => !optional || ['damping', 'offset'].includes(name));
  const values = new Map(given.map(({ name }) => [name, texts[name]]));
  const end = Math.max(0.2, Math.min(2, left));
  const keys: [number, number][] =
    kind === 'TorqueCurve' ? [[0, 0], [end / 2, 1], [end, 0]] : [[0, at], [end / 2, at + gone], [end, at]];
  const curve: Curve | null = kind === 'Curve' || kind === 'TorqueCurve' ? { kind: 'MonotoneCubic', keys, rest: new Map() } : null;
  return renewed({ kind, text: '', values, curve, until: null }, turns);
}
