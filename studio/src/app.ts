// What all panels work with: the engine, what is shown, what is said.

import { Engine, EngineFault } from './engine/client.ts';
import type { Row, ShownMotion, Who } from './engine/protocol.ts';
import { makeShow, type Show } from './show.ts';
import { byId, el, number } from './ui/dom.ts';
import { makeTabs, type Tabs } from './ui/tabs.ts';
import { view, type Body } from './view.ts';

// `viewer` and `style`: what pages of motions are made with; `worker`: the engine's script; `module`: the engine, compiled.
export const parts = (globalThis as unknown as { solarisParts: { viewer: string; style: string; worker: string; module: Promise<WebAssembly.Module> } }).solarisParts;

export interface App {
  engine: Engine;
  // For what takes long: a second engine, begun when it is first asked for.
  background(): Promise<Engine>;
  // One engine more, for what may be stopped.
  another(): Promise<Engine>;
  // The skin of a person, made once and by the second engine, so that the first one walks meanwhile.
  skin(who: Who): Promise<Body | null>;
  show: Show;
  tools: Tabs;
  results: Tabs;
  // The motion that is shown, and the rows of its table.
  motion: (ShownMotion & { rows: Row[]; engine: Engine }) | null;
  // Shows a motion with its rows; `again`: it is the next version of what is shown; `engine`: who keeps it, where that is not the first one; `body`: the skin, where it is
  // not in the data.
  showMotion(motion: ShownMotion, rows: Row[], how?: { again?: boolean; engine?: Engine; body?: Body | null }): void;
  // Says what is wrong, until something is shown or another thing is wrong.
  fault(error: unknown): void;
  say(message: string): void;
  clear(): void;
  onMotion(listener: () => void): void;
}

export function makeApp(): App {
  const engine = new Engine(parts.worker, parts.module);
  let second: Promise<Engine> | null = null;
  // Of whom the last one is.
  let skin: { words: string; body: Promise<Body | null> } | null = null;
  const tools = makeTabs(byId('tool-tabs'), byId('tools'));
  const results = makeTabs(byId('result-tabs'), byId('results'));
  const show = makeShow(results);
  const numbers = el('div', { class: 'numbers' });
  results.add({ id: 'numbers', title: 'Numbers', element: numbers });
  // On a telephone one of both sides is seen: that whose tab was chosen last.
  tools.onOpen(() => (document.body.dataset.side = 'tools'));
  results.onOpen(() => (document.body.dataset.side = 'results'));
  const notice = el('div', { class: 'notice', role: 'status', hidden: true });
  byId('over').append(notice);
  const listeners: (() => void)[] = [];
  const say = (message: string, kind: string): void => {
    notice.hidden = message === '';
    notice.className = `notice ${kind}`;
    notice.replaceChildren(el('p', {}, message), el('button', { type: 'button', 'aria-label': 'Close', onclick: () => self.clear() }, '×'));
  };
  const self: App = {
    engine,
    background: () => (second ??= self.another()),
    skin(who) {
      const words = JSON.stringify(who);
      if (skin?.words !== words) {
        const made = self
          .background()
          .then((other) => (other.busy ? engine : other).call<string | null>('skin', [who]))
          .then((json) => json && view.readBody(JSON.parse(json)));
        // What failed is tried again.
        made.catch(() => (skin = null));
        skin = { words, body: made as Promise<Body | null> };
      }
      return skin.body;
    },
    another: async () => new Engine(parts.worker, parts.module),
    show,
    tools,
    results,
    motion: null,
    showMotion(motion, rows, how) {
      self.motion = { ...motion, rows, engine: how?.engine ?? engine };
      byId('title').textContent = motion.title;
      document.title = `${motion.title} – Solaris Studio`;
      const data = view.readData(motion.data);
      if (how?.body) data.body = how.body;
      show.motion(data, how);
      numbers.replaceChildren(table(rows));
      listeners.forEach((listener) => listener());
    },
    fault(error) {
      const message = error instanceof Error ? error.message : String(error);
      if (message === 'stopped') return;
      const broken = error instanceof EngineFault && error.broken;
      say(broken ? `The engine broke and was begun anew: ${message}. What is shown can still be saved as a picture, and the scene's text is kept.` : message, 'wrong');
    },
    say: (message) => say(message, 'told'),
    clear: () => say('', 'told'),
    onMotion: (listener) => listeners.push(listener),
  };
  return self;
}

export function table(rows: Row[]): HTMLElement {
  return el(
    'table',
    {},
    ...rows.map(({ label, value, unit, note }) =>
      el(
        'tr',
        {},
        el('th', { scope: 'row' }, label),
        ...(value === '' && unit === ''
          ? [el('td', { class: 'note', colspan: 3 }, note)]
          : [el('td', { class: 'value' }, value), el('td', { class: 'unit' }, unit), el('td', { class: 'note' }, note)]),
      ),
    ),
  );
}

export const row = (label: string, value: number, unit: string, digits = 2, note = ''): Row => ({ label, value: number(value, digits), unit, note });
