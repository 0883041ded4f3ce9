// Somebody walks or runs, by sliders: the walk follows while they move.

import type { App } from '../app.ts';
import { row } from '../app.ts';
import type { Row, ShownMotion, Who } from '../engine/protocol.ts';
import { button, el, later, latest } from '../ui/dom.ts';
import { slider, type Slider } from '../ui/slider.ts';
import { fold } from '../ui/tabs.ts';
import type { Body } from '../view.ts';
import { type Asked, bodyOf, BODY, BOUNDS, CANE, DIFFERENCES, type Field, FIELDS, fieldsOf, GROUNDS, HANDS, isRun, MANNERS, optionsOf, type Options, PACE, POPULATIONS, RUN, SIDES, SLOPE, STAIRS, STYLE, titleOf, TURN, wordsOf } from '../walk/asked.ts';

// Body mass over squared height of people (kg/m²), where nobody says a mass.
const BODY_MASS_INDEX = 23.8;
// How long a slider rests before it is found within which values it can be (ms).
const REST = 500;
// Steps of a walk where it is not said how many.
const USUAL_STEPS = 10;
// How many of these intervals are kept.
const KNOWN = 100;

type Walked = ShownMotion & { report: Record<string, any> };

// What was asked of a walk: for links.
export interface WalkState {
  who: Who;
  asked: Options;
  touched: [string, number][];
}

export interface WalkPanel {
  start(): Promise<void>;
  state(): WalkState;
  // Sets all numbers to what they were; what a walk cannot be is said when it is planned.
  restore(state: WalkState): void;
}

export function makeWalkPanel(app: App): WalkPanel {
  // Numbers that were not touched are what people do, and as many steps as it takes.
  const asked: Asked = { words: { gait: 'walk' }, touched: new Map() };
  const { words: said, touched } = asked;
  const size = { height: 1.75, mass: 73 };
  const who = (): Who => ({ ...size, ...bodyOf(asked) });
  let rested: string | null = null;
  // The key of the walk that was shown last.
  let own: number | null = null;
  // The panel is open before there is anything to walk by.
  let started = false;

  const remark = el('p', { class: 'remark', 'aria-live': 'polite' });
  const sliders = new Map<string, Slider>();
  const make = (field: Field): HTMLElement => {
    const made = slider({
      ...field,
      change(value) {
        touched.set(field.name, value * (field.scale ?? 1));
        moved(field.name);
      },
    });
    sliders.set(field.name, made);
    const usual = STAIRS.includes(field) || BODY.includes(field) ? 'as usual' : 'as people do';
    const reset = button(usual, () => {
      touched.delete(field.name);
      made.value = field.value;
      moved(field.name);
    }, { class: 'reset', hidden: true, title: `${field.label}: ${usual}` });
    made.element.append(reset);
    return made.element;
  };
  const body = (name: 'height' | 'mass', label: string, unit: string, low: number, high: number, step: number): HTMLElement => {
    const made = slider({
      label, unit, low, high, step, value: size[name],
      change(value) {
        size[name] = value;
        // A person of another height has people's mass, until somebody says one.
        if (name === 'mass') touched.set('mass', value);
        else if (!touched.has('mass')) sliders.get('mass')!.value = size.mass = Math.round(BODY_MASS_INDEX * value * value);
        moved(name);
      },
    });
    sliders.set(name, made);
    return made.element;
  };
  const choices = new Map<string, HTMLSelectElement>();
  const choice = (name: string, label: string, options: [string, string][], change: (value: string) => void): HTMLElement => {
    const select = el('select', { 'aria-label': label, autocomplete: 'off' }, ...options.map(([value, text]) => el('option', { value }, text)));
    select.addEventListener('change', () => change(select.value));
    choices.set(name, select);
    return el('label', { class: 'choice' }, el('span', {}, label), select);
  };

  // A word that is chosen: what it is empty for is not asked.
  const word = (name: string, label: string, options: [string, string][]): HTMLElement =>
    choice(name, label, options, (value) => {
      said[name] = value || undefined;
      choose();
      moved(name);
    });
  const steps = slider({ label: 'Steps', unit: '', low: 2, high: 40, step: 1, value: USUAL_STEPS, change: (value) => { said.steps = Math.round(value); moved('steps'); } });
  const folded = (title: string, ...children: HTMLElement[]): HTMLElement => fold(title, false, ...children);
  const style = folded(
    'Style',
    choice('determinants', 'Way of walking', [['', 'smooth: forces first'], ['5', 'key postures, five determinants'], ['3', 'key postures, three']], (value) => {
      said.determinants = value === '' ? undefined : Number(value);
      choose();
      moved('determinants');
    }),
    word('population', 'Steps as', POPULATIONS),
    word('manner', 'Manner', MANNERS),
    word('left', 'Left side', SIDES),
    word('right', 'Right side', SIDES),
    ...[...STYLE, ...DIFFERENCES].map(make),
  );
  const element = el(
    'div',
    {},
    choice('gait', 'Gait', [['walk', 'Walk'], ['run', 'Run']], (value) => {
      said.gait = value;
      choose();
      moved('gait');
    }),
    body('height', 'Height', 'm', 0.8, 2.3, 0.01),
    body('mass', 'Mass', 'kg', 12, 180, 1),
    ...[...PACE, TURN, ...RUN].map(make),
    word('on', 'Ground', GROUNDS),
    word('begins', 'Begins', BOUNDS),
    word('ends', 'Ends', BOUNDS),
    ...[SLOPE, ...STAIRS].map(make),
    steps.element,
    style,
    folded('Loads, unequal legs, a cane', ...BODY.map(make), word('cane', 'A cane', HANDS), make(CANE)),
    remark,
  );
  // Only what stands with what is chosen.
  const choose = (): void => {
    const stand = new Set(fieldsOf(asked).map(({ name }) => name));
    FIELDS.forEach(({ name }) => sliders.get(name)!.show(stand.has(name)));
    const words = new Set(wordsOf(asked));
    steps.show(words.has('steps'));
    choices.forEach((select, name) => (select.parentElement!.hidden = !words.has(name)));
    style.hidden = isRun(asked);
  };
  choose();

  const plan = latest(async (from: string | null) => {
    let walked: Walked;
    let body: Body | null;
    try {
      const walks = app.engine.call<Walked>('walk', [who(), optionsOf(asked), titleOf(asked)]);
      [walked, body] = await Promise.all([walks, app.skin(who())]);
    } catch (error) {
      // What cannot be walked is said beside the number that was moved; the last answer stays.
      sliders.forEach((other, name) => other.fault(name === from ? (error as Error).message : null));
      if (!from || !sliders.has(from)) app.fault(error);
      return;
    }
    sliders.forEach((other) => other.fault(null));
    app.clear();
    own = walked.key;
    app.showMotion(walked, rows(walked), { again: from !== null, body });
    // What was not asked is what came of it.
    const { report } = walked;
    const came: Record<string, number> = { step_frequency: report.step_frequency_per_min, step_length: report.step_length_m, speed: report.speed_m_s };
    for (const [name, value] of Object.entries(came)) {
      const made = sliders.get(name);
      if (made && !touched.has(name) && Number.isFinite(value)) made.value = value;
    }
    sliders.forEach((made, name) => {
      const reset = made.element.querySelector<HTMLElement>('.reset');
      if (reset) reset.hidden = !touched.has(name);
    });
    remark.textContent = (report.notes as string[]).join(' ');
  });

  // The interval of the number that was moved last, once it rests: by the other engine, so that no slider waits for it. It is about all other
  // numbers, and holds while they do.
  const known = new Map<string, [number, number]>();
  const scaleOf = (name: string): number | null => {
    const field = BODY.some((one) => one.name === name) ? undefined : FIELDS.find((one) => one.name === name);
    return field ? (field.scale ?? 1) : null;
  };
  function show(name: string, range: [number, number] | null): void {
    const scale = scaleOf(name) ?? 1;
    sliders.forEach((other, which) => other.range(which === name && range ? [range[0] / scale, range[1] / scale] : null));
  }
  const others = (name: string): string => JSON.stringify([name, who(), optionsOf(asked, name)]);
  const find = latest(async (name: string) => {
    const words = others(name);
    try {
      const engine = await app.background();
      const range = await engine.call<[number, number] | null>('walkRange', [who(), optionsOf(asked), name]);
      if (known.size >= KNOWN) known.clear();
      if (range) known.set(words, range);
      if (rested === name && others(name) === words) show(name, range);
    } catch {
      // Where no interval can be told, none is shown.
    }
  });
  const rest = later(REST, (name: string) => {
    if (rested === name) void find(name);
  });
  function bound(name: string): void {
    const other = rested !== name;
    rested = name;
    const range = known.get(others(name));
    const value = touched.get(name);
    if (range && value !== undefined && value >= range[0] && value <= range[1]) return show(name, range);
    // That of another number held for what this one was.
    if (other) show(name, null);
    if (scaleOf(name) !== null) rest(name);
  }

  function moved(name: string): void {
    void plan(name);
    bound(name);
  }

  app.tools.add({
    id: 'walk',
    title: 'Walk',
    element,
    shown: () => {
      // What is shown may be somebody else's.
      if (started && (app.show.isLive() || app.motion?.key !== own)) void plan(null);
    },
  });
  return {
    start() {
      started = true;
      return plan(null);
    },
    state: () => ({ who: { ...size }, asked: { ...said }, touched: [...touched] }),
    restore(state) {
      Object.assign(size, state.who);
      Object.assign(said, state.asked);
      touched.clear();
      for (const [name, value] of state.touched) {
        const field = FIELDS.find((known) => known.name === name);
        if (!field && name !== 'mass') continue;
        touched.set(name, value);
        if (field) sliders.get(name)!.value = value / (field.scale ?? 1);
      }
      if (!GROUNDS.some(([ground]) => ground === (said.on ?? ''))) delete said.on;
      // As links said it that knew no other ground.
      if (touched.get('slope') && !said.on) said.on = 'slope';
      for (const name of ['height', 'mass'] as const) sliders.get(name)!.value = size[name];
      steps.value = Number(said.steps ?? USUAL_STEPS);
      choices.forEach((select, name) => (select.value = String(said[name] ?? '')));
      choose();
    },
  };
}

// What is measured of it.
function rows({ report, duration }: Walked): Row[] {
  const found: Row[] = [
    row('Step frequency', report.step_frequency_per_min, 'steps/min', 1),
    row('Step length', report.step_length_m, 'm', 3),
    row('Speed', report.speed_m_s, 'm/s', 3),
    row('Duration', duration, 's', 2),
  ];
  const measures = report.measures ?? {};
  for (const [name, value] of Object.entries(measures)) {
    if (typeof value !== 'number') continue;
    const { label, unit, scale } = words(name);
    found.push(row(label, value * scale, unit, 3));
  }
  for (const note of report.notes as string[]) found.push({ label: '', value: '', unit: '', note });
  return found;
}

// Names of measures end with their unit.
const UNITS: [string, string, number][] = [
  ['_per_min', 'steps/min', 1],
  ['_m_s', 'm/s', 1],
  ['_rad', '°', 180 / Math.PI],
  ['_deg', '°', 1],
  ['_bw', '% BW', 100],
  ['_percent', '%', 1],
  ['_kg', 'kg', 1],
  ['_nm', 'N m', 1],
  ['_n', 'N', 1],
  ['_j', 'J', 1],
  ['_m', 'm', 1],
  ['_s', 's', 1],
];
function words(name: string): { label: string; unit: string; scale: number } {
  const unit = UNITS.find(([end]) => name.endsWith(end));
  const plain = (unit ? name.slice(0, -unit[0].length) : name).replaceAll('_', ' ');
  return { label: plain[0].toUpperCase() + plain.slice(1), unit: unit?.[1] ?? '', scale: unit?.[2] ?? 1 };
}

