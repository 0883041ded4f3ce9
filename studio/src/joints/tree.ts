// The joints of a figure in a list with a search field: one is chosen.

import type { JointOutline } from '../engine/protocol.ts';
import { el } from '../ui/dom.ts';

export interface Listed {
  joint: JointOutline;
  depth: number;
  // What drives it, in a word.
  word: string;
}

export interface JointList {
  element: HTMLElement;
  set(listed: Listed[]): void;
  choose(name: string | null): void;
}

export function makeJointList(chosen: (name: string) => void): JointList {
  const search = el('input', { type: 'search', placeholder: 'Find a joint or link', 'aria-label': 'Find a joint or link', autocomplete: 'off', spellcheck: 'false' });
  const list = el('ul', { class: 'joint-list', role: 'listbox', tabindex: 0, 'aria-label': 'Joints' });
  let listed: Listed[] = [];
  let current: string | null = null;
  const shown = (): Listed[] => {
    const words = search.value.trim().toLowerCase().split(/[\s_]+/);
    return listed.filter(({ joint: { name, link, dofs } }) => {
      const all = [name, link, ...dofs.map((dof) => dof.name)].join(' ').toLowerCase();
      return words.every((word) => all.includes(word));
    });
  };
  const id = (name: string): string => `joint-${name.replace(/[^\w-]/g, '-')}`;
  function draw(): void {
    const all = shown();
    list.replaceChildren(
      ...all.map(({ joint, depth, word }) =>
        el(
          'li',
          { role: 'option', id: id(joint.name), 'data-joint': joint.name, 'aria-selected': String(joint.name === current), style: `padding-left:${8 + 10 * depth}px` },
          el('span', {}, joint.name),
          el('span', { class: 'word' }, word),
        ),
      ),
      ...(all.length === 0 ? [el('li', { class: 'remark' }, 'No joint is called so.')] : []),
    );
    mark();
  }
  function mark(): void {
    for (const item of list.querySelectorAll<HTMLElement>('[role=option]')) {
      const is = item.dataset.joint === current;
      item.setAttribute('aria-selected', String(is));
      if (!is) continue;
      list.setAttribute('aria-activedescendant', item.id);
      // Only the list moves, not the panel.
      if (item.offsetTop < list.scrollTop) list.scrollTop = item.offsetTop;
      else if (item.offsetTop + item.offsetHeight > list.scrollTop + list.clientHeight) list.scrollTop = item.offsetTop + item.offsetHeight - list.clientHeight;
    }
  }
  const step = (by: number): void => {
    const all = shown();
    if (all.length === 0) return;
    const at = all.findIndex(({ joint }) => joint.name === current);
    chosen(all[at < 0 ? 0 : Math.min(all.length - 1, Math.max(0, at + by))].joint.name);
  };
  const keys = (event: KeyboardEvent): void => {
    const by = { ArrowUp: -1, ArrowDown: 1, PageUp: -8, PageDown: 8, ...(event.target === list ? { Home: -1000, End: 1000 } : {}) }[event.key];
    if (by === undefined && event.key !== 'Enter') return;
    event.preventDefault();
    event.stopPropagation();
    step(by ?? 0);
  };
  search.addEventListener('input', draw);
  search.addEventListener('keydown', keys);
  list.addEventListener('keydown', keys);
  list.addEventListener('click', ({ target }) => {
    const name = (target as Element).closest<HTMLElement>('[data-joint]')?.dataset.joint;
    if (name) chosen(name);
  });
  return {
    element: el('div', { class: 'joint-tree' }, search, list),
    set(next) {
      const before = JSON.stringify(listed);
      listed = next;
      if (JSON.stringify(listed) !== before) draw();
    },
    choose(name) {
      current = name;
      if (name && !shown().some(({ joint }) => joint.name === name)) {
        search.value = '';
        draw();
      }
      mark();
    },
  };
}
