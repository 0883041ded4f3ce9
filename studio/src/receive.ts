// A page of the program that opened this window hands over its motion. Only data is taken, and only from that page: it is parsed as JSON and
// shown, and nothing else is acted upon.

import type { App } from './app.ts';

// The most characters of a page's data.
const MOST = 500_000_000;

export function receive(app: App, show: (json: string, title: string) => void): void {
  const opener = window.opener as Window | null;
  if (!opener) return;
  window.addEventListener('message', ({ source, origin, data }: MessageEvent<unknown>) => {
    // Pages from disk have no origin of their own: theirs and ours is "null", or "file://".
    if (source !== opener || (origin !== self.origin && origin !== location.origin)) return;
    const { solaris, json, title } = (data ?? {}) as Record<string, unknown>;
    if (solaris !== 'motion' || typeof json !== 'string' || json.length > MOST) return;
    try {
      show(json, typeof title === 'string' ? title.slice(0, 200) : 'A motion');
    } catch (error) {
      app.fault(new Error(`what the page handed over cannot be shown: ${(error as Error).message}`));
    }
  });
  // It says that it is there, and nothing else, so it may be heard by anybody.
  opener.postMessage({ solaris: 'studio' }, '*');
}
