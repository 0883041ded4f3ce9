// The page of error against run time, over everything else. It is a page of its own that may do nothing: no scripts, no network.

import { button, el } from '../ui/dom.ts';
import { fileName } from '../save.ts';
import { saveText } from './files.ts';

export interface StudyPage {
  // The page so far, or whole.
  show(page: string, whole: boolean): void;
  open(): void;
}

export function studyPage(name: () => string): StudyPage {
  let page = '';
  const frame = el('iframe', { sandbox: '', title: 'Error against run time' });
  const state = el('span', { class: 'remark', role: 'status' });
  const element = el(
    'dialog',
    { class: 'study', 'aria-label': 'Error against run time' },
    el(
      'div',
      { class: 'head' },
      el('strong', {}, 'Error against run time'),
      state,
      button('Save page', () => saveText(fileName(`${name()}-precision`, 'html'), page, 'text/html')),
      button('Close', () => element.close(), { class: 'close' }),
    ),
    frame,
  );
  // Not in the panel, which can be hidden.
  document.body.append(element);
  return {
    show(next, whole) {
      page = next;
      // A page that comes into a frame that is not shown stays empty.
      if (element.open) frame.srcdoc = page;
      state.textContent = whole ? '' : 'so far; more methods are run';
    },
    open() {
      if (element.open) return;
      element.showModal();
      frame.srcdoc = page;
    },
  };
}
