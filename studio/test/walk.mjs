// What a walk is asked by its panel, and what comes of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, text } from './browser.mjs';

const field = (page, label) => page.locator(`input[type=number][aria-label="${label}"]`);
const type = async (page, label, value) => {
  const before = await page.evaluate(() => studio.motion.key);
  await field(page, label).fill(String(value));
  await field(page, label).press('Enter');
  await page.waitForFunction((before) => studio.motion.key !== before, before);
};
const choose = async (page, label, value) => {
  const before = await page.evaluate(() => studio.motion.key);
  await page.selectOption(`select[aria-label="${label}"]`, value);
  await page.waitForFunction((before) => studio.motion.key !== before, before);
};
const unfold = (page, title) => page.click(`summary:text-is("${title}")`);
const title = (page) => text(page, '#title');
const faults = (page) => page.locator('.slider .fault:visible').allInnerTexts();
// How far a link goes ahead of another and behind it, over the walk (m).
const swing = (page, ...names) =>
  page.evaluate((names) => {
    const { links, positions, time } = studio.show.data;
    const [link, of] = names.map((name) => links.findIndex((one) => one.name === name));
    const ahead = [...time].map((_, frame) => positions[3 * (frame * links.length + link) + 2] - positions[3 * (frame * links.length + of) + 2]);
    return Math.max(...ahead) - Math.min(...ahead);
  }, names);
const rise = (page) =>
  page.evaluate(() => {
    const { root } = studio.show.data;
    return root.at(-2) - root[1];
  });

test('numbers of the style are degrees, and what they can be is marked', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await unfold(page, 'Style');
  const usual = await swing(page, 'left_hand', 'pelvis');
  await type(page, 'Arm swing (°)', 40);
  const wide = await swing(page, 'left_hand', 'pelvis');
  await type(page, 'Arm swing (°)', 5);
  const stiff = await swing(page, 'left_hand', 'pelvis');
  assert.ok(stiff < 0.6 * usual && usual < 0.8 * wide, `${stiff}, ${usual}, ${wide} m`);
  await page.waitForFunction(() => /can be had from 0 to/.test(document.querySelector('.slider:has([aria-label="Arm swing (°)"]) .feasible').title));
  await type(page, 'Pelvic rotation (°)', 9);
  assert.deepEqual(await faults(page), []);
  // Back to people's.
  await page.locator('.slider:has([aria-label="Arm swing (°)"]) .reset').click();
  await page.waitForFunction(() => document.querySelector('[aria-label="Arm swing (°)"]').value === '20');
});

test('stairs are climbed, loads are carried, and a link says all of it', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await choose(page, 'Ground', 'stairs');
  assert.equal(await title(page), 'A walk up 6 stairs');
  assert.ok(Math.abs((await rise(page)) - 6 * 0.17) < 0.05);
  assert.equal(await field(page, 'Turn a step (°)').isVisible(), false);
  await type(page, 'Rise of a stair (m)', -0.15);
  // What it can be is what it can be on the way down.
  await page.waitForFunction(() => /can be had from -0\.2 to -0\.1/.test(document.querySelector('.slider:has([aria-label="Rise of a stair (m)"]) .feasible').title));
  await type(page, 'Stairs', 4);
  assert.equal(await title(page), 'A walk down 4 stairs');
  assert.ok(Math.abs((await rise(page)) + 4 * 0.15) < 0.05);
  await unfold(page, 'Loads, unequal legs, a cane');
  await type(page, 'In the right hand (kg)', 5);
  await type(page, 'Left leg shorter (mm)', 12);
  assert.equal(await title(page), 'A walk down 4 stairs, 5 kg in the right hand, left leg 12 mm shorter');
  // What cannot be carried is said beside it.
  await field(page, 'In the right hand (kg)').fill('60');
  await field(page, 'In the right hand (kg)').press('Enter');
  await page.waitForFunction(() => [...document.querySelectorAll('.slider .fault')].some((one) => /can carry 0 to 21\.9 kg/.test(one.textContent)));
  await type(page, 'In the right hand (kg)', 5);
  assert.deepEqual(await faults(page), []);
  await page.click('#save summary');
  await page.click('#save button:has-text("Link")');
  const link = await page.inputValue('[aria-label="Link"]');
  const other = await open(t, { still: true, url: link });
  assert.equal(await title(other), 'A walk down 4 stairs, 5 kg in the right hand, left leg 12 mm shorter');
  await choose(other, 'Ground', 'slope');
  await type(other, 'Slope (°)', 6);
  assert.match(await title(other), /^A walk up a slope of 6°/);
  // A slope of nothing is level ground.
  await type(other, 'Slope (°)', 0);
  assert.ok(await other.evaluate(() => !studio.show.data.ground.relief));
});

test('what cannot be had with a run, a slope or key postures is left out', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await unfold(page, 'Style');
  await choose(page, 'Manner', 'sad');
  assert.equal(await title(page), 'A walk, sad');
  await unfold(page, 'Loads, unequal legs, a cane');
  await type(page, 'Left leg shorter (mm)', 10);
  await type(page, 'Steps differ (× people’s)', 1);
  await choose(page, 'Gait', 'run');
  assert.equal(await title(page), 'A run');
  assert.equal(await field(page, 'Left leg shorter (mm)').isVisible(), false);
  await choose(page, 'Gait', 'walk');
  await choose(page, 'Ground', 'slope');
  await type(page, 'Slope (°)', -5);
  assert.equal(await title(page), 'A walk down a slope of 5°, sad, left leg 10 mm shorter');
  assert.equal(await field(page, 'Steps differ (× people’s)').isVisible(), false);
  await choose(page, 'Way of walking', '5');
  assert.equal(await title(page), 'A walk');
  assert.equal(await field(page, 'Arm swing (°)').isVisible(), false);
  await choose(page, 'Way of walking', '');
  await choose(page, 'Ground', '');
  await type(page, 'Left leg shorter (mm)', 0);
  await choose(page, 'Left side', 'drop_foot');
  assert.equal(await title(page), 'A walk, sad, left side: drop foot');
});

test('a hand holds a cane on level ground', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await unfold(page, 'Loads, unequal legs, a cane');
  assert.equal(await field(page, 'It bears (% of the force)').isVisible(), false);
  await choose(page, 'A cane', 'left');
  assert.equal(await title(page), 'A walk, a cane in the left hand');
  await type(page, 'It bears (% of the force)', 20);
  assert.deepEqual(await faults(page), []);
  await choose(page, 'Ground', 'slope');
  assert.equal(await field(page, 'It bears (% of the force)').isVisible(), false);
  assert.doesNotMatch(await title(page), /cane/);
});

test('a run begins and ends as it is chosen', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  assert.equal(await page.locator('select[aria-label="Begins"]').isVisible(), false);
  await choose(page, 'Gait', 'run');
  await choose(page, 'Begins', 'walking');
  assert.equal(await title(page), 'A run, begun in a walk');
  await choose(page, 'Ends', 'standing');
  assert.equal(await title(page), 'A run, begun in a walk, ended in standing');
  await choose(page, 'Gait', 'walk');
  assert.equal(await title(page), 'A walk');
});
