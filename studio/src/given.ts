// Files that `solaris studio FILE…` put into the page.

import type { Given } from './panels/files.ts';

export function given(): Given[] {
  const element = document.getElementById('given');
  if (!element) return [];
  const files = JSON.parse(element.textContent) as { name: string; base64: string }[];
  element.remove();
  return files.map(({ name, base64 }) => ({ name, bytes: Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)) }));
}
