// Somebody is steered as people do it: by keys, clicks, buttons and a gamepad.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open } from './browser.mjs';

// The panel, with somebody who stands.
async function steer(t, options) {
  const page = await open(t, options);
  if (!page) return null;
  await page.click('#tab-steer');
  await page.waitForFunction(() => document.querySelector('.steer-out output')?.textContent === '0 m/s');
  return page;
}
// Where the figure is: left and forward (m).
const place = (page) => page.evaluate(() => [studio.show.data.root[0], studio.show.data.root[2]]);
const out = (page, which) => page.locator('.steer-out output').nth(which).innerText();
const speed = async (page) => parseFloat(await out(page, 0));
const heading = async (page) => {
  const words = await out(page, 1);
  return words === 'straight on' ? 0 : parseFloat(words) * (words.includes('left') ? 1 : -1);
};
const stands = (page) => page.waitForFunction(() => document.querySelector('.steer-out output').textContent === '0 m/s', null, { timeout: 20_000 });
// Who turns on the spot goes nowhere, and turns on until the step is done.
async function faces(page) {
  for (let before = NaN; ; await page.waitForTimeout(1000)) {
    const now = await heading(page);
    if (now === before) return now;
    before = now;
  }
}
const goes = (page, more = 0.5) =>
  page.waitForFunction((least) => parseFloat(document.querySelector('.steer-out output').textContent) > least, more, { timeout: 20_000 });
const apart = ([a, b], [c, d]) => Math.hypot(a - c, b - d);

test('a held key walks, Shift is faster, and letting go stops', async (t) => {
  const page = await steer(t);
  if (!page) return;
  await page.keyboard.down('w');
  await goes(page, 1);
  const slow = await speed(page);
  await page.keyboard.down('Shift');
  await goes(page, slow + 0.2);
  await page.keyboard.up('Shift');
  await page.keyboard.up('w');
  await stands(page);
  const [left, forward] = await place(page);
  assert.ok(forward > 1 && Math.abs(left) < 0.4, `it went straight on, to ${left}, ${forward}`);
  assert.match(await out(page, 2), /steps\/min|–/);
  assert.equal(await page.evaluate(() => document.scrollingElement.scrollTop + document.querySelector('#tools').scrollTop), 0);
});

test('arrows turn on the spot, Q and E go aside, and neither goes through frames', async (t) => {
  const page = await steer(t);
  if (!page) return;
  await page.keyboard.down('ArrowRight');
  await page.waitForFunction(() => /(\d{2,})° to the right/.test(document.querySelectorAll('.steer-out output')[1].textContent), null, { timeout: 20_000 });
  await page.keyboard.up('ArrowRight');
  const faced = await faces(page);
  assert.ok(apart(await place(page), [0, 0]) < 0.3, 'it turned where it stood');
  const before = await place(page);
  await page.keyboard.down('q');
  await goes(page, 0.2);
  await page.waitForTimeout(1500);
  await page.keyboard.up('q');
  await stands(page);
  assert.ok(apart(await place(page), before) > 0.3, 'it went aside');
  assert.ok(Math.abs((await faces(page)) - faced) < 2, 'and faced as before');
  assert.ok(await page.evaluate(() => studio.show.isLive()));
});

test('what is typed into a field steers nobody', async (t) => {
  const page = await steer(t);
  if (!page) return;
  const field = page.getByLabel('Walking speed (m/s)');
  await field.focus();
  await page.keyboard.down('ArrowUp');
  await page.waitForTimeout(600);
  await page.keyboard.up('ArrowUp');
  assert.equal(await speed(page), 0);
  await field.fill('0.6');
  await field.blur();
  await page.keyboard.down('ArrowUp');
  await goes(page, 0.4);
  await page.waitForTimeout(1500);
  assert.ok((await speed(page)) < 0.8, 'as fast as was typed');
  await page.keyboard.up('ArrowUp');
});

test('a click on the floor sends it there, a ring marks the point, and a drag turns the view only', async (t) => {
  const page = await steer(t);
  if (!page) return;
  const { x, y, width, height } = await page.locator('#picture canvas').boundingBox();
  const rings = () => page.evaluate(() => studio.show.picture.stage.scene.children.flatMap((group) => group.children).filter((mesh) => mesh.name === 'ring' && mesh.visible).length);
  await page.mouse.move(x + 0.8 * width, y + 0.9 * height);
  await page.mouse.down();
  await page.mouse.move(x + 0.7 * width, y + 0.9 * height, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(500);
  assert.equal(await rings(), 0, 'a drag is no click');
  await page.mouse.click(x + 0.8 * width, y + 0.75 * height);
  await goes(page, 0.1);
  assert.equal(await rings(), 1);
  await stands(page);
  await page.waitForFunction(() => !studio.show.picture.stage.scene.children.flatMap((group) => group.children).some((mesh) => mesh.name === 'ring' && mesh.visible));
  assert.ok(apart(await place(page), [0, 0]) > 0.3, 'it went there');
});

test('buttons do it without a mouse, and the force of the ground is written beside its arrow', async (t) => {
  const page = await steer(t, { width: 390, height: 844, dark: true });
  if (!page) return;
  assert.match(await page.locator('.force.middle').innerText(), /^(9\d|10\d) % BW$/);
  const forward = page.getByRole('button', { name: 'Forward' });
  await forward.focus();
  await page.keyboard.press('Enter');
  assert.equal(await forward.getAttribute('aria-pressed'), 'true');
  await goes(page);
  await page.getByRole('button', { name: 'Backward' }).click();
  assert.equal(await forward.getAttribute('aria-pressed'), 'false', 'not both ways at once');
  await page.getByRole('button', { name: 'Stop' }).click();
  await stands(page);
});

test('the stick of a gamepad drives it, and stops with the stick', async (t) => {
  const page = await steer(t);
  if (!page) return;
  await page.evaluate(() => {
    globalThis.axes = [0.05, -1, 0, 0];
    navigator.getGamepads = () => [null, { connected: true, axes: globalThis.axes, buttons: [] }];
  });
  await goes(page, 0.8);
  await page.evaluate(() => globalThis.axes.fill(0.1));
  await stands(page);
});

test('a drag with Shift pulls the body along, an arm gives way, and buttons push without a mouse', async (t) => {
  const page = await steer(t);
  if (!page) return;
  const { x, y, width, height } = await page.locator('#picture canvas').boundingBox();
  const label = page.locator('.pull-label');
  await page.keyboard.down('Shift');
  await page.mouse.move(x + 0.5 * width, y + 0.38 * height);
  await page.mouse.down();
  await page.mouse.move(x + 0.75 * width, y + 0.36 * height, { steps: 8 });
  await page.waitForFunction(() => [...document.querySelectorAll('.pull-label')].some((one) => parseFloat(one.textContent) > 30));
  assert.match(await label.innerText(), /^\d+ N$/);
  await goes(page, 0.1);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  assert.equal(await label.count(), 0, 'the arrow goes with the hand');
  await stands(page);
  const before = await place(page);
  assert.ok(apart(before, [0, 0]) > 0.05, 'it came along');
  assert.equal(await heading(page), 0, 'and did not turn');
  await page.getByRole('button', { name: 'Push from behind' }).focus();
  await page.keyboard.press('Enter');
  await label.waitFor();
  await goes(page, 0.1);
  await stands(page);
  assert.ok((await place(page))[1] > before[1] + 0.1, 'pushed forward');
  assert.equal(await page.locator('.fault:visible').count(), 0);
});

test('limbs hang loose, another height begins anew, and another panel takes the keys back', async (t) => {
  const page = await steer(t);
  if (!page) return;
  const hand = () => page.evaluate(() => {
    const { links, positions } = studio.show.data;
    return positions[3 * links.findIndex(({ name }) => name === 'left_hand') + 1];
  });
  // A forearm that is bent a little hangs straight down where it is let loose.
  const held = await hand();
  await page.getByLabel('Left arm').check();
  await page.waitForTimeout(2500);
  assert.notEqual((await hand()).toFixed(4), held.toFixed(4));
  await page.getByText('Who walks').click();
  const tall = page.getByLabel('Height of the walker (m)');
  await tall.fill('1.4');
  await tall.blur();
  await page.waitForFunction(() => studio.show.data.size < 1.5, null, { timeout: 20_000 });
  assert.ok(await page.getByLabel('Left arm').isChecked());
  assert.equal(await page.locator('.notice').isHidden(), true);
  await page.click('#tab-walk');
  await page.waitForFunction(() => !studio.show.isLive());
  await page.evaluate(() => studio.show.clock.pause());
  const before = await page.evaluate(() => studio.show.clock.frame().index);
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await page.evaluate(() => studio.show.clock.frame().index), before, 'the arrows go through frames again');
});
