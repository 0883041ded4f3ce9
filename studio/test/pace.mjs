// How sharply is drawn where drawing is slow: the pace of the picture, on screens that are made up.

import assert from 'node:assert/strict';
import { test } from 'node:test';

globalThis.devicePixelRatio = 1;
const { makePace } = await import('../../crates/view/web/src/pace.js');

// Draws for so many seconds on a screen of `rate` pictures a second, where one takes `cost` (ms) at a sharpness and a time (s); the sharpness of
// each picture.
function drawn(seconds, rate, cost) {
  let ratio = 0;
  const pace = makePace({ getPixelRatio: () => ratio, setPixelRatio: (to) => (ratio = to) }, true);
  const [all, each] = [[], 1000 / rate];
  for (let now = 0; now < 1000 * seconds; ) {
    pace.move(now);
    all.push(ratio);
    now += each * Math.ceil(cost(ratio, now / 1000) / each - 1e-9);
  }
  return all;
}
const share = (all, ratio) => all.filter((one) => one === ratio).length / all.length;

test('what is quick enough stays sharp', () => {
  assert.equal(share(drawn(30, 60, () => 12), 1), 1);
});

test('a picture is drawn less sharply where that helps, however little of it does not', () => {
  // 24 ms, 18 ms, 12 ms: of sixty pictures a second the first two make thirty.
  const all = drawn(30, 60, (ratio) => 24 * ratio);
  assert.ok(share(all, 0.5) > 0.9, `${share(all, 0.5)}`);
  assert.equal(all.at(-1), 0.5);
});

test('a screen of thirty pictures a second keeps them sharp but for some tries', () => {
  assert.ok(share(drawn(120, 30, () => 12), 1) > 0.9);
});

test('what another program slowed down is tried anew', () => {
  const all = drawn(60, 60, (ratio, time) => (time < 5 ? 30 : 20 * ratio));
  assert.equal(all.at(-1), 0.75);
});
