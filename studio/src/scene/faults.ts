// What is wrong with the text, one line for each, below it.

import type { TextFault } from '../engine/protocol.ts';
import { button, el } from '../ui/dom.ts';

export interface FaultList {
  element: HTMLElement;
  show(faults: TextFault[]): void;
}

export function faultList(goTo: (fault: TextFault) => void, mend: (fault: TextFault) => void): FaultList {
  const count = el('p', { class: 'count', role: 'status' });
  const list = el('ul');
  const element = el('div', { class: 'faults', hidden: true }, count, list);
  return {
    element,
    show(faults) {
      element.hidden = faults.length === 0;
      count.textContent = faults.length === 1 ? 'One fault' : `${faults.length} faults`;
      list.replaceChildren(
        ...faults.map((fault) =>
          el(
            'li',
            {},
            button(`${fault.line}:${fault.column}`, () => goTo(fault), {
              class: 'place',
              'aria-label': `Line ${fault.line}, column ${fault.column}: go there`,
            }),
            el('span', {}, fault.message),
            fault.instead === null ? null : button(`Write ${fault.instead}`, () => mend(fault), { class: 'mend', title: 'By key: Ctrl . on its line' }),
          ),
        ),
      );
    },
  };
}
