// Whether bands are drawn around the curves that have one, and told beside them.

import assert from 'node:assert/strict';
import { settle } from './browser.mjs';

// Least share of a plot's pixels that its bands cover, and the most that the edges of its lines do, which may be as opaque.
const LEAST_COVER = 0.005;
const MOST_EDGES = 0.002;

// Of each plot of the joint that is shown: what is read off, the share of its pixels that are as opaque as a band, and whether
// any of these lies at the upper or lower edge.
const plots = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('#joints .plot:not([hidden])')].map((section) => {
      const canvas = section.querySelector('canvas');
      const [frame, over] = [canvas, section.querySelector('.u-over')].map((element) => element.getBoundingClientRect());
      const scale = canvas.width / frame.width;
      const [left, top, width, height] = [over.left - frame.left, over.top - frame.top, over.width, over.height].map((length) =>
        Math.round(scale * length),
      );
      const { data } = canvas.getContext('2d').getImageData(left, top, width, height);
      const rows = [];
      for (let i = 0; i < width * height; i += 1) {
        // 18 % on a light page, 26 % on a dark one.
        if ([46, 66].some((opacity) => Math.abs(data[4 * i + 3] - opacity) <= 1)) rows.push(Math.floor(i / width));
      }
      return {
        readout: section.querySelector('.readout').textContent,
        cover: rows.length / (width * height),
        leaves: rows.length > 0 && (rows[0] === 0 || rows.at(-1) === height - 1),
      };
    }),
  );

// Shows the first joint with a band, or the first one where none has any.
export async function bands(page, name) {
  const { joints, caption } = await page.evaluate(() => {
    const data = JSON.parse(document.getElementById('data').textContent);
    const has = (plot) => plot.lines.some(({ spread }) => spread);
    const of = ({ position, effort, power }) => [position, effort, power].filter(Boolean).map(has);
    return { joints: data.joints.map(of), caption: data.bands ?? '' };
  });
  const chosen = Math.max(0, joints.findIndex((joint) => joint.includes(true)));
  if (joints.length === 0) return;
  if (chosen < 3) await page.locator('.chooser button').nth(chosen).click();
  else await page.locator('.chooser select').selectOption(String(chosen));
  await settle(page);
  const shown = await plots(page);
  assert.equal(shown.length, joints[chosen].length, `${name}: a plot each`);
  shown.forEach(({ readout, cover, leaves }, i) => {
    const banded = joints[chosen][i];
    const what = `${name}: '${readout}', with${banded ? '' : 'out'} a band: ${cover} of it is as opaque as one`;
    assert.equal(readout.includes('±'), banded, what);
    assert(banded ? cover > LEAST_COVER : cover < MOST_EDGES, what);
    assert(!leaves, `${what}, and the axis must hold it`);
  });
  const text = page.locator('#joints .caption');
  assert.equal(await text.isVisible(), caption !== '' && joints[chosen].includes(true), `${name}: a caption where there is a band`);
  if (caption) assert((await text.textContent()).includes(caption), `${name}: the caption is the caller's`);
}
