// Whatever is dropped, there is an answer and the page goes on: files of the fixtures and of the fuzzer's seeds, as they are, cut off, and with
// bytes changed. MANY says how many (60).

import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { fixture, open } from './browser.mjs';

const COUNT = Number(process.env.MANY ?? 60);
// What is larger is cut: a page is asked for answers, not for patience.
const MOST = 200_000;

function filesOf(folder) {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? filesOf(path) : [path];
  });
}

// The same numbers in every run (mulberry32).
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

function mangled(bytes, next) {
  const copy = Buffer.from(bytes.subarray(0, MOST));
  const how = Math.floor(next() * 4);
  if (how === 0) return copy;
  if (how === 1) return copy.subarray(0, Math.floor(next() * copy.length));
  for (let i = 0; i < 1 + 20 * next() && copy.length > 0; i += 1) copy[Math.floor(next() * copy.length)] = Math.floor(next() * 256);
  if (how === 2) return copy;
  // A piece of it once more, somewhere.
  const [from, to, at] = [next(), next(), next()].map((share) => Math.floor(share * copy.length));
  return Buffer.concat([copy.subarray(0, at), copy.subarray(Math.min(from, to), Math.max(from, to)), copy.subarray(at)]);
}

test('files of any kind, whole and broken, are answered, and the page goes on', { timeout: 20 * 60_000 }, async (t) => {
  const page = await open(t, { width: 700, height: 500 });
  if (!page) return;
  const next = random(2026);
  const kinds = /\.(urdf|xml|osim|sdf|ron|csv|mot|sto|trc|c3d|bvh|glb|gltf|html)$/i;
  const all = [...filesOf(fixture('')), ...filesOf(fixture('../fuzz/seeds'))].filter((path) => !path.includes('golden') && statSync(path).size > 0);
  const known = all.filter((path) => kinds.test(path));
  assert.ok(known.length > 20, `${known.length} files`);
  let longest = 0;
  for (let i = 0; i < COUNT; i += 1) {
    const path = known[Math.floor(next() * known.length)];
    const buffer = mangled(readFileSync(path), next);
    const name = `${i}-${basename(path)}`;
    const begun = Date.now();
    await page.evaluate(() => (document.querySelector('.said').textContent = ''));
    await page.setInputFiles('#files', { name, mimeType: 'application/octet-stream', buffer });
    await page.waitForFunction(() => {
      const said = document.querySelector('.said').textContent;
      return said !== '' && !said.startsWith('Opening');
    }, null, { timeout: 60_000 }).catch((error) => assert.fail(`${name} (${buffer.length} bytes) had no answer: ${error.message}`));
    longest = Math.max(longest, Date.now() - begun);
    const broken = await page.evaluate(() => /engine broke/i.test(document.body.innerText));
    assert.ok(!broken, `${name} broke the engine`);
  }
  // It walks as before.
  await page.click('#tab-walk');
  await page.waitForFunction(() => document.querySelector('#title').textContent === 'A walk', null, { timeout: 30_000 });
  t.diagnostic(`${COUNT} files, the longest answer ${longest} ms`);
});
