// What the joints belong to: the figure, its ground, gravity, and for how long.

import type { App } from '../app.ts';
import type { Edit, SceneDocument } from '../document.ts';
import { button, el } from '../ui/dom.ts';
import { slider } from '../ui/slider.ts';
import { fold } from '../ui/tabs.ts';
import { choose, typed } from './inputs.ts';
import { field, parse, plain, quote, scalar, type Node } from './ron.ts';

const [PERSON, LIMP, FILE] = ['person', 'limp', 'file:'];

export interface ScenePart {
  element: HTMLElement;
  sync(tree: Node | null): void;
}

export function makeScenePart(app: App, text: SceneDocument, write: (edits: Edit[]) => Promise<void>, openText: () => void): ScenePart {
  let name = 'ann';
  // A person as the text has it, without its brackets.
  let more: [string, string][] = [];
  const who = { height: 1.75, mass: 73 };
  const person = (limp: boolean): string =>
    `Human(${[['height', plain(who.height)], ['mass', plain(who.mass)], ...more.filter(([one]) => one !== 'joints'), ...(limp ? [['joints', 'Limp']] : [])].map(([one, value]) => `${one}: ${value}`).join(', ')})`;
  // Writes that the text does not have yet: what it says of the person meanwhile is older than what stands here.
  let pending = 0;
  const put = (figure: string): void => {
    pending += 1;
    void write([{ path: ['figures', quote(name)], value: figure }]).finally(() => (pending -= 1));
  };
  const figure = choose('Figure', [[PERSON, 'A person'], [LIMP, 'A limp person']], PERSON, (value) => {
    if (value.startsWith(FILE)) put(`File(${quote(value.slice(FILE.length))})`);
    else put(person(value === LIMP));
  });
  const select = figure.element.querySelector('select')!;
  const set = (which: 'height' | 'mass') => (value: number) => {
    who[which] = value;
    put(person(select.value === LIMP));
  };
  const height = slider({ label: 'Height of the person', unit: 'm', low: 0.8, high: 2.3, step: 0.01, value: 1.75, change: set('height') });
  const mass = slider({ label: 'Mass of the person', unit: 'kg', low: 12, high: 180, step: 1, value: 73, change: set('mass') });
  const ticked = (label: string, change: (on: boolean) => void): { element: HTMLElement; input: HTMLInputElement } => {
    const input = el('input', { type: 'checkbox', autocomplete: 'off' });
    input.addEventListener('change', () => change(input.checked));
    return { element: el('label', { class: 'tick' }, input, label), input };
  };
  const ground = ticked('Ground, to stand on', (on) => void write([{ path: ['ground'], value: on ? 'Flat(friction: 0.8, stand: true)' : null }]));
  const gravity = ticked('Gravity', (on) => void write([{ path: ['gravity'], value: on ? null : '(0.0, 0.0, 0.0)' }]));
  const duration = typed('Duration', 's', (value) => void write([{ path: ['duration'], value: plain(value) }]));
  const several = el('p', { class: 'remark', hidden: true });
  const anew = button('Begin anew with this figure', () => void write([{ path: ['drives'], value: '{"*": Frozen}' }, { path: ['start'], value: null }]), {
    hidden: true,
    title: 'What the scene says of joints that this figure does not have is taken away',
  });
  const element = fold(
    'Figure, ground, duration',
    false,
    figure.element,
    height.element,
    mass.element,
    el('div', { class: 'row' }, ground.element, gravity.element),
    duration.element,
    anew,
    several,
  );
  let files: string[] = [];

  async function shelved(): Promise<void> {
    files = await app.engine.call<string[]>('shelved').catch(() => []);
  }

  function sync(tree: Node | null): void {
    const figures = field(tree, 'figures')?.entries ?? [];
    const said = (node: Node): string => text.text.slice(node.from, node.to);
    const only = figures.length === 1 ? figures[0] : null;
    const value = only?.value;
    if (only) name = only.key;
    const isPerson = value?.name === 'Human';
    const file = value?.name === 'File' ? (value.items?.[0]?.text ?? field(value, 'path')?.text) : undefined;
    if (isPerson && pending === 0) {
      who.height = scalar(field(value, 'height')) ?? who.height;
      who.mass = scalar(field(value, 'mass')) ?? who.mass;
      more = [...(value?.fields ?? [])].filter(([one]) => one !== 'height' && one !== 'mass').map(([one, node]) => [one, said(node)]);
      [height.value, mass.value] = [who.height, who.mass];
    }
    const isLimp = field(value, 'joints')?.name === 'Limp';
    const other = only && !isPerson && file === undefined;
    const known = [...new Set([...files, ...(file === undefined ? [] : [file])])];
    const chosen = select.value;
    select.replaceChildren(
      el('option', { value: PERSON }, 'A person'),
      el('option', { value: LIMP }, 'A limp person'),
      ...known.map((one) => el('option', { value: FILE + one }, one)),
      ...(other ? [el('option', { value: 'other' }, `“${name}”, as written`)] : []),
    );
    select.value = pending > 0 ? chosen : isPerson ? (isLimp ? LIMP : PERSON) : file !== undefined ? FILE + file : 'other';
    height.show(isPerson);
    mass.show(isPerson);
    figure.element.hidden = !only;
    several.hidden = figures.length < 2;
    several.replaceChildren(`${figures.length} figures: `, button('Edit in Scene', openText));
    const lies = field(tree, 'ground');
    ground.input.checked = lies !== undefined;
    ground.element.title = lies ? said(lies) : 'Nothing lies under the figure';
    const pull = field(tree, 'gravity');
    gravity.input.checked = !pull || (pull.items ?? []).some(({ number }) => number !== 0);
    duration.value = scalar(field(tree, 'duration')) ?? text.outline?.duration ?? null;
    // A fault about a name of another figure.
    anew.hidden = !text.faults.some(({ message }) => /no (joint|degree|link)|nothing (here )?is called|did you mean|means nothing/.test(message));
  }
  element.addEventListener('toggle', () => void shelved().then(() => sync(parse(text.text))));
  return { element, sync };
}
