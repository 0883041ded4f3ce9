// The report of a run as people read it: the rows that `solaris run` prints.

import type { Row, SceneOutline } from '../engine/protocol.ts';
import { some } from './outline.ts';

interface Energy {
  kinetic: number;
  in_gravity: number;
  in_springs: number;
  total: number;
}

interface Outcome {
  dof: string;
  drive: string;
  start_s: number;
  end_s: number;
  result: string;
  position: number;
  velocity: number;
  missed_by: number | null;
  acceleration: number | null;
}

interface Impact {
  time_s: number;
  dof: string;
  what: string;
  velocity_before: number;
  velocity_after: number;
  impulse: number;
  loss_j: number;
}

interface Touch {
  link: string;
  depth_m: number;
  depth_time_s: number;
  slip_m_s: number;
  slip_time_s: number;
  slid_m: number;
}

interface Pair {
  links: string[];
  force_n: number;
  force_time_s: number;
}

export interface RunReport {
  method: string;
  why: string;
  error: { position: number; velocity: number } | null;
  cost: { evaluations: number; jacobians: number; steps: number; rejected_steps: number; events: number };
  energy: {
    start: Energy;
    end: Energy;
    work_of_drives: number;
    work_of_pushes?: number;
    heat: number;
    lost_in_impacts: number;
    moved: number;
    imbalance: number;
    at_play: number;
  };
  drives: Outcome[];
  impacts: Impact[];
  contact?: { impulse_n_s: number[]; damping_j: number; friction_j: number; links: Touch[]; landings?: { time_s: number; links: string[] }[] };
  collisions?: (Pair & { depth_m: number; depth_time_s: number })[];
  loops?: (Pair & { apart_m: number; apart_time_s: number })[];
}

// The most drives, impacts and names that are listed.
const [MANY, FEW, NAMES] = [12, 3, 8];

// Four digits that count.
export function digits(value: number): string {
  const size = Math.abs(value);
  if (size < 5e-13) return '0';
  const text = size < 1e-3 || size >= 1e6 ? value.toExponential(2) : String(Number(value.toPrecision(4)));
  return text.replace('e+', 'e').replaceAll('-', '−');
}

const power = (value: number): string => value.toExponential(1).replace('e+', 'e').replaceAll('-', '−');
const most = <T>(all: T[] | undefined, of: (one: T) => number): T | undefined =>
  all?.reduce<T | undefined>((best, one) => (best && of(best) >= of(one) ? best : one), undefined);
const at = (who: string, time: number): string => `${who}, at ${time.toFixed(3)} s`;

export function reportRows(report: RunReport, remarks: string[], outline: SceneOutline | null, seconds: number): Row[] {
  const rows: Row[] = [];
  const add = (label: string, value: string, unit = '', note = ''): void => void rows.push({ label, value, unit, note });
  const say = (label: string, note: string): void => add(label, '', '', note);
  const dofs = new Map(outline?.joints.flatMap((joint) => joint.dofs).map((dof) => [dof.name, dof]));
  const turns = (name: string): boolean => dofs.get(name)?.turns ?? true;
  const amount = (name: string, value: number): string => (turns(name) ? `${digits((value * 180) / Math.PI)}°` : `${digits(value)} m`);
  const rate = (name: string, value: number): string => (turns(name) ? `${digits((value * 180) / Math.PI)}°/s` : `${digits(value)} m/s`);

  say('Method', report.method);
  if (report.why) say('Because', report.why);
  if (report.error) {
    add('Error of positions', power(report.error.position), 'rad or m', 'at most, as far as can be told');
    add('Error of velocities', power(report.error.velocity), 'rad/s or m/s');
  }
  const { evaluations, steps, rejected_steps, jacobians, events } = report.cost;
  if (evaluations > 0) {
    const beside = [[rejected_steps, 'rejected'], [jacobians, 'Jacobians'], [events, 'events']].filter(([count]) => count);
    add('Steps', String(steps), '', beside.map((words) => words.join(' ')).join(', '));
    add('Evaluations', String(evaluations));
  }
  add('Run time', digits(seconds), 's', 'with all that was tried, in this browser');
  energyRows(report, add);

  const { contact } = report;
  if (contact && contact.links.length === 0) say('Touched the ground', 'nothing');
  else if (contact) {
    const [deepest, fastest, farthest] = [
      most(contact.links, (touch) => touch.depth_m)!,
      most(contact.links, (touch) => touch.slip_m_s)!,
      most(contact.links, (touch) => touch.slid_m)!,
    ];
    add('Touched the ground', String(contact.links.length), 'links', some(contact.links.map(({ link }) => link), FEW));
    add('Deepest', digits(1e3 * deepest.depth_m), 'mm', at(deepest.link, deepest.depth_time_s));
    add('Fastest slip', digits(fastest.slip_m_s), 'm/s', at(fastest.link, fastest.slip_time_s));
    add('Slid farthest', digits(farthest.slid_m), 'm', farthest.link);
    if (contact.damping_j !== 0 || contact.friction_j !== 0) add('Lost in contact', digits(contact.damping_j + contact.friction_j), 'J', `to friction ${digits(contact.friction_j)}`);
    const first = contact.landings?.[0];
    if (first) add('Came down', String(contact.landings!.length), 'times', at(first.links.join(', '), first.time_s));
  }
  const names = (pair: Pair): string => pair.links.join(' and ');
  const [hardest, loosest] = [most(report.collisions, (pair) => pair.force_n), most(report.loops, (pair) => pair.apart_m)];
  if (hardest) {
    add('Links touched each other', String(report.collisions!.length), 'pairs', some(report.collisions!.map(names), FEW));
    add('Hardest', digits(hardest.force_n), 'N', at(names(hardest), hardest.force_time_s));
    const deepest = most(report.collisions, (pair) => pair.depth_m)!;
    add('Deepest in each other', digits(1e3 * deepest.depth_m), 'mm', at(names(deepest), deepest.depth_time_s));
  }
  if (loosest) {
    add('Loops come apart by', digits(1e3 * loosest.apart_m), 'mm', at(names(loosest), loosest.apart_time_s));
    const strongest = most(report.loops, (pair) => pair.force_n)!;
    add('And take at most', digits(strongest.force_n), 'N', at(names(strongest), strongest.force_time_s));
  }

  for (const [words, group] of grouped(report.drives)) {
    const [{ drive, result, missed_by, acceleration }] = group;
    const each = group.length > FEW ? [] : group;
    if (each.length === 0) say('Drive', `${words}${drive}: ${result}; ${some(group.map(({ dof }) => dof), NAMES)}`);
    for (const { dof, position, velocity } of each) {
      const place = dofs.get(dof)?.coordinate === null ? '' : ` at ${amount(dof, position)}`;
      const more = [
        result === 'reached with velocity' ? `with ${rate(dof, velocity)}` : '',
        missed_by === null ? '' : `by ${amount(dof, missed_by)}`,
        result === 'wrong sign' && acceleration !== null ? `its force accelerates it away: ${rate(dof, acceleration)}²` : '',
      ].filter(Boolean);
      say('Drive', `${words}${dof}, ${drive}: ${result}${place}${more.length > 0 ? `, ${more.join(', ')}` : ''}`);
    }
  }
  for (const { time_s, dof, what, velocity_before, velocity_after, impulse, loss_j } of report.impacts.slice(0, MANY)) {
    const unit = turns(dof) ? 'N m s' : 'N s';
    say('Impact', `${time_s.toFixed(3)} s: ${dof} (${what}) ${rate(dof, velocity_before)} to ${rate(dof, velocity_after)}, ${digits(impulse)} ${unit}; ${digits(loss_j)} J lost`);
  }
  if (report.impacts.length > MANY) say('Impact', `and ${report.impacts.length - MANY} more`);
  remarks.forEach((remark) => say('Note', remark));
  return rows;
}

// Where the energy went.
function energyRows({ energy }: RunReport, add: (label: string, value: string, unit: string, note?: string) => void): void {
  const { at_play: scale } = energy;
  if (!(scale > 0)) return;
  // What rounding leaves of nothing.
  const least = 1e-9 * scale;
  const parts = ({ kinetic, in_gravity, in_springs }: Energy): string =>
    Object.entries({ 'of motion': kinetic, 'in gravity': in_gravity, 'in springs': in_springs })
      .filter(([, value]) => Math.abs(value) > least)
      .map(([name, value]) => `${name} ${digits(value)}`)
      .join(', ');
  const row = (label: string, value: number, note = ''): void => add(label, digits(Math.abs(value) < least ? 0 : value), 'J', note);
  row('Energy at the beginning', energy.start.total, parts(energy.start));
  row('Energy at the end', energy.end.total, parts(energy.end));
  const went: [string, number][] = [
    ['Work of the drives', energy.work_of_drives],
    ['Work of pushes', energy.work_of_pushes ?? 0],
    ['Lost as heat', energy.heat],
    ['Lost in impacts', energy.lost_in_impacts],
    ['With links left out', energy.moved],
  ];
  for (const [label, value] of went) if (Math.abs(value) > least) row(label, value);
  add('Energy imbalance', power(energy.imbalance), 'J', `${power(energy.imbalance / scale)} of the energy at play: gained or lost by error, at most`);
}

// Those of the same kind over the same time with the same end share a line; the time in words.
function grouped(drives: Outcome[]): [string, Outcome[]][] {
  const groups = new Map<string, [string, Outcome[]]>();
  for (const outcome of drives) {
    const words = `${outcome.start_s.toFixed(3)} to ${outcome.end_s.toFixed(3)} s: `;
    const key = [words, outcome.drive, outcome.result].join();
    const group = groups.get(key) ?? [words, []];
    group[1].push(outcome);
    groups.set(key, group);
  }
  return [...groups.values()];
}
