// Elements, made in one line. Texts are texts: nothing that comes from a file is ever taken for markup.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | EventListener | undefined>;

// `on…` listens, what is false or undefined is left out.
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== undefined) element.setAttribute(name, String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return element;
}

export const byId = <T extends HTMLElement = HTMLElement>(id: string): T => {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as T;
};

export const button = (label: string, act: () => void, attributes: Attributes = {}): HTMLButtonElement =>
  el('button', { type: 'button', ...attributes, onclick: act as unknown as EventListener }, label);

// A true minus sign; `digits` behind the point, none needless.
export const number = (value: number, digits = 2): string =>
  Number.isFinite(value) ? String(Number(value.toFixed(digits))).replace('-', '−') : '–';

// Calls the last of many calls, after a pause (ms).
export function later<A extends unknown[]>(pause: number, act: (...args: A) => void): (...args: A) => void {
  let timer = 0;
  return (...args) => {
    clearTimeout(timer);
    timer = window.setTimeout(() => act(...args), pause);
  };
}

// Does one thing at a time: of what is asked meanwhile only the last is done.
export function latest<A extends unknown[]>(act: (...args: A) => Promise<void>): (...args: A) => Promise<void> {
  let running: Promise<void> | null = null;
  let next: A | null = null;
  const go = async (): Promise<void> => {
    while (next) {
      const args = next;
      next = null;
      await act(...args);
    }
    running = null;
  };
  return (...args) => {
    next = args;
    running ??= go();
    return running;
  };
}
