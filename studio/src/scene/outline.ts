// What a text says, in words.

import type { SceneOutline } from '../engine/protocol.ts';
import { el, number } from '../ui/dom.ts';

// As many names stand in a line of their own.
const FEW = 4;
const DEGREES = 180 / Math.PI;

const counted = (count: number, one: string): string => `${count} ${one}`;
export const some = (names: string[], most: number): string =>
  names.length > most + 1 ? `${names.slice(0, most).join(', ')} and ${names.length - most} more` : names.join(', ');

// When a drive gives way to the next one.
function end(until: Record<string, unknown> | null, turns: (dof: string) => boolean): string {
  if (!until) return '';
  const value = Number(until.value);
  const amount = (dof: unknown, turned: string, slid: string): string =>
    turns(String(dof)) ? `${number(value * DEGREES)} ${turned}` : `${number(value, 3)} ${slid}`;
  if ('at' in until) return ` until ${number(Number(until.at), 3)} s`;
  if ('lasting' in until) return ` for ${number(Number(until.lasting), 3)} s`;
  if ('passes' in until) return ` until ${until.passes} passes ${amount(until.passes, '°', 'm')}`;
  if ('passesSpeed' in until) return ` until ${until.passesSpeed} passes ${amount(until.passesSpeed, '°/s', 'm/s')}`;
  if ('touches' in until) return ` until ${until.touches} touches the ground`;
  if ('leaves' in until) return ` until ${until.leaves} leaves the ground`;
  return '';
}

export function outlineWords(outline: SceneOutline): HTMLElement {
  const dofs = outline.joints.flatMap((joint) => joint.dofs);
  const turning = new Map(dofs.map(({ name, turns }) => [name, turns]));
  const named = new Map(dofs.map(({ name, index }) => [index, name]));
  const groups = new Map<string, string[]>();
  outline.drives.forEach(({ steps }, dof) => {
    const words = steps.map(({ drive, until }) => drive + end(until, (name) => turning.get(name) ?? true)).join(', then ') || 'free';
    groups.set(words, [...(groups.get(words) ?? []), named.get(dof) ?? String(dof)]);
  });
  const all = outline.drives.length;
  const beside = [
    outline.ground ? 'on a ground' : '',
    outline.walk ? `a walk leads ${counted(outline.walked, 'of them')}` : '',
  ].filter(Boolean);
  return el(
    'div',
    { class: 'outline' },
    el(
      'p',
      {},
      el('strong', {}, outline.name || outline.figure),
      `${outline.name && outline.figure !== outline.name ? ` (${outline.figure})` : ''}, ${counted(all, all === 1 ? 'degree of freedom' : 'degrees of freedom')}${beside.length > 0 ? `, ${beside.join(', ')}` : ''}: ` +
        `${number(outline.duration, 3)} s, ${number(outline.rate, 1)} frames a second. Method: ${outline.method}.`,
    ),
    el(
      'table',
      { 'aria-label': 'What drives the degrees of freedom' },
      ...[...groups]
        .sort(([, a], [, b]) => b.length - a.length)
        .map(([words, names]) =>
          el('tr', {}, el('th', { scope: 'row' }, words), el('td', { class: 'value' }, String(names.length)), el('td', { class: 'note' }, some(names, FEW))),
        ),
    ),
    ...outline.notes.map((note) => el('p', { class: 'remark' }, note)),
  );
}
