// A studio in a browser, for tests: fails on any error of the page.

import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const STUDIO = fileURLToPath(new URL('../dist/studio.html', import.meta.url));
const BROWSER = process.env.CHROMIUM ?? '/usr/bin/chromium';
const ARGS = ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

// Gives the page when it is ready; null (and the test is skipped) where there is no browser or no studio.
export async function open(t, { width = 900, height = 640, dark = false, hash = '', url = `file://${STUDIO}${hash}`, ready = true } = {}) {
  for (const [file, how] of [[BROWSER, 'a Chromium; CHROMIUM says where it is'], [STUDIO, 'the studio: `node build.mjs`']]) {
    if (!existsSync(file)) {
      t.skip(`there is no ${file}: this needs ${how}`);
      return null;
    }
  }
  const browser = await chromium.launch({ executablePath: BROWSER, args: ARGS });
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light', acceptDownloads: true });
  const errors = [];
  const watch = (page) => {
    page.on('pageerror', (error) => errors.push(error.message));
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  };
  context.on('page', watch);
  t.after(async () => {
    await browser.close();
    if (errors.length > 0) throw new Error(`the page said: ${errors.join('; ')}`);
  });
  const page = await context.newPage();
  await page.goto(url);
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
