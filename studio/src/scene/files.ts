// Texts that come from the machine and go to it.

import { el } from '../ui/dom.ts';

// How long the browser may take to begin (ms).
const WHILE = 10_000;

export function saveText(name: string, text: string, type = 'text/plain'): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  el('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), WHILE);
}

// Asks for a file and gives its text.
export function openText(accept: string, opened: (text: string, name: string) => void): void {
  const input = el('input', { type: 'file', accept });
  input.addEventListener('change', async () => {
    const [file] = input.files ?? [];
    if (file) opened(await file.text(), file.name);
  });
  input.click();
}
