// Whether the page plays, stops and goes to a time.

import assert from 'node:assert/strict';
import { time } from './browser.mjs';

export async function plays(page) {
  const began = performance.now();
  await page.evaluate(() => (window.solaris.seek(0), window.solaris.play()));
  const start = await time(page);
  // A busy machine may take long to draw: time must not stand still, and not go faster than a clock but for one tick.
  await page.waitForFunction((start) => window.solaris.time() > start + 0.2, start, { timeout: 30000 });
  const later = await time(page);
  const passed = (performance.now() - began) / 1000;
  assert(later < start + passed + 0.6, `time must not run ahead while playing: ${start} → ${later} in ${passed} s`);
  await page.keyboard.press('Space');
  const paused = await time(page);
  await page.waitForTimeout(300);
  assert.equal(await time(page), paused, 'time must stand still after the space bar');
}

export async function seeks(page) {
  const { first, last, frame, next, before } = await page.evaluate(() => {
    window.solaris.pause();
    window.solaris.seek(-1e9);
    const first = window.solaris.time();
    window.solaris.seek(1e9);
    const last = window.solaris.time();
    window.solaris.seek((first + last) / 2);
    const frame = window.solaris.frame();
    document.getElementById('forth').click();
    const next = window.solaris.frame();
    document.getElementById('back').click();
    return { first, last, frame, next, before: window.solaris.frame() };
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
    const part = (at - first) / (last - first);
    assert(Math.abs(part - 0.25) < 0.05, `a click on a plot seeks: ${at} from ${first} to ${last}`);
  }
}
