// Opens a page in Chromium from its file and asks whether it does what it should.
//
//     node test.mjs PAGE.html [SCREENSHOT.png]
//
// Exit code 1 where it does not; without a Chromium nothing is tested (name one in the variable CHROMIUM).

import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const [path, screenshot] = process.argv.slice(2);
if (!path) {
  console.error('usage: node test.mjs PAGE.html [SCREENSHOT.png]');
  process.exit(2);
}
if (!existsSync(executablePath)) {
  console.log(`skipped: there is no Chromium at ${executablePath}; set CHROMIUM to its path`);
  process.exit(0);
}
const url = pathToFileURL(resolve(path)).href;
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

// A page that reports all that goes wrong in it, and every request but the one for itself.
async function open(browser, options, before) {
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

const time = (page) => page.evaluate(() => window.solaris.time());

// Lets the page draw what it was told.
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

async function plays(page) {
  await page.evaluate(() => (window.solaris.seek(0), window.solaris.play()));
  const start = await time(page);
  await page.waitForTimeout(700);
  const later = await time(page);
  assert(later > start + 0.1 && later < start + 3, `time must advance while playing: ${start} → ${later}`);
  await page.keyboard.press('Space');
  const paused = await time(page);
  await page.waitForTimeout(300);
  assert.equal(await time(page), paused, 'time must stand still after the space bar');
}

async function seeks(page) {
  const { last, frame, next, before } = await page.evaluate(() => {
    window.solaris.pause();
    window.solaris.seek(1e9);
    const last = window.solaris.time();
    window.solaris.seek(last / 2);
    const frame = window.solaris.frame();
    document.getElementById('forth').click();
    const next = window.solaris.frame();
    document.getElementById('back').click();
    return { last, frame, next, before: window.solaris.frame() };
  });
  assert.equal(next, frame + 1, 'the button goes one frame forward');
  assert.equal(before, frame, 'the button goes one frame back');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => window.solaris.frame()), frame + 1, 'so does the arrow key');
  const plot = page.locator('.u-over').first();
  if (await plot.count()) {
    const box = await plot.boundingBox();
    await plot.click({ position: { x: box.width / 4, y: box.height / 2 } });
    const at = await time(page);
    assert(Math.abs(at - last / 4) < last / 20, `a click on a plot seeks: ${at} of ${last}`);
  }
  return last;
}

// Pixels of a PNG: how many differ from the background, and from those of another one.
async function pixels(judge, shots) {
  return judge.evaluate(async (shots) => {
    const read = async (shot) => {
      const image = new Image();
      image.src = `data:image/png;base64,${shot}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const pen = canvas.getContext('2d');
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, image.width, image.height).data;
    };
    const [a, b] = await Promise.all(shots.map(read));
    const apart = (p, i, q, j) => Math.abs(p[i] - q[j]) + Math.abs(p[i + 1] - q[j + 1]) + Math.abs(p[i + 2] - q[j + 2]);
    const counts = new Map();
    for (let i = 0; i < a.length; i += 4) {
      const key = (a[i] << 16) | (a[i + 1] << 8) | a[i + 2];
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    const [common] = [...counts].sort((x, y) => y[1] - x[1])[0];
    const background = [common >> 16, (common >> 8) & 255, common & 255];
    let drawn = 0;
    let changed = 0;
    for (let i = 0; i < a.length; i += 4) {
      if (apart(a, i, background, 0) > 60) drawn += 1;
      if (apart(a, i, b, i) > 60) changed += 1;
    }
    return { drawn: drawn / (a.length / 4), changed: changed / (a.length / 4) };
  }, shots);
}

async function shows(page, judge, last) {
  const shot = async (at) => {
    await page.evaluate((at) => window.solaris.seek(at), at);
    await settle(page);
    return (await page.locator('#picture').screenshot()).toString('base64');
  };
  const shots = [await shot(0.37 * last), await shot(0.83 * last)];
  const seen = await pixels(judge, shots);
  assert(seen.drawn > 0.01 && seen.drawn < 0.8, `the figure must be visible: ${seen.drawn} of the picture is drawn on`);
  assert(seen.changed > 0.003, `the picture must change with the time: ${seen.changed} of it does`);
  return seen;
}

const browser = await chromium.launch({ executablePath, args: [...quiet, ...software] });
try {
  const judge = await browser.newPage();
  const wide = await open(browser, { viewport: { width: 1280, height: 800 } });
  await plays(wide.page);
  const last = await seeks(wide.page);
  const seen = await shows(wide.page, judge, last);
  if (screenshot) await wide.page.screenshot({ path: screenshot });
  assert.deepEqual(wide.faults, []);
  console.log(`wide: ${(100 * seen.drawn).toFixed(1)} % drawn, ${(100 * seen.changed).toFixed(1)} % changes`);

  const narrow = await open(browser, { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: 'dark' });
  await narrow.page.evaluate(() => window.solaris.pause());
  await shows(narrow.page, judge, last);
  const overflow = await narrow.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert(overflow <= 0, `a narrow page must not scroll sideways: ${overflow} px too wide`);
  if (screenshot) await narrow.page.screenshot({ path: screenshot.replace(/(\.png)?$/, '-narrow.png'), fullPage: true });
  assert.deepEqual(narrow.faults, []);
  console.log('narrow and dark: shown, no sideways scrolling');

  const blind = await open(browser, { viewport: { width: 1280, height: 800 } }, () => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith('webgl') ? null : get.call(this, kind, ...rest);
    };
  });
  assert(await blind.page.locator('#no-picture').isVisible(), 'a page without WebGL must say so');
  await plays(blind.page);
  await seeks(blind.page);
  // The library itself reports that it found no WebGL.
  assert.deepEqual(blind.faults.filter((fault) => !fault.includes('WebGL')), []);
  console.log('without WebGL: said so, curves work');
} catch (error) {
  console.error(`FAILED: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
}
