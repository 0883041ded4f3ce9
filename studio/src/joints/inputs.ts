// Small fields of the panel.

import { el } from '../ui/dom.ts';

export interface Input {
  element: HTMLElement;
  // Null: nothing stands there.
  value: number | null;
}

const written = (value: number): string => String(Number(value.toFixed(4)));

// A number with its unit; what is left empty is null where that is taken.
export function typed(label: string, unit: string, change: (value: number) => void, empty?: () => void): Input {
  const input = el('input', { type: 'number', step: 'any', autocomplete: 'off', 'aria-label': unit ? `${label} (${unit})` : label });
  input.addEventListener('change', () => {
    if (input.value.trim() === '') empty?.();
    else if (Number.isFinite(Number(input.value))) change(Number(input.value));
  });
  return {
    element: el('label', { class: 'typed-field' }, el('span', {}, label), el('span', { class: 'typed' }, input, el('span', { class: 'unit' }, unit))),
    get value() {
      return input.value.trim() === '' ? null : Number(input.value);
    },
    set value(next) {
      if (document.activeElement !== input) input.value = next === null ? '' : written(next);
    },
  };
}

export interface Choice {
  element: HTMLElement;
  value: string;
}

export function choose(label: string, options: [string, string][], value: string, change: (value: string) => void): Choice {
  const select = el('select', { 'aria-label': label, autocomplete: 'off' }, ...options.map(([name, words]) => el('option', { value: name }, words)));
  select.value = value;
  select.addEventListener('change', () => change(select.value));
  return {
    element: el('label', { class: 'choice' }, el('span', {}, label), select),
    get value() {
      return select.value;
    },
    set value(next) {
      select.value = next;
    },
  };
}
