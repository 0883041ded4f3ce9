// Whoever plays for long finds what was there at the beginning. With SECONDS=20 (or more) somebody is steered for so long, too: that wants
// a machine that does nothing else.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open } from './browser.mjs';

const SECONDS = Number(process.env.SECONDS ?? 20);
// By how much a page's memory may differ from one look to the next (bytes).
const MOST = 1_500_000;

// Numbers on the floor to each side of who walks (`ground.js`).
const SHOWN = 7;

// What the page holds after its garbage is collected, what the engine does (bytes), and how much is in the memory of the graphics.
async function held(page, session) {
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  const engine = await page.evaluate(() => studio.engine.call('memory'));
  const { geometries, textures } = await page.evaluate(() => studio.show.picture.stage.renderer.info.memory);
  return { page: usedSize, engine, geometries, textures };
}
const watch = async (page) => {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.enable');
  return () => held(page, session);
};

test('somebody who is steered for long takes no more memory than at the beginning', { timeout: (SECONDS + 90) * 1000, skip: process.env.SECONDS ? false : 'only where SECONDS says for how long' }, async (t) => {
  const page = await open(t);
  if (!page) return;
  const look = await watch(page);
  await page.click('#tab-steer');
  await page.waitForFunction(() => document.querySelector('.steer-out output')?.textContent === '0 m/s');
  await page.keyboard.down('w');
  await page.keyboard.down('a');
  await page.waitForTimeout(5000);
  const before = await look();
  await page.waitForTimeout(1000 * SECONDS);
  const after = await look();
  t.diagnostic(`${SECONDS} s: page ${before.page} to ${after.page} bytes, engine ${before.engine} to ${after.engine}`);
  assert.ok(after.page - before.page < MOST, `the page grew from ${before.page} to ${after.page} bytes`);
  assert.equal(after.engine, before.engine);
  // Numbers on the floor are kept to three times as far as they are shown (`numbers.js`).
  const kept = 4 * SHOWN;
  assert.ok(after.geometries <= before.geometries + 4 && after.textures <= before.textures + kept, JSON.stringify([before, after]));
  assert.ok(await page.evaluate(() => Math.hypot(studio.show.data.root[0], studio.show.data.root[2]) > 0.1), 'it walks');
});

test('walks that are planned one after the other leave nothing behind, and show the same skin', { timeout: 180_000 }, async (t) => {
  const page = await open(t, { width: 500, height: 400, still: true });
  if (!page) return;
  const look = await watch(page);
  const field = page.locator('[aria-label="Pace (steps/min)"]');
  const plan = async (pace) => {
    const key = await page.evaluate(() => studio.motion.key);
    await field.fill(String(pace));
    await field.press('Enter');
    await page.waitForFunction((old) => studio.motion.key !== old, key, { timeout: 30_000 });
    await page.waitForTimeout(100);
  };
  const points = () => page.evaluate(() => studio.show.data.body.points.reduce((sum, x, i) => sum + (i % 7) * x, 0));
  await page.evaluate(() => (globalThis.skin = studio.show.data.body));
  const [still] = [await points()];
  // What is compiled on the way, and kept of the last motions, is there after some.
  let pace = 80;
  const sixteen = async () => {
    for (let i = 0; i < 16; i += 1) await plan((pace += 0.75));
    return look();
  };
  let before = await sixteen();
  let after = await sixteen();
  // What grows grows again; what was compiled late does not.
  if (after.page - before.page >= MOST) [before, after] = [after, await sixteen()];
  t.diagnostic(`page ${before.page} to ${after.page} bytes, engine ${before.engine} to ${after.engine}, ${after.geometries} geometries, ${after.textures} textures`);
  assert.deepEqual([after.geometries, after.textures], [before.geometries, before.textures]);
  assert.ok(after.page - before.page < MOST, `the page grew from ${before.page} to ${after.page} bytes`);
  assert.ok(after.engine - before.engine <= 4_000_000, `the engine grew from ${before.engine} to ${after.engine} bytes`);
  assert.ok(await page.evaluate(() => studio.show.data.body === globalThis.skin), 'the skin is made once');
  assert.equal(await points(), still, 'and what is drawn of it leaves it as it is');
});
