// Whether words cover each other, are cut off, or make the page scroll sideways; and whether controls have names.

import assert from 'node:assert/strict';
import { stop } from './browser.mjs';

// Where labels are looked at, as shares of the motion's time.
const TIMES = [0, 0.12, 0.3, 0.8];

// Pairs of visible elements that must not cover each other, and those that stick out of what holds them.
const collisions = (page) =>
  page.evaluate(() => {
    const boxes = (selector) =>
      [...document.querySelectorAll(selector)]
        .filter((element) => element.checkVisibility() && element.textContent.trim() !== '')
        .map((element) => ({ text: element.textContent, box: element.getBoundingClientRect() }));
    const cover = (a, b) =>
      Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0.5 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.5;
    const found = [];
    const groups = ['#picture .force', '.plot h2, .readout', 'h1, .legend, .menu summary', '.bar > *', '.chooser > *', '#tabs > *'];
    for (const group of groups) {
      const all = boxes(group);
      all.forEach(({ text, box }, i) =>
        all.slice(0, i).forEach((other) => cover(box, other.box) && found.push(`'${text}' and '${other.text}' overlap`)),
      );
    }
    const frame = document.getElementById('picture').getBoundingClientRect();
    for (const { text, box } of boxes('#picture .force')) {
      const within = box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
      if (!within) found.push(`'${text}' leaves the picture`);
    }
    return found;
  });

// What is wider than its place: the page, or a panel of it.
const overflow = (page) =>
  page.evaluate(() =>
    [document.documentElement, ...document.querySelectorAll('header, .bar, aside, .panel, .plot header')]
      .filter((element) => element.scrollWidth > element.clientWidth + 1)
      .map((element) => `${element.id || element.className || element.localName}: ${element.scrollWidth - element.clientWidth} px too wide`),
  );

// Each tab in turn, or once where there are none. `look` is called with the tab's name.
export async function eachTab(page, look) {
  const tabs = page.locator('#tabs:visible button');
  for (let i = 0; i < Math.max(1, await tabs.count()); i += 1) {
    if (await tabs.count()) await tabs.nth(i).click();
    await look(i);
  }
  if (await tabs.count()) await tabs.first().click();
}

export async function fits(page, name) {
  const times = (await page.locator('#picture .force').count()) ? TIMES : [0];
  for (const share of times) {
    await stop(page, share);
    assert.deepEqual(await collisions(page), [], `${name}, at ${share} of its time`);
  }
  await stop(page, 0);
  await eachTab(page, async (tab) => {
    assert.deepEqual(await collisions(page), [], `${name}, tab ${tab}`);
    assert.deepEqual(await overflow(page), [], `${name}, tab ${tab}, must not scroll sideways`);
  });
}

// Where there is room for one panel, there are tabs; the keys are in a menu.
export async function folds(page, name) {
  const panels = () => page.locator('.panel:visible').count();
  const tabs = await page.locator('#tabs button').count();
  if (tabs > 1) {
    assert(await page.locator('#tabs').isVisible(), `${name}: the panels are tabs`);
    await eachTab(page, async () => assert.equal(await panels(), 1, `${name}: one panel at a time`));
    await page.locator('#tabs button').first().focus();
    const frame = await page.evaluate(() => window.solaris.frame());
    await page.keyboard.press('ArrowRight');
    const chosen = await page.evaluate(() => document.activeElement.getAttribute('aria-selected'));
    assert.equal(chosen, 'true', `${name}: an arrow key goes to the next tab`);
    assert.equal(await page.evaluate(() => window.solaris.frame()), frame, `${name}: and not to the next frame`);
    await page.locator('#tabs button').first().click();
  }
  const hints = page.locator('#help dl');
  assert(!(await hints.isVisible()), `${name}: the keys are in a menu`);
  await page.locator('#help summary').click();
  const box = await hints.boundingBox();
  const { width } = page.viewportSize();
  assert(box && box.x >= 0 && box.x + box.width <= width, `${name}: the menu is in view: ${JSON.stringify(box)}`);
  await page.keyboard.press('Escape');
  assert(!(await hints.isVisible()), `${name}: Escape closes the menu`);
}

export async function named(page) {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll('button, select, input, summary, canvas[role=img], [role=tablist]')]
      .filter((element) => !element.getAttribute('aria-label') && !element.labels?.length && !element.textContent.trim())
      .map((element) => element.outerHTML.slice(0, 80)),
  );
  assert.deepEqual(nameless, [], 'controls need names');
}
