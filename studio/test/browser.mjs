// The built page in a browser, for tests: whatever it says to its console as an error fails them.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const PAGE = fileURLToPath(new URL('../dist/studio.html', import.meta.url));
const PROGRAM = process.env.CHROMIUM ?? '/usr/bin/chromium';
// The picture is drawn by software where tests run, and others may want the processor too (ms).
const PATIENCE = 120_000;
const QUIET = ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

// The page when it is ready; null, and the test is skipped, where there is no browser or no page.
export async function open(t, { width = 900, height = 640, dark = false } = {}) {
  const missing = [PROGRAM, PAGE].find((path) => !existsSync(path));
  if (missing) {
    t.skip(`there is no ${missing}: build the studio, and say where the browser is by CHROMIUM`);
    return null;
  }
  const browser = await chromium.launch({ executablePath: PROGRAM, args: QUIET });
  const page = await browser.newPage({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light', reducedMotion: 'reduce' });
  page.setDefaultTimeout(PATIENCE);
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  t.after(async () => {
    await browser.close();
    assert.deepEqual(faults, [], 'the page said nothing was wrong');
  });
  await page.goto(pathToFileURL(PAGE).href);
  await page.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: PATIENCE });
  return page;
}
