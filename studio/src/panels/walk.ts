// Somebody walks or runs, by sliders: the walk follows while they move.

import type { App } from '../app.ts';
import { row } from '../app.ts';
import type { Row, ShownMotion, Who } from '../engine/protocol.ts';
import { button, el, later, latest } from '../ui/dom.ts';
import { slider, type Slider } from '../ui/slider.ts';
import { fold } from '../ui/tabs.ts';
import type { Body } from '../view.ts';

const DEGREE = Math.PI / 180;
// Body mass over squared height of people (kg/m²), where nobody says a mass.
const BODY_MASS_INDEX = 23.8;
// How long a slider rests before it is found within which values it can be (ms).
const REST = 500;
// How many of these intervals are kept.
const KNOWN = 100;

type Options = Record<string, unknown>;
type Walked = ShownMotion & { report: Record<string, any> };

// A slider of one option; angles are shown in degrees and asked in rad.
interface Field {
  name: string;
  label: string;
  unit: string;
  low: number;
  high: number;
  step: number;
  // What it is where it was not touched; undefined: what people do.
  value: number;
  // In which unit of the engine one of the shown is.
  scale?: number;
  // Of the style, and not of the walk itself.
  style?: boolean;
}

const WALK: Field[] = [
  { name: 'step_frequency', label: 'Pace', unit: 'steps/min', low: 60, high: 130, step: 1, value: 110 },
  { name: 'step_length', label: 'Step length', unit: 'm', low: 0.3, high: 1.1, step: 0.01, value: 0.72 },
  { name: 'turn', label: 'Turn a step', unit: '°', low: -30, high: 30, step: 1, value: 0, scale: DEGREE },
  { name: 'slope', label: 'Slope', unit: '°', low: -15, high: 15, step: 0.5, value: 0, scale: DEGREE },
];
const RUN: Field[] = [{ name: 'speed', label: 'Speed', unit: 'm/s', low: 2.2, high: 6, step: 0.1, value: 3 }];
const STYLE: Field[] = [
  { name: 'arm_swing', label: 'Arm swing', unit: '°', low: 0, high: 45, step: 1, value: 20, scale: DEGREE, style: true },
  { name: 'pelvic_rotation', label: 'Pelvic rotation', unit: '°', low: 0, high: 12, step: 0.5, value: 5, scale: DEGREE, style: true },
  { name: 'step_width', label: 'Step width', unit: 'm', low: 0.02, high: 0.25, step: 0.01, value: 0.1, style: true },
];
const MANNERS = ['', 'happy', 'sad', 'tired', 'proud', 'heavy'];

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
  const asked: Options = { gait: 'walk', steps: 10 };
  const who: Who = { height: 1.75, mass: 73 };
  // Which options were touched: the others are what people do.
  const touched = new Map<string, number>();
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
    const reset = button('as people do', () => {
      touched.delete(field.name);
      moved(field.name);
    }, { class: 'reset', hidden: true, title: `${field.label}: what people do` });
    made.element.append(reset);
    return made.element;
  };
  const body = (name: 'height' | 'mass', label: string, unit: string, low: number, high: number, step: number): HTMLElement => {
    const made = slider({
      label, unit, low, high, step, value: who[name],
      change(value) {
        who[name] = value;
        // A person of another height has people's mass, until somebody says one.
        if (name === 'mass') touched.set('mass', value);
        else if (!touched.has('mass')) sliders.get('mass')!.value = who.mass = Math.round(BODY_MASS_INDEX * value * value);
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

  const steps = slider({ label: 'Steps', unit: '', low: 2, high: 40, step: 1, value: 10, change: (value) => { asked.steps = Math.round(value); moved('steps'); } });
  const walkOnly: HTMLElement[] = [];
  const runOnly: HTMLElement[] = [];
  const element = el(
    'div',
    {},
    choice('gait', 'Gait', [['walk', 'Walk'], ['run', 'Run']], (value) => {
      asked.gait = value;
      choose();
      moved('gait');
    }),
    body('height', 'Height', 'm', 0.8, 2.3, 0.01),
    body('mass', 'Mass', 'kg', 12, 180, 1),
    ...WALK.map((field) => {
      const made = make(field);
      walkOnly.push(made);
      return made;
    }),
    ...RUN.map((field) => {
      const made = make(field);
      runOnly.push(made);
      return made;
    }),
    steps.element,
    fold(
      'Style',
      false,
      choice('determinants', 'Way of walking', [['', 'smooth: forces first'], ['5', 'key postures, five determinants'], ['3', 'key postures, three']], (value) => {
        asked.determinants = value === '' ? undefined : Number(value);
        moved('determinants');
      }),
      choice('manner', 'Manner', MANNERS.map((manner) => [manner, manner || 'everybody’s']), (value) => {
        asked.manner = value || undefined;
        moved('manner');
      }),
      choice('left', 'One side', [['', 'as the other'], ['limp', 'limps']], (value) => {
        asked.left = value || undefined;
        moved('left');
      }),
      ...STYLE.map(make),
    ),
    remark,
  );
  const choose = (): void => {
    walkOnly.forEach((shown) => (shown.hidden = asked.gait === 'run'));
    runOnly.forEach((shown) => (shown.hidden = asked.gait !== 'run'));
  };
  choose();

  // What is asked, as the engine's options have it: only what was touched.
  function options(): Options {
    const found: Options = { ...asked };
    const style: Record<string, number> = {};
    for (const field of [...(asked.gait === 'run' ? RUN : [...WALK, ...STYLE])]) {
      const value = touched.get(field.name);
      if (value === undefined || (field.name === 'slope' && value === 0)) continue;
      if (field.style) style[field.name] = value;
      else found[field.name] = value;
    }
    if (Object.keys(style).length > 0) found.style = style;
    return found;
  }

  const plan = latest(async (from: string | null) => {
    let walked: Walked;
    let body: Body | null;
    try {
      const walks = app.engine.call<Walked>('walk', [who, options(), asked.gait === 'run' ? 'A run' : 'A walk']);
      [walked, body] = await Promise.all([walks, app.skin({ ...who })]);
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
    const field = [...WALK, ...RUN, ...STYLE].find((one) => one.name === name);
    return field ? (field.scale ?? 1) : null;
  };
  function show(name: string, range: [number, number] | null): void {
    const scale = scaleOf(name) ?? 1;
    sliders.forEach((other, which) => other.range(which === name && range ? [range[0] / scale, range[1] / scale] : null));
  }
  function others(name: string): string {
    const { [name]: _, ...asked } = options();
    const { [name]: own, ...style } = (asked.style ?? {}) as Options;
    return JSON.stringify([name, who, { ...asked, style }]);
  }
  const find = latest(async (name: string) => {
    const words = others(name);
    try {
      const engine = await app.background();
      const range = await engine.call<[number, number] | null>('walkRange', [who, options(), name]);
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
    state: () => ({ who: { ...who }, asked: { ...asked }, touched: [...touched] }),
    restore(state) {
      Object.assign(who, state.who);
      Object.assign(asked, state.asked);
      touched.clear();
      for (const [name, value] of state.touched) {
        const field = [...WALK, ...RUN, ...STYLE].find((known) => known.name === name);
        if (!field && name !== 'mass') continue;
        touched.set(name, value);
        if (field) sliders.get(name)!.value = value / (field.scale ?? 1);
      }
      for (const name of ['height', 'mass'] as const) sliders.get(name)!.value = who[name];
      steps.value = Number(asked.steps);
      choices.forEach((select, name) => (select.value = String(asked[name] ?? '')));
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

