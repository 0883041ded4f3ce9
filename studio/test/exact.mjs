// The page's engine against the program: the same walk, number by number.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { open } from './browser.mjs';

const target = process.env.CARGO_TARGET_DIR ?? fileURLToPath(new URL('../../target', import.meta.url));
const PROGRAM = process.env.SOLARIS ?? join(target, 'release/solaris');
// Sines of WebAssembly and of the machine differ in the last bit; what is planned of them by iteration, a little more. Of the largest number of a column.
const APART = 1e-12;

const table = (text) => {
  const [head, ...rows] = text.trim().split('\n').map((line) => line.split(','));
  return { head, rows: rows.map((row) => row.map(Number)) };
};

test('the table of a walk is that of the program', async (t) => {
  if (!existsSync(PROGRAM)) return t.skip(`there is no ${PROGRAM}; SOLARIS says where the program is`);
  const page = await open(t, { still: true, width: 500, height: 400 });
  if (!page) return;
  const folder = mkdtempSync(join(tmpdir(), 'studio-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const path = join(folder, 'walk.csv');
  execFileSync(PROGRAM, ['walk', '--height', '1.75', '--mass', '73', '--steps', '10', '-o', path], { stdio: 'ignore' });
  const [theirs, ours] = [
    readFileSync(path, 'utf8'),
    await page.evaluate(async () => new TextDecoder().decode(await studio.engine.call('save', [studio.motion.key, 'csv']))),
  ].map(table);
  assert.deepEqual(ours.head, theirs.head);
  assert.equal(ours.rows.length, theirs.rows.length);
  let [worst, where, same, count] = [0, '', 0, 0];
  theirs.head.forEach((name, column) => {
    const most = Math.max(...theirs.rows.map((row) => Math.abs(row[column])));
    theirs.rows.forEach((row, i) => {
      const apart = Math.abs(row[column] - ours.rows[i][column]);
      count += 1;
      if (apart === 0) same += 1;
      else if (!(apart / most <= worst)) [worst, where] = [apart / most, `${name} at ${row[0]} s`];
    });
  });
  t.diagnostic(`${count} numbers, ${((100 * same) / count).toFixed(1)} % to the last bit; the others at most ${worst.toExponential(1)} of their column's largest (${where})`);
  assert.ok(worst <= APART, `${where}: ${worst}`);
});
