// Panels of which one is shown, by a row of tabs.

import { button, el } from './dom.ts';

export interface Panel {
  id: string;
  title: string;
  element: HTMLElement;
  // Called when it comes to the front, and when it goes.
  shown?: () => void;
  left?: () => void;
}

export interface Tabs {
  add(panel: Panel): void;
  open(id: string): void;
  current(): string;
  onOpen(listener: (id: string) => void): void;
}

export function makeTabs(bar: HTMLElement, root: HTMLElement): Tabs {
  const panels: Panel[] = [];
  const tabs = new Map<string, HTMLButtonElement>();
  const listeners: ((id: string) => void)[] = [];
  let current = '';
  const self: Tabs = {
    add(panel) {
      const tab = button(panel.title, () => self.open(panel.id), { role: 'tab', id: `tab-${panel.id}`, 'aria-controls': `panel-${panel.id}` });
      panel.element.id = `panel-${panel.id}`;
      panel.element.setAttribute('role', 'tabpanel');
      panel.element.setAttribute('aria-labelledby', tab.id);
      panel.element.classList.add('panel');
      panel.element.hidden = true;
      tab.tabIndex = -1;
      tab.setAttribute('aria-selected', 'false');
      panels.push(panel);
      tabs.set(panel.id, tab);
      bar.append(tab);
      root.append(panel.element);
    },
    open(id) {
      const next = panels.find((panel) => panel.id === id);
      if (!next) return;
      const before = panels.find((panel) => panel.id === current);
      current = id;
      for (const panel of panels) {
        panel.element.hidden = panel.id !== id;
        const tab = tabs.get(panel.id)!;
        tab.setAttribute('aria-selected', String(panel.id === id));
        tab.tabIndex = panel.id === id ? 0 : -1;
      }
      if (before !== next) before?.left?.();
      listeners.forEach((listener) => listener(id));
      if (before !== next) next.shown?.();
    },
    current: () => current,
    onOpen: (listener) => listeners.push(listener),
  };
  bar.addEventListener('keydown', (event) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by) return;
    // Between tabs the arrows go from one to the next, not through the frames.
    event.stopPropagation();
    event.preventDefault();
    const at = panels.findIndex((panel) => panel.id === current);
    const next = panels[(at + by + panels.length) % panels.length];
    self.open(next.id);
    tabs.get(next.id)!.focus();
  });
  return self;
}

// A part of a panel that can be folded.
export const fold = (title: string, open: boolean, ...children: (Node | string)[]): HTMLDetailsElement =>
  el('details', { class: 'fold', open }, el('summary', {}, title), ...children);
