// A number with its slider: both say the same, and what cannot be is said below.

import { el } from './dom.ts';

export interface SliderOptions {
  label: string;
  unit: string;
  low: number;
  high: number;
  step: number;
  value: number;
  // While the slider moves, and when a number was typed.
  change: (value: number) => void;
}

export interface Slider {
  element: HTMLElement;
  value: number;
  // The part of the slider that can be had, marked below it; null: nothing is known.
  range(range: [number, number] | null): void;
  // What is wrong with it; null: nothing.
  fault(message: string | null): void;
  show(visible: boolean): void;
}

export function slider({ label, unit, low, high, step, value, change }: SliderOptions): Slider {
  const name = `slider-${label.replace(/\W+/g, '-').toLowerCase()}`;
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  const written = (given: number): string => String(Number(given.toFixed(digits + 2)));
  const range = el('input', { type: 'range', id: name, min: low, max: high, step: 'any', value, autocomplete: 'off' });
  const typed = el('input', { type: 'number', min: low, max: high, step: 'any', value: written(value), autocomplete: 'off', 'aria-label': unit ? `${label} (${unit})` : label });
  const feasible = el('div', { class: 'feasible', hidden: true });
  const fault = el('p', { class: 'fault', hidden: true });
  const element = el(
    'div',
    { class: 'slider' },
    el('label', { for: name }, label),
    el('span', { class: 'typed' }, typed, el('span', { class: 'unit' }, unit)),
    el('div', { class: 'track' }, range, feasible),
    fault,
  );
  const set = (next: number, from: HTMLInputElement): void => {
    if (!Number.isFinite(next)) return;
    self.value = next;
    if (from !== range) range.value = String(next);
    if (from !== typed) typed.value = written(next);
    range.setAttribute('aria-valuetext', `${written(next)} ${unit}`);
    change(next);
  };
  range.addEventListener('input', () => set(Math.round(Number(range.value) / step) * step, range));
  typed.addEventListener('change', () => set(Number(typed.value), typed));
  range.addEventListener('keydown', (event) => {
    const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const next = Math.min(high, Math.max(low, Math.round(self.value / step + by) * step));
    range.value = String(next);
    set(next, range);
  });
  const percent = (at: number): number => (100 * (Math.min(high, Math.max(low, at)) - low)) / (high - low);
  let current = value;
  const self: Slider = {
    element,
    get value() {
      return current;
    },
    set value(next) {
      current = next;
      if (document.activeElement !== typed) typed.value = written(next);
      if (document.activeElement !== range) range.value = String(next);
    },
    range(known) {
      feasible.hidden = !known;
      if (!known) return;
      feasible.style.left = `${percent(known[0])}%`;
      feasible.style.right = `${100 - percent(known[1])}%`;
      feasible.title = `can be had from ${written(known[0])} to ${written(known[1])} ${unit}`;
      range.setAttribute('aria-description', feasible.title);
    },
    fault(message) {
      fault.hidden = !message;
      fault.textContent = message ?? '';
      element.classList.toggle('faulty', message !== null);
    },
    show(visible) {
      element.hidden = !visible;
    },
  };
  return self;
}
