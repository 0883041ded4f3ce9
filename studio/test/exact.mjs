// The page's engine against the program: the same numbers, to the last bit. The program calls the same sines as WebAssembly
// (`crates/cli/src/elementary.rs`), where it is one for Linux.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { choose, fixture, open } from './browser.mjs';

const target = process.env.CARGO_TARGET_DIR ?? fileURLToPath(new URL('../../target', import.meta.url));
const PROGRAM = process.env.SOLARIS ?? join(target, 'release/solaris');

const table = (text) => {
  const [head, ...rows] = text.trim().split('\n').map((line) => line.split(','));
  return { head, rows };
};

// A page, and what the program writes of the same.
async function both(t, options, prepare) {
  if (process.platform !== 'linux') return t.skip('the sines of this system are its own');
  if (!existsSync(PROGRAM)) return t.skip(`there is no ${PROGRAM}; SOLARIS says where the program is`);
  const page = await open(t, { still: true, width: 500, height: 400 });
  if (!page) return;
  await prepare(page);
  const folder = mkdtempSync(join(tmpdir(), 'studio-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const path = join(folder, 'motion.csv');
  execFileSync(PROGRAM, [...options, '-o', path], { stdio: 'ignore' });
  const [theirs, ours] = [
    readFileSync(path, 'utf8'),
    await page.evaluate(async () => new TextDecoder().decode(await studio.motion.engine.call('save', [studio.motion.key, 'csv']))),
  ].map(table);
  // The program leaves out what a command was given.
  const places = theirs.head.map((name) => ours.head.indexOf(name));
  assert.ok(places.length > 10 && !places.includes(-1));
  assert.equal(ours.rows.length, theirs.rows.length);
  assert.ok(theirs.rows.length > 70);
  theirs.rows.forEach((row, i) => assert.deepEqual(places.map((place) => ours.rows[i][place]), row));
  t.diagnostic(`${theirs.head.length * theirs.rows.length} numbers`);
}

// Steps turn so far that the program's person turns by the heading first, as the page's always do.
test('the table of a walk is that of the program', (t) =>
  both(t, ['walk', '--height', '1.75', '--mass', '73', '--steps', '10', '--turn', '8'], async (page) => {
    await page.fill('[aria-label="Turn a step (°)"]', '8');
    await page.press('[aria-label="Turn a step (°)"]', 'Enter');
    await page.waitForFunction(() => studio.show.data.root.at(-3) > 1);
  }));

for (const name of ['jump', 'arm_modes', 'walk_loose_arm']) {
  test(`the table of the scene ${name} is that of the program`, (t) =>
    both(t, ['run', fixture(`scenes/${name}.ron`)], async (page) => {
      const before = await page.evaluate(() => studio.motion?.key);
      await choose(page, `scenes/${name}.ron`);
      await page.click('#tab-scene');
      await page.getByRole('button', { name: 'Run', exact: true }).click();
      await page.waitForFunction((key) => studio.motion && studio.motion.key !== key, before, { timeout: 60_000 });
    }));
}

const SUBJECT = ['subject.osim', 'walk.mot', 'grf.mot', 'loads.xml', 'soles.ron'].map((name) => `subject/${name}`);

test('joint moments of files are those of the program', (t) =>
  both(t, ['inverse', ...SUBJECT.slice(0, 2).map(fixture), '--external-loads', fixture(SUBJECT[3]), '--filter', '6Hz', '--filter-order', '3'], async (page) => {
    await choose(page, ...SUBJECT);
    await page.waitForFunction(() => document.querySelector('#panel-files .found')?.textContent);
  }));
