import assert from 'node:assert/strict';
import { test } from 'node:test';
import { choose, open, text } from './browser.mjs';

const lines = (page) => page.$$eval('#panel-compare svg.chart path.line', (paths) => paths.map((path) => [path.classList.contains('dashed'), path.getAttribute('d').length > 200]));

test('a walk that is kept stands beside the next one, dashed in the chart', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await page.click('#tab-compare');
  await page.click('text=Keep this motion');
  await page.click('#tab-walk');
  await page.fill('[aria-label="Pace (steps/min)"]', '90');
  await page.press('[aria-label="Pace (steps/min)"]', 'Tab');
  await page.waitForFunction(() => document.querySelector('#panel-numbers')?.textContent.includes('90'));
  await page.click('#tab-compare');
  await page.selectOption('[aria-label="Quantity"]', { label: await first(page, /^knee.*left.*\(°\)$/i) });
  assert.deepEqual(await lines(page), [[false, true], [true, true]]);
  const ghost = () => page.evaluate(() => studio.show.picture.stage.scene.getObjectByName('ghost').children[0].position.toArray());
  await page.evaluate(() => { studio.show.clock.pause(); studio.show.clock.seek(2); });
  const by = await ghost();
  await page.selectOption('[aria-label="Goes along by"]', 'share');
  assert.notDeepEqual(await ghost(), by);
  // Over the stride both go from 0 to 100.
  await page.selectOption('[aria-label="Over"]', 'stride');
  assert.equal((await lines(page)).length, 2);
  // The kept one is gone when it is let go.
  await page.click('text=Let it go');
  assert.equal((await lines(page)).length, 1);
  assert.equal(await page.evaluate(() => studio.show.picture.stage.scene.getObjectByName('ghost') ?? null), null);
});

test('people lie behind the curves of a stride', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const bands = () => page.locator('#panel-compare svg.chart path.band').count();
  await page.click('#tab-compare');
  await page.selectOption('[aria-label="Quantity"]', 'Knee flexion, right');
  assert.equal(await bands(), 0);
  await page.selectOption('[aria-label="Over"]', 'stride');
  await page.waitForSelector('#panel-compare svg.chart path.band');
  assert.equal(await bands(), 2);
  assert.match(await text(page, '#panel-compare .chart-values'), /people, free pace/);
  // At the pointer: a knee in mid-swing, where people have 59 ± 6.
  const chart = page.locator('#panel-compare svg.chart');
  await chart.scrollIntoViewIfNeeded();
  const box = await chart.boundingBox();
  await page.mouse.move(box.x + 44 + 0.72 * (box.width - 54), box.y + box.height / 2);
  const [, mean, deviation] = /people, free pace: ([\d.]+) ± ([\d.]+) °/.exec(await text(page, '#panel-compare .chart-values'));
  assert.ok(Math.abs(mean - 59) < 2 && Math.abs(deviation - 6) < 2, `${mean} ± ${deviation}`);
  // Nobody has measured elbows there; and it can be put out.
  await page.selectOption('[aria-label="Quantity"]', 'Elbow flexion, right');
  assert.equal(await bands(), 0);
  await page.selectOption('[aria-label="Quantity"]', 'Vertical force, left');
  await page.waitForSelector('#panel-compare svg.chart path.band');
  await page.click('text=People behind it');
  assert.equal(await bands(), 0);
  // Slowly people bend it less.
  await page.click('text=People behind it');
  await page.click('#tab-walk');
  await page.fill('[aria-label="Pace (steps/min)"]', '70');
  await page.press('[aria-label="Pace (steps/min)"]', 'Tab');
  await page.waitForFunction(() => document.querySelector('#panel-numbers')?.textContent.includes('70'));
  await page.click('#tab-compare');
  await page.waitForFunction(() => /slow pace/.test(document.querySelector('#panel-compare .chart-values').textContent));
});

async function first(page, pattern) {
  const labels = await page.$$eval('[aria-label="Quantity"] option', (options) => options.map((option) => option.textContent));
  const found = labels.find((label) => pattern.test(label));
  assert.ok(found, `${pattern} in ${labels}`);
  return found;
}

test('an angle is drawn over its velocity, with values at the pointer', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await page.click('#tab-compare');
  const angle = await first(page, /^knee.*left.*\(°\)$/i);
  await page.selectOption('[aria-label="Quantity"]', { label: angle });
  await page.selectOption('[aria-label="Over"]', { label: await first(page, /^knee.*left: velocity/i) });
  const chart = page.locator('#panel-compare svg.chart');
  const box = await chart.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  assert.match(await text(page, '#panel-compare .chart-values'), /[\d.]+ ° at [−\d.]+ °\/s/);
});

test('the distance of two points of an arm is its length', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await page.evaluate(() => { studio.show.clock.pause(); studio.show.clock.seek(2); });
  await page.click('#tab-compare');
  await page.click('text=Pick two points');
  // Where two links are in the picture.
  const at = (name) => page.evaluate((link) => {
    const { picture, data } = studio.show;
    const bone = picture.body().group.children[data.links.findIndex((one) => one.name === link)];
    const place = bone.position.clone().project(picture.stage.camera);
    const { left, top, width, height } = picture.stage.renderer.domElement.getBoundingClientRect();
    return [left + ((1 + place.x) / 2) * width, top + ((1 - place.y) / 2) * height];
  }, name);
  await page.mouse.click(...(await at('head')));
  assert.match(await text(page, '#panel-compare'), /click another point/);
  await page.mouse.click(...(await at('pelvis')));
  const said = await text(page, '#over .distance');
  const metres = Number(/^([\d.]+) m$/.exec(said)?.[1]);
  assert.ok(metres > 0.3 && metres < 1, said);
  // Over time it is a curve.
  assert.match(await page.$eval('[aria-label="Quantity"]', (select) => select.value), /^Distance/);
  assert.equal((await lines(page)).length, 1);
});

test('a link leaves its path', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await page.click('#tab-compare');
  const link = await page.evaluate(() => studio.show.data.links.at(-1).name);
  await page.selectOption('[aria-label="Path of"]', link);
  assert.equal(await page.evaluate(() => studio.show.picture.stage.scene.getObjectByName('trail').geometry.attributes.position.count === studio.show.data.time.length), true);
  await page.click(`[aria-label="Take the path of ${link} away"]`);
  assert.equal(await page.evaluate(() => studio.show.picture.stage.scene.getObjectByName('trail') ?? null), null);
});

test('what stands still cannot be kept, and says so', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await choose(page, 'figures/arm.urdf');
  await page.waitForSelector('#panel-files .about h2');
  await page.click('#tab-compare');
  await page.click('text=Keep this motion');
  assert.match(await text(page, '.notice'), /no motion to keep/);
});
