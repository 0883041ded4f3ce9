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
// Sines of WebAssembly and of the machine differ in the last bit, and a plan is iterated from them. By how much numbers of a kind may differ, of the
// largest number of their column, and of one where that is less: what is zero but for rounding is not compared with rounding. The accelerations of
// toes, and what bears them, feel it most.
const APART = { q: 1e-10, v: 1e-9, a: 1e-6, tau: 1e-5, f: 1e-9, m: 1e-6, p: 1e-6 };
const kindOf = (name) => {
  const end = name.split('.').at(-1);
  return end in APART ? end : end[0];
};
// The page's people turn by their heading first, so that any turn can be walked: the same turns of the pelvis are other numbers.
const TURNS = /^root\.r/;

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
  assert.deepEqual([...ours.head].sort(), [...theirs.head].sort());
  assert.equal(ours.rows.length, theirs.rows.length);
  const worst = {};
  let [same, count] = [0, 0];
  theirs.head.forEach((name, column) => {
    if (TURNS.test(name)) return;
    const own = ours.head.indexOf(name);
    const most = Math.max(1, ...theirs.rows.map((row) => Math.abs(row[column])));
    theirs.rows.forEach((row, i) => {
      const apart = Math.abs(row[column] - ours.rows[i][own]);
      count += 1;
      if (apart === 0) same += 1;
      else if (!(apart / most <= (worst[kindOf(name)]?.[0] ?? 0))) worst[kindOf(name)] = [apart / most, `${name} at ${row[0]} s`];
    });
  });
  t.diagnostic(`${count} numbers, ${((100 * same) / count).toFixed(1)} % to the last bit; ${Object.entries(worst).map(([kind, [apart, where]]) => `${kind} ${apart.toExponential(1)} (${where})`).join(', ')}`);
  for (const [kind, [apart, where]] of Object.entries(worst)) assert.ok(apart <= APART[kind], `${where}: ${apart}`);
});
