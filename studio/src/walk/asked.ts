// What a walk can be asked: the numbers with their sliders, the words, and the options that come of them.

import type { Who } from '../engine/protocol.ts';
import type { SliderOptions } from '../ui/slider.ts';

export type Options = Record<string, unknown>;

// A slider of one number; what is shown may be in another unit than what is asked.
export interface Field extends Omit<SliderOptions, 'change'> {
  // As the engine calls it, where it is asked within which values it may be: `stairs.rise` is a part of `stairs`.
  name: string;
  // In which unit of the engine one of the shown is.
  scale?: number;
  // Asked for even where it was not touched.
  always?: boolean;
}

const DEGREE = Math.PI / 180;

export const PACE: Field[] = [
  { name: 'step_frequency', label: 'Pace', unit: 'steps/min', low: 60, high: 130, step: 1, value: 110 },
  { name: 'step_length', label: 'Step length', unit: 'm', low: 0.3, high: 1.1, step: 0.01, value: 0.72 },
];
export const TURN: Field = { name: 'turn', label: 'Turn a step', unit: '°', low: -30, high: 30, step: 1, value: 0, scale: DEGREE };
export const SLOPE: Field = { name: 'slope', label: 'Slope', unit: '°', low: -15, high: 15, step: 0.5, value: 0, scale: DEGREE };
export const STAIRS: Field[] = [
  { name: 'stairs.count', label: 'Stairs', unit: '', low: 1, high: 20, step: 1, value: 6, always: true },
  { name: 'stairs.rise', label: 'Rise of a stair', unit: 'm', low: -0.2, high: 0.2, step: 0.005, value: 0.17, always: true },
  { name: 'stairs.tread', label: 'Tread', unit: 'm', low: 0.25, high: 0.35, step: 0.005, value: 0.29, always: true },
];
export const RUN: Field[] = [{ name: 'speed', label: 'Speed', unit: 'm/s', low: 2.2, high: 6, step: 0.1, value: 3 }];
// Numbers of the style are in the units in which people write them: degrees and metres.
export const STYLE: Field[] = [
  { name: 'style.arm_swing', label: 'Arm swing', unit: '°', low: 0, high: 45, step: 1, value: 20 },
  { name: 'style.rotation', label: 'Pelvic rotation', unit: '°', low: 0, high: 12, step: 0.5, value: 5 },
  { name: 'style.step_width', label: 'Step width', unit: 'm', low: 0.04, high: 0.2, step: 0.01, value: 0.1 },
  { name: 'style.thorax_lean', label: 'Lean', unit: '°', low: -5, high: 10, step: 0.5, value: 0 },
];
export const DIFFERENCES: Field[] = [
  { name: 'variability', label: 'Steps differ', unit: '× people’s', low: 0, high: 2, step: 0.1, value: 0 },
  { name: 'seed', label: 'Whose differences', unit: '', low: 0, high: 99, step: 1, value: 0 },
];
// Of the body.
export const LOADS: Field[] = [
  { name: 'load.left', label: 'In the left hand', unit: 'kg', low: 0, high: 20, step: 0.5, value: 0 },
  { name: 'load.right', label: 'In the right hand', unit: 'kg', low: 0, high: 20, step: 0.5, value: 0 },
];
export const LEGS: Field[] = [
  { name: 'shorterLeg.left', label: 'Left leg shorter', unit: 'mm', low: 0, high: 40, step: 1, value: 0, scale: 1e-3 },
  { name: 'shorterLeg.right', label: 'Right leg shorter', unit: 'mm', low: 0, high: 40, step: 1, value: 0, scale: 1e-3 },
];
export const BODY: Field[] = [...LOADS, ...LEGS];
export const CANE: Field = { name: 'cane_load', label: 'It bears', unit: '% of the force', low: 0, high: 25, step: 1, value: 15, scale: 0.01 };
export const FIELDS: Field[] = [...PACE, TURN, SLOPE, ...STAIRS, ...RUN, ...STYLE, ...DIFFERENCES, ...BODY, CANE];

// Words that may be chosen, and how they are called.
export const MANNERS: [string, string][] = ['', 'happy', 'sad', 'tired', 'proud', 'heavy', 'older', 'child', 'cautious'].map((manner) => [manner, manner || 'everybody’s']);
export const SIDES: [string, string][] = [['', 'as the other'], ['limp', 'limp'], ['stiff_knee', 'stiff knee'], ['drop_foot', 'drop foot'], ['load', 'arm with a load']];
export const HANDS: [string, string][] = [['', 'in no hand'], ['left', 'in the left hand'], ['right', 'in the right hand']];
export const POPULATIONS: [string, string][] = [['', 'adults overground'], ['treadmill', 'adults on a treadmill'], ['child', 'children'], ['older', 'older people']];
export const BOUNDS: [string, string][] = [['', 'in full run'], ['standing', 'in standing'], ['walking', 'in a walk']];
export const GROUNDS: [string, string][] = [['', 'level'], ['slope', 'a slope'], ['stairs', 'stairs']];

// What was asked by words, and by numbers that were touched.
export interface Asked {
  words: Options;
  touched: Map<string, number>;
}

export const isRun = ({ words }: Asked): boolean => words.gait === 'run';
// Through key postures, which nothing but the pace changes.
const isPosed = (asked: Asked): boolean => !isRun(asked) && words(asked, 'determinants') !== undefined;
const groundOf = (asked: Asked): string => (isRun(asked) || isPosed(asked) ? '' : String(words(asked, 'on') ?? ''));
const words = (asked: Asked, name: string): unknown => asked.words[name];
// The hand that holds a cane, on level ground.
const caneOf = (asked: Asked): Who['cane'] => (isRun(asked) || isPosed(asked) || groundOf(asked) ? undefined : (words(asked, 'cane') as Who['cane']));

// The numbers that stand with what is chosen: others would be refused.
export function fieldsOf(asked: Asked): Field[] {
  if (isRun(asked)) return [...RUN, ...LOADS];
  if (isPosed(asked)) return [...PACE, ...LOADS];
  const ground = groundOf(asked);
  const here = { slope: [SLOPE], stairs: STAIRS }[ground] ?? [TURN, ...DIFFERENCES];
  return [...PACE, ...here, ...STYLE, ...BODY, ...(caneOf(asked) ? [CANE] : [])];
}

// The words that do.
export function wordsOf(asked: Asked): string[] {
  if (isRun(asked)) return ['gait', 'steps', 'begins', 'ends'];
  if (isPosed(asked)) return ['gait', 'steps', 'determinants'];
  const walking = ['gait', 'determinants', 'population', 'manner', 'on'];
  // How many steps stairs take, they say themselves.
  return { slope: [...walking, 'steps'], stairs: walking }[groundOf(asked)] ?? [...walking, 'steps', 'left', 'right', 'cane'];
}

// Sets `a.b` in an object.
function put(into: Options, name: string, value: unknown): void {
  const [first, second] = name.split('.');
  if (second) into[first] = { ...(into[first] as Options), [second]: value };
  else into[first] = value;
}

function numbers(asked: Asked, fields: Field[], but?: string): Options {
  const found: Options = {};
  for (const { name, value, scale, always } of fields) {
    const given = asked.touched.get(name) ?? (always ? value * (scale ?? 1) : undefined);
    if (given !== undefined && name !== but) put(found, name, given);
  }
  return found;
}

// Words that other options come of.
const NOT_OPTIONS = ['on', 'begins', 'ends', 'cane'];

// As the engine's options have it: only what was touched. `but`: without this number.
export function optionsOf(asked: Asked, but?: string): Options {
  const said = wordsOf(asked).filter((name) => !NOT_OPTIONS.includes(name)).map((name) => [name, asked.words[name]]);
  const own = fieldsOf(asked).filter((field) => !BODY.includes(field));
  const options: Options = { ...Object.fromEntries(said), ...numbers(asked, own, but) };
  // Nothing of these is level ground, and steps that are alike.
  for (const name of ['slope', 'variability']) if (options[name] === 0) delete options[name];
  if (isRun(asked)) Object.assign(options, bound('from', words(asked, 'begins')), bound('to', words(asked, 'ends')));
  return options;
}

// How a run begins or ends, as the engine's options have it.
const bound = (end: string, how: unknown): Options => ({ standing: { [`${end}_standing`]: true }, walking: { [`${end}_walking`]: {} } })[String(how)] ?? {};

export const bodyOf = (asked: Asked): Omit<Who, 'height' | 'mass'> => ({ ...numbers(asked, fieldsOf(asked).filter((field) => BODY.includes(field))), cane: caneOf(asked) });

// What it is called.
export function titleOf(asked: Asked): string {
  const stand = new Set([...fieldsOf(asked).map(({ name }) => name), ...wordsOf(asked)]);
  const said = (name: string): number => (stand.has(name) ? (asked.touched.get(name) ?? FIELDS.find((field) => field.name === name)!.value) : 0);
  const word = (name: string, known: [string, string][]): string | undefined => {
    const value = stand.has(name) ? asked.words[name] : undefined;
    return value === undefined ? undefined : (known.find(([one]) => one === value)?.[1] ?? String(value));
  };
  const up = (by: number): string => (by < 0 ? 'down' : 'up');
  const sides = (tell: (side: string) => string | false | undefined): (string | false | undefined)[] => ['left', 'right'].map(tell);
  const manner = word('manner', MANNERS);
  const parts = [
    said('slope') !== 0 && ` ${up(said('slope'))} a slope of ${shown(Math.abs(said('slope')) / DEGREE)}°`,
    said('stairs.count') > 0 && ` ${up(said('stairs.rise'))} ${said('stairs.count')} stairs`,
    manner && `, ${manner}`,
    ...sides((side) => {
      const own = word(side, SIDES);
      return own && `, ${side} side: ${own}`;
    }),
    ...sides((side) => said(`load.${side}`) > 0 && `, ${shown(said(`load.${side}`))} kg in the ${side} hand`),
    ...sides((side) => said(`shorterLeg.${side}`) > 0 && `, ${side} leg ${shown(1e3 * said(`shorterLeg.${side}`))} mm shorter`),
    ...sides((side) => caneOf(asked) === side && `, a cane in the ${side} hand`),
  ];
  const begins = word('begins', BOUNDS);
  const ends = word('ends', BOUNDS);
  const bounds = [begins && `, begun ${begins}`, ends && `, ended ${ends}`];
  return [isRun(asked) ? 'A run' : 'A walk', ...[...bounds, ...parts].filter(Boolean)].join('');
}
const shown = (value: number): string => String(Number(value.toFixed(1)));
