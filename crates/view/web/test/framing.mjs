// Whether the figure is in the picture, all of it, at any time.

import assert from 'node:assert/strict';
import { settle, stop } from './browser.mjs';

// When it is asked where the figure is, as shares of the motion's time.
const TIMES = Array.from({ length: 13 }, (_, i) => i / 12);
// Least extent of the figure over the whole motion, as a share of the picture's height or width, and the least share of its
// pixels that the figure covers: a thin rod in the narrow picture covers 0.001.
const LEAST_EXTENT = 0.3;
const LEAST_COVER = 0.0005;
const LEAST_CHANGE = 0.003;

// The figure's outline lies within the picture at all times, and fills a good part of it.
export async function inside(page, name) {
  const all = [Infinity, Infinity, -Infinity, -Infinity];
  const outlines = await page.evaluate((times) => {
    const { solaris } = window;
    const at = (time) => (solaris.seek(time), solaris.time());
    solaris.pause();
    const [first, last] = [at(-1e9), at(1e9)];
    return times.map((share) => (solaris.seek(first + share * (last - first)), solaris.outline()));
  }, TIMES);
  outlines.forEach(([left, top, right, bottom], i) => {
    const where = [left, top, right, bottom].map((edge) => edge.toFixed(3)).join(', ');
    const within = left >= 0 && top >= 0 && right <= 1 && bottom <= 1;
    assert(within, `${name}: at ${TIMES[i].toFixed(2)} of its time the figure leaves the picture: ${where}`);
    all.splice(0, 4, Math.min(all[0], left), Math.min(all[1], top), Math.max(all[2], right), Math.max(all[3], bottom));
  });
  const extent = Math.max(all[2] - all[0], all[3] - all[1]);
  assert(extent > LEAST_EXTENT, `${name}: the figure is small: over the whole motion it takes ${extent.toFixed(3)} of the picture`);
}

// Share of the pixels in which two PNGs differ.
const differing = (judge, shots) =>
  judge.evaluate(async (shots) => {
    const read = async (shot) => {
      const image = new Image();
      image.src = `data:image/png;base64,${shot}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const pen = canvas.getContext('2d');
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, image.width, image.height).data;
    };
    const [a, b] = await Promise.all(shots.map(read));
    let changed = 0;
    for (let i = 0; i < a.length; i += 4) {
      const apart = Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]);
      if (apart > 40) changed += 1;
    }
    return changed / (a.length / 4);
  }, shots);

const picture = async (page) => (await page.locator('#picture').screenshot()).toString('base64');

// The figure, or another part, is painted: without it the picture is another one.
export async function painted(page, judge, share, name, { part = 'body', least = LEAST_COVER } = {}) {
  await stop(page, share);
  const shot = await picture(page);
  await page.evaluate((part) => window.solaris.show(part, false), part);
  await settle(page);
  const covered = await differing(judge, [shot, await picture(page)]);
  await page.evaluate((part) => window.solaris.show(part, true), part);
  assert(covered > least, `${name}: at ${share} of its time the ${part} covers ${covered} of the picture`);
  return covered;
}

// The picture changes with the time.
export async function moves(page, judge, name) {
  const shots = [];
  for (const share of [0.37, 0.83]) {
    await stop(page, share);
    shots.push(await picture(page));
  }
  const changed = await differing(judge, shots);
  assert(changed > LEAST_CHANGE, `${name}: the picture must change with the time: ${changed} of it does`);
}
