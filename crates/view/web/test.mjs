// Opens pages in Chromium from their files and asks whether they do what they should.
//
//     node test.mjs [--shots FOLDER] PAGE.html...
//
// The first page is tried in full, the others for whether the figure is in view, the ground under its feet, and nothing overlaps. Exit code 1 where
// something fails; without a Chromium nothing is tested (name one in the variable CHROMIUM).

import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import assert from 'node:assert/strict';
import { bands } from './test/bands.mjs';
import { launch, open, stop } from './test/browser.mjs';
import { inside, moves, painted } from './test/framing.mjs';
import { carries } from './test/ground.mjs';
import { fits, folds, named } from './test/layout.mjs';
import { plays, seeks } from './test/playing.mjs';

const { values, positionals: paths } = parseArgs({ options: { shots: { type: 'string' } }, allowPositionals: true });
if (paths.length === 0) {
  console.error('usage: node test.mjs [--shots FOLDER] PAGE.html...');
  process.exit(2);
}
const WIDE = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };
// Of the first page; the last is a telephone on its side.
const OTHERS = [
  { width: 320, height: 640 },
  { width: 768, height: 1024 },
  { width: 1920, height: 1080 },
  { width: 844, height: 390 },
];

const size = ({ width, height }) => `${width}×${height}`;

// In one size: the figure is in view, words do not overlap.
async function look(page, name, viewport) {
  await page.setViewportSize(viewport);
  const what = `${name} at ${size(viewport)}`;
  await fits(page, what);
  await inside(page, what);
  if (!values.shots) return;
  await stop(page, 0);
  await page.screenshot({ path: join(values.shots, `${name}-${viewport.width}.png`) });
}

// The page in a wide window and on a dark telephone.
async function shows(browser, judge, path) {
  const name = basename(path, '.html');
  const { page, faults } = await open(browser, path, { viewport: WIDE, colorScheme: 'dark', reducedMotion: 'reduce' });
  await look(page, name, WIDE);
  const cover = await painted(page, judge, 0.55, name);
  await carries(page, judge, name);
  await bands(page, name);
  await look(page, name, PHONE);
  await folds(page, name);
  const narrowCover = await painted(page, judge, 0, `${name}, narrow`);
  assert.deepEqual(faults, [], name);
  await page.close();
  const percent = (share) => (100 * share).toFixed(1);
  console.log(`${name}: in view, covers ${percent(cover)} % of the wide picture and ${percent(narrowCover)} % of the narrow one`);
}

// What does not depend on the figure.
async function works(browser, judge, path) {
  const { page, faults } = await open(browser, path, { viewport: WIDE });
  await plays(page);
  await seeks(page);
  await named(page);
  await moves(page, judge, basename(path, '.html'));
  for (const viewport of OTHERS) await look(page, basename(path, '.html'), viewport);
  await folds(page, 'a telephone on its side');
  assert.deepEqual(faults, []);
  await page.close();
  console.log(`plays, seeks, fits into ${OTHERS.map(size).join(', ')}`);
}

async function worksBlind(browser, path) {
  const { page, faults } = await open(browser, path, { viewport: WIDE }, () => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith('webgl') ? null : get.call(this, kind, ...rest);
    };
  });
  assert(await page.locator('#no-picture').isVisible(), 'a page without WebGL must say so');
  await plays(page);
  await seeks(page);
  // The library itself reports that it found no WebGL.
  assert.deepEqual(faults.filter((fault) => !fault.includes('WebGL')), []);
  console.log('without WebGL: said so, curves work');
}

const browser = await launch();
if (!browser) {
  console.log('skipped: there is no Chromium at /usr/bin/chromium; set CHROMIUM to its path');
  process.exit(0);
}
try {
  const judge = await browser.newPage();
  await works(browser, judge, paths[0]);
  await worksBlind(browser, paths[0]);
  for (const path of paths) await shows(browser, judge, path);
} catch (error) {
  console.error(`FAILED: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
}
