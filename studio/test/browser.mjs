// A studio in a browser, for tests of what people do with it: whatever the page complains of, and whatever it asks of a network, fails them.

import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const STUDIO = fileURLToPath(new URL('../dist/studio.html', import.meta.url));
// Where it is asked for, where the system has it, where playwright put it.
const BROWSERS = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/google-chrome', chromium.executablePath()];
const ARGS = ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

// `still`: nothing plays by itself, which spares a machine without a graphics card much.
// Gives the page when it is ready; null (and the test is skipped) where there is no browser or no studio.
export async function open(t, { width = 900, height = 640, dark = false, hash = '', url = `file://${STUDIO}${hash}`, ready = true, still = false } = {}) {
  const executablePath = BROWSERS.find((place) => place && existsSync(place));
  if (!executablePath || !existsSync(STUDIO)) {
    t.skip(executablePath ? 'there is no studio/dist/studio.html; `cargo xtask studio` builds it' : 'there is no Chromium; CHROMIUM says where one is');
    return null;
  }
  const browser = await chromium.launch({ executablePath, args: ARGS });
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light', acceptDownloads: true, reducedMotion: still ? 'reduce' : 'no-preference' });
  const wrong = [];
  context.on('page', (page) => {
    page.on('pageerror', (error) => wrong.push(error.message));
    page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
    page.on('request', (request) => /^(https?|wss?):/.test(request.url()) && wrong.push(`asks for ${request.url()}`));
  });
  t.after(async () => {
    await browser.close();
    if (wrong.length > 0) throw new Error(`the page said: ${wrong.join('; ')}`);
  });
  const page = await context.newPage();
  await page.goto(url, { timeout: 60_000 });
  if (ready) await page.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: 60_000 });
  return page;
}

export const fixture = (name) => fileURLToPath(new URL(`../../fixtures/${name}`, import.meta.url));

// Opens files as somebody who chooses them.
export async function choose(page, ...names) {
  await page.setInputFiles('#files', names.map((name) => (typeof name === 'string' ? fixture(name) : name)));
  await page.waitForFunction(() => {
    const said = document.querySelector('.said')?.textContent ?? '';
    return said !== '' && !said.startsWith('Opening');
  });
}

// What is in an element, when it is there.
export const text = (page, selector) => page.locator(selector).first().innerText();
