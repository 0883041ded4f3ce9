// The pictures of docs/studio.md: `node chores/pictures.mjs ../docs/studio`.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { STUDIO, fixture } from '../test/browser.mjs';

const folder = process.argv[2];
if (!folder) throw new Error('usage: node chores/pictures.mjs FOLDER');
mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-background-networking'] });
const page = await browser.newPage({ viewport: { width: 1200, height: 740 }, deviceScaleFactor: 1 });
page.on('pageerror', (error) => console.error(error.message));
await page.goto(`file://${STUDIO}`);
await page.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: 60_000 });
const shoot = async (name) => {
  await page.waitForTimeout(1500);
  await page.screenshot({ path: join(folder, `${name}.jpg`), type: 'jpeg', quality: 82 });
  console.log(`${name}.jpg`);
};
const pause = () => page.evaluate(() => studio.show.clock.pause());
const at = (share) => page.evaluate((share) => studio.show.clock.seek(share * studio.show.clock.last), share);

// Round a corner, while the slider's range is told.
await page.fill('[aria-label="Turn a step (°)"]', '10');
await page.keyboard.press('Enter');
await page.waitForSelector('.feasible:not([hidden])', { timeout: 60_000 });
await pause();
await at(0.55);
await shoot('walk');

await page.click('#tab-steer');
await page.waitForFunction(() => document.querySelector('.steer-out output')?.textContent === '0 m/s');
await page.click('text=Left arm');
await page.keyboard.down('ArrowUp');
await page.waitForTimeout(4000);
await page.keyboard.down('ArrowLeft');
await page.waitForTimeout(2500);
await shoot('steer');
await page.keyboard.up('ArrowLeft');
await page.keyboard.up('ArrowUp');

await page.click('#tab-joints');
await page.waitForSelector('.joint-list [role=option]');
await page.fill('.joint-tree input', 'right_elbow');
await page.click('.joint-list [data-joint="right_elbow"]');
const elbow = page.locator('.dof[aria-label="right_elbow.rx"]');
await elbow.locator('.bar-of').first().click();
await elbow.locator('select[aria-label=Mode]').selectOption({ label: await elbow.locator('select[aria-label=Mode] option', { hasText: /curve/i }).first().innerText() });
await page.waitForSelector('.curve-drawing');
await page.locator('.curve-drawing').scrollIntoViewIfNeeded();
await shoot('joints');

await page.click('#tab-scene');
await page.evaluate(() => studio.document.set(studio.document.text.replace('duration: 3.0', 'durration: 3.0')));
await shoot('scene');
await page.evaluate(() => studio.document.set(studio.document.text.replace('durration: 3.0', 'duration: 3.0')));

const subject = ['subject.osim', 'walk.mot', 'grf.mot', 'soles.ron'].map((name) => fixture(`subject/${name}`));
await page.setInputFiles('#files', subject);
await page.waitForFunction(() => studio.motion !== null && studio.show.data.joints.some(({ effort }) => effort), null, { timeout: 60_000 });
await pause();
await at(0.4);
await shoot('files');

await page.click('#tab-walk');
await page.click('.reset:visible');
await page.waitForFunction(() => document.querySelector('#title').textContent === 'A walk');
await page.click('#tab-compare');
await page.click('text=Keep this motion');
await page.click('#tab-walk');
await page.fill('[aria-label="Pace (steps/min)"]', '85');
await page.keyboard.press('Enter');
await page.waitForTimeout(2500);
await page.click('#tab-compare');
await page.selectOption('[aria-label="Stands"]', { index: 1 });
await page.selectOption('[aria-label="Goes along by"]', 'share');
await page.selectOption('[aria-label="Over"]', 'stride');
await pause();
await at(0.5);
await shoot('compare');
await browser.close();
