// Whether the ground is drawn where feet are on it, and seen.

import assert from 'node:assert/strict';
import { painted } from './framing.mjs';
import { settle } from './browser.mjs';

// How far a centre of pressure may lie beside the ground (m), and the least share of the picture that ground which is not level
// covers.
const MOST = 2e-3;
const LEAST_COVER = 0.05;

// Places where feet bear more than a part of the weight, with the height of the ground that is drawn there.
const prints = (page) =>
  page.evaluate(() => {
    const data = JSON.parse(document.getElementById('data').textContent);
    const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
    const places = [];
    for (const { cop, force } of data.feet) {
      const [at, loads] = [new Float32Array(bytes(cop.f32)), new Int16Array(bytes(force.i16 ?? ''))];
      for (let i = 0; i < loads.length; i += 3) {
        if (force.offset + force.scale * loads[i + 1] < 0.1 * (data.weight ?? 0)) continue;
        places.push({ height: at[i + 1], drawn: window.solaris.ground(at[i], at[i + 2]) });
      }
    }
    return { places, uneven: data.ground.relief !== undefined, solid: data.ground.solid };
  });

// Says how many heights the ground was found at.
export async function carries(page, judge, name) {
  await settle(page);
  const { places, uneven, solid } = await prints(page);
  if (!solid || places.length === 0) return;
  const off = (place) => Math.abs(place.height - (place.drawn ?? Infinity));
  const worst = places.reduce((a, b) => (off(b) > off(a) ? b : a));
  assert(off(worst) < MOST, `${name}: a foot presses at ${worst.height} m where the drawn ground is at ${worst.drawn} m`);
  if (!uneven) return;
  const heights = places.map(({ height }) => height);
  const rise = Math.max(...heights) - Math.min(...heights);
  assert(rise > 0.05, `${name}: its ground is not level, and all feet press within ${rise} m of height`);
  await painted(page, judge, 0.55, `${name}, its ground`, { part: 'ground', least: LEAST_COVER });
}
