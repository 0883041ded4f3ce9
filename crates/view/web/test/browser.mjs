// Chromium, and pages in it that report all that goes wrong.

import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const quiet = [
  '--headless',
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
const software = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

// None where there is no Chromium.
export async function launch() {
  if (!existsSync(executablePath)) return null;
  return chromium.launch({ executablePath, args: [...quiet, ...software] });
}

// A page from its file, with its faults: errors, warnings, and every request but the one for itself.
export async function open(browser, path, options, before) {
  const url = pathToFileURL(resolve(path)).href;
  const page = await browser.newPage(options);
  const faults = [];
  page.on('pageerror', (error) => faults.push(`page error: ${error.message}`));
  page.on('console', (message) => {
    // Drivers warn about being slow when the picture is read back; that is not the page's doing.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall')) {
      faults.push(`console ${message.type()}: ${message.text()}`);
    }
  });
  page.on('request', (request) => {
    if (request.url() !== url && !/^(data|blob):/.test(request.url())) faults.push(`request: ${request.url()}`);
  });
  if (before) await page.addInitScript(before);
  await page.goto(url);
  await page.waitForFunction(() => window.solaris?.ready === true, null, { timeout: 30000 });
  return { page, faults };
}

export const time = (page) => page.evaluate(() => window.solaris.time());

// Lets the page draw what it was told.
export const settle = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

// Stops at a share of the motion's time.
export async function stop(page, share) {
  await page.evaluate((share) => {
    window.solaris.pause();
    window.solaris.seek(-1e9);
    const first = window.solaris.time();
    window.solaris.seek(1e9);
    window.solaris.seek(first + share * (window.solaris.time() - first));
  }, share);
  await settle(page);
}
