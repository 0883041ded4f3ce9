// The page in a browser, for tests of what people do with it.
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const page = new URL('../dist/studio.html', import.meta.url);
// Where it is asked for, where the system has it, where playwright put it.
const places = [process.env.STUDIO_CHROMIUM, '/usr/bin/chromium', '/usr/bin/google-chrome', chromium.executablePath()];
const quiet = ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

// Opens the page and gives it when it is ready; null where there is no browser or no page. Whatever the page complains of fails the test.
export async function open(t, { width = 900, height = 640, dark = false } = {}) {
  const executablePath = places.find((place) => place && existsSync(place));
  if (!executablePath || !existsSync(page)) {
    t.skip(executablePath ? 'there is no studio/dist/studio.html; build it by `cargo xtask studio`' : 'there is no chromium');
    return null;
  }
  const browser = await chromium.launch({ executablePath, args: quiet });
  t.after(() => browser.close());
  const opened = await browser.newPage({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light' });
  const wrong = [];
  opened.on('pageerror', (error) => wrong.push(error.message));
  opened.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
  opened.on('request', (request) => /^(https?|wss?):/.test(request.url()) && wrong.push(`asks for ${request.url()}`));
  t.after(() => {
    if (wrong.length > 0) throw new Error(wrong.join('\n'));
  });
  await opened.goto(String(page));
  await opened.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: 60_000 });
  return opened;
}
