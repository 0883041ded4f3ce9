// What drives one degree of freedom: bars over the time of the scene, and a form for the one that is chosen.

import type { Engine } from '../engine/client.ts';
import type { Dof } from '../engine/protocol.ts';
import { button, el, number } from '../ui/dom.ts';
import { makeCurveEditor } from './curve-editor.ts';
import { choose, typed } from './inputs.ts';
import { DEGREE, parse, plain, position, scalar } from './ron.ts';
import { fresh, joined, KINDS, lasts, readSegments, renewed, type FieldKind, type Segment, type Unit, type Until } from './segments.ts';

// How one drive went, as a run reports it.
export interface Outcome {
  dof: string;
  drive: string;
  start_s: number;
  end_s: number;
  result: string;
  position: number;
  missed_by: number | null;
}

export interface DrivesContext {
  engine: Engine;
  // Of all degrees of freedom with positions.
  names(): string[];
  turns(name: string): boolean;
  duration(): number;
  // Where it begins (rad, m).
  at(dof: Dof): number;
  // Done when the scene's text has it.
  write(name: string, text: string | null): Promise<void>;
  openText(): void;
}

export interface Drives {
  element: HTMLElement;
  // What the text says; `from`: the name or pattern that says it, where it is not its own.
  set(text: string, from: string | null): void;
  outcomes(found: Outcome[]): void;
  fault(message: string | null): void;
}

const UNITS: Record<Unit, [string, string]> = {
  position: ['°', 'm'],
  velocity: ['°/s', 'm/s'],
  acceleration: ['°/s²', 'm/s²'],
  time: ['s', 's'],
  stiffness: ['N m/rad', 'N/m'],
  damping: ['N m s/rad', 'N s/m'],
  force: ['N m', 'N'],
  number: ['', ''],
  phase: ['°', '°'],
};
export const unitOf = (unit: Unit, turns: boolean): string => UNITS[unit][turns ? 0 : 1];
const isAngle = (unit: Unit, turns: boolean): boolean => unit === 'phase' || (turns && ['position', 'velocity', 'acceleration'].includes(unit));

// The least part of the row that a bar takes (%).
const LEAST = 7;
const ENDS: [string, string][] = [
  ['Done', 'when it is done'],
  ['Lasting', 'after a time'],
  ['At', 'at a time of the scene'],
  ['Passes', 'when an angle is passed'],
  ['PassesSpeed', 'when a velocity is passed'],
];

export function makeDrives(context: DrivesContext, dof: Dof): Drives {
  const { turns, name } = dof;
  let segments: Segment[] = [];
  let shown = '';
  let inherited: string | null = null;
  let went: Outcome[] = [];
  let chosen: number | null = null;
  // Writes that the scene's text does not have yet: what it says meanwhile is older than what stands here.
  let pending = 0;

  const bars = el('div', { class: 'bars', role: 'group', 'aria-label': `${name}: what drives it, over the time` });
  const form = el('div', { class: 'drive-form', hidden: true });
  const fault = el('p', { class: 'fault', role: 'alert', hidden: true });
  const results = el('ul', { class: 'outcomes', hidden: true });
  const add = button('+', () => insert(), { class: 'add', 'aria-label': `Add a drive of ${name} at the end`, title: 'Add a drive at the end' });
  const element = el('div', { class: 'drives' }, el('div', { class: 'timeline' }, bars, add), fault, form, results);

  function commit(next: Segment[]): void {
    segments = next;
    inherited = null;
    went = [];
    shown = joined(segments);
    drawBars();
    pending += 1;
    void context.write(name, shown).finally(() => (pending -= 1));
  }
  const change = (i: number, by: Partial<Segment>): void => commit(segments.map((segment, k) => (k === i ? renewed({ ...segment, ...by }, turns) : segment)));

  function insert(): void {
    const spans = layout();
    const left = context.duration() - (spans.at(-1)?.[0] ?? 0);
    const last = segments.at(-1);
    // What never ends gets an end, so that the next one has its turn.
    const ended = last && last.kind && lasts(last, 0) === null && !last.until && ['Free', 'Frozen', 'Servo'].includes(last.kind);
    const before = ended ? [...segments.slice(0, -1), renewed({ ...last, until: { kind: 'Lasting', time: Number(plain(Math.max(0.1, left / 2), 2)) } }, turns)] : segments;
    chosen = before.length;
    commit([...before, fresh('Move', dof, context.at(dof), left / 2)]);
    drawForm();
    focusBar();
  }

  function cut(i: number): void {
    chosen = segments.length > 1 ? Math.max(0, i - 1) : null;
    if (segments.length > 1) commit(segments.filter((_, k) => k !== i));
    else void context.write(name, null);
    drawForm();
    focusBar();
  }

  function shift(i: number, by: number): void {
    const other = i + by;
    if (other < 0 || other >= segments.length) return;
    const next = [...segments];
    [next[i], next[other]] = [next[other], next[i]];
    chosen = other;
    commit(next);
    drawForm();
    focusBar();
  }

  const focusBar = (): void => {
    if (chosen !== null) bars.querySelectorAll<HTMLElement>('button')[chosen]?.focus();
  };

  // From when to when each lasts (s); after a run as it was.
  function layout(): [number, number][] {
    if (went.length === segments.length) return went.map(({ start_s, end_s }) => [start_s, end_s]);
    const duration = context.duration();
    let start = 0;
    const unknown = segments.filter((segment) => lasts(segment, 0) === null).length;
    const known = segments.reduce((sum, segment) => sum + (lasts(segment, sum) ?? 0), 0);
    const share = Math.max(0, duration - known) / Math.max(1, unknown);
    return segments.map((segment) => {
      const from = start;
      start = Math.min(duration, start + (lasts(segment, start) ?? share));
      return [from, start];
    });
  }

  const words = (segment: Segment): string => (segment.kind ? KINDS[segment.kind].label : (/^\w+/.exec(segment.text)?.[0] ?? 'more'));

  function drawBars(): void {
    const duration = Math.max(context.duration(), 1e-9);
    const percent = (time: number): number => (100 * Math.min(time, duration)) / duration;
    let free = 0;
    const made = layout().map(([from, to], i) => {
      const segment = segments[i];
      const left = Math.min(Math.max(percent(from), free), 100 - LEAST * (segments.length - i));
      const width = Math.max(LEAST, percent(to) - left);
      free = left + width;
      const when = `${number(from)} to ${number(to)} s`;
      return button(words(segment), () => choose_(i), {
        class: `bar-of ${segment.until ? 'until' : ''} ${inherited !== null ? 'inherited' : ''}`,
        style: `left:${left}%;width:${width}%`,
        'aria-pressed': String(i === chosen),
        'aria-label': `${words(segment)}, about ${when}`,
        title: `${segment.text}\n${when}`,
        onkeydown: ((event: KeyboardEvent) => onKey(event, i)) as unknown as EventListener,
      });
    });
    const marks = went.map(({ end_s, result, position: at }) =>
      el('i', { class: 'event', style: `left:${percent(end_s)}%`, title: `${number(end_s)} s: ${result}, ${shownAt(at)}` }),
    );
    bars.replaceChildren(...made, ...marks);
    results.hidden = went.length === 0;
    results.replaceChildren(
      ...went.map(({ drive, start_s, end_s, result, position: at, missed_by }) =>
        el('li', {}, `${number(start_s)}–${number(end_s)} s ${drive}: ${result}, ${shownAt(at)}${missed_by ? `, missed by ${shownAt(missed_by)}` : ''}`),
      ),
    );
  }
  const shownAt = (at: number): string => (turns ? `${number(at / DEGREE, 1)}°` : `${number(at, 3)} m`);

  // Chooses a bar, or closes it.
  function choose_(i: number): void {
    chosen = chosen === i ? null : i;
    bars.querySelectorAll('button').forEach((bar, k) => bar.setAttribute('aria-pressed', String(k === chosen)));
    drawForm();
  }

  function onKey(event: KeyboardEvent, i: number): void {
    const acts: Record<string, () => void> = {
      Delete: () => cut(i),
      Backspace: () => cut(i),
      ArrowLeft: () => (event.altKey ? shift(i, -1) : bars.querySelectorAll<HTMLElement>('button')[i - 1]?.focus()),
      ArrowRight: () => (event.altKey ? shift(i, 1) : bars.querySelectorAll<HTMLElement>('button')[i + 1]?.focus()),
    };
    if (!acts[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    acts[event.key]();
  }

  function inputOf(field: FieldKind, i: number): HTMLElement {
    const values = segments[i].values;
    const put = (text: string | null): void => {
      const next = new Map(segments[i].values);
      if (text === null) next.delete(field.name);
      else next.set(field.name, text);
      change(i, { values: next });
    };
    if (field.choices) {
      const now = values.get(field.name) ?? field.choices[0];
      return choose(field.label, field.choices.map((one) => [one, one]), now, (one) => put(one === field.choices![0] ? null : one)).element;
    }
    const angle = isAngle(field.unit, turns);
    const input = typed(
      field.name === 'force' && !turns ? 'Force' : field.label,
      unitOf(field.unit, turns),
      (value) => put(angle ? position(value * DEGREE, true) : plain(value, 5)),
      field.optional ? () => put(null) : undefined,
    );
    const now = scalar(parse(values.get(field.name) ?? '') ?? undefined);
    input.value = now === null ? null : angle ? now / DEGREE : now;
    return input.element;
  }

  function untilOf(i: number): HTMLElement[] {
    const { until } = segments[i];
    const put = (next: Until | null, again = false): void => {
      change(i, { until: next });
      if (again) drawForm();
    };
    const ends = choose('Until', ENDS, until?.kind ?? 'Done', (kind) => {
      if (kind === 'Done') put(null, true);
      else if (kind === 'At' || kind === 'Lasting') put({ kind, time: kind === 'At' ? Number(plain(layout()[i][0] + 0.5, 2)) : 0.5 }, true);
      else put({ kind: kind as 'Passes', name, value: context.at(dof), text: position(context.at(dof), turns) }, true);
    });
    if (!until) return [ends.element];
    if ('time' in until) {
      const time = typed(until.kind === 'At' ? 'At' : 'After', 's', (next) => put({ ...until, time: next }));
      time.value = until.time;
      return [ends.element, time.element];
    }
    const angle = context.turns(until.name);
    const rate = until.kind === 'PassesSpeed';
    const who = choose('Of', context.names().map((one) => [one, one]), until.name, (next) => put({ ...until, name: next }, true));
    const value = typed(rate ? 'Velocity' : 'Passes', unitOf(rate ? 'velocity' : 'position', angle), (next) => {
      const own = angle ? next * DEGREE : next;
      put({ ...until, value: own, text: position(own, angle) });
    });
    value.value = angle ? until.value / DEGREE : until.value;
    return [ends.element, who.element, value.element];
  }

  function drawForm(): void {
    const i = chosen;
    const segment = i === null ? undefined : segments[i];
    form.hidden = !segment;
    if (i === null || !segment) return;
    if (!segment.kind) {
      form.replaceChildren(
        el('pre', { class: 'written' }, segment.text),
        el('div', { class: 'row' }, button('Edit in Scene', context.openText), button('Remove', () => cut(i))),
      );
      return;
    }
    const kinds = choose('Mode', Object.entries(KINDS).map(([kind, { label }]) => [kind, kind === 'Torque' && !turns ? 'Constant force' : label]), segment.kind, (kind) => {
      const next = fresh(kind, dof, context.at(dof), context.duration() - layout()[i][0]);
      // What both have stays.
      next.values.forEach((_, field) => segments[i].values.has(field) && next.values.set(field, segments[i].values.get(field)!));
      change(i, { ...next, until: segments[i].until });
      drawForm();
    });
    const { curve } = segment;
    const isForce = segment.kind === 'TorqueCurve';
    form.replaceChildren(
      kinds.element,
      ...KINDS[segment.kind].fields.map((field) => inputOf(field, i)),
      curve
        ? makeCurveEditor({
            engine: context.engine,
            label: name,
            unit: isForce ? unitOf('force', turns) : unitOf('position', turns),
            turns: turns && !isForce,
            curve,
            change: (next) => change(i, { curve: next }),
            fault: (message) => tell(message),
          })
        : '',
      ...(segment.kind === 'Wait' ? [] : untilOf(i)),
      el(
        'div',
        { class: 'row' },
        button('Earlier', () => shift(i, -1), { disabled: i === 0 }),
        button('Later', () => shift(i, 1), { disabled: i === segments.length - 1 }),
        button('Remove', () => cut(i)),
        inherited === null ? button('As the others', () => void context.write(name, null), { title: `Nothing of its own for ${name}: what a pattern says` }) : '',
      ),
      inherited !== null ? el('p', { class: 'remark' }, `As “${inherited}” says; a change makes it its own.`) : '',
    );
  }

  function tell(message: string | null): void {
    fault.hidden = !message;
    fault.textContent = message ?? '';
  }

  return {
    element,
    set(text, from) {
      // What was written here stands here already.
      if (pending > 0 || (text === shown && from === inherited)) return drawBars();
      [shown, inherited, went] = [text, from, []];
      segments = readSegments(text);
      if (chosen !== null && chosen >= segments.length) chosen = null;
      drawBars();
      drawForm();
    },
    outcomes(found) {
      went = found;
      drawBars();
    },
    fault: tell,
  };
}
