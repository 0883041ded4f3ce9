import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { choose, open, STUDIO, text } from './browser.mjs';

const save = async (page, label, folder) => {
  const [download] = await Promise.all([page.waitForEvent('download', { timeout: 90_000 }), pick(page, label)]);
  const path = join(folder, download.suggestedFilename());
  await download.saveAs(path);
  return { name: download.suggestedFilename(), path, bytes: readFileSync(path) };
};
async function pick(page, label) {
  await page.click('#save summary');
  await page.click(`#save button:has-text("${label}")`);
}
function folder(t) {
  const made = mkdtempSync(join(tmpdir(), 'studio-'));
  t.after(() => rmSync(made, { recursive: true }));
  return made;
}
const head = ({ bytes }, length = 60) => bytes.subarray(0, length).toString('latin1');

test('each format begins as it must', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const into = folder(t);
  const table = await save(page, 'Table', into);
  assert.equal(table.name, 'A walk.csv');
  assert.match(table.bytes.toString(), /(^|\n)time,/);
  assert.match((await save(page, 'OpenSim motion', into)).bytes.toString().slice(0, 400), /nRows=\d+[\s\S]*endheader/);
  assert.match(head(await save(page, 'Motion capture', into)), /^HIERARCHY\nROOT /);
  const glb = await save(page, '3D animation', into);
  assert.equal(head(glb, 4), 'glTF');
  assert.equal(glb.bytes.readUInt32LE(8), glb.bytes.length);
  assert.match(head(await save(page, 'USD', into)), /^#usda 1\.0/);
  assert.match(head(await save(page, 'Scene (.ron)', into)), /^Scene\(/);
  const png = await save(page, 'Picture', into);
  assert.equal(head(png, 8), '\x89PNG\r\n\x1a\n');
  // Not one colour alone.
  assert.ok(png.bytes.length > 8000, `${png.bytes.length} bytes`);
});

test('a film is one pass of the motion, and can be stopped', async (t) => {
  const page = await open(t, { still: true, width: 700, height: 500 });
  if (!page) return;
  const [download] = await Promise.all([
    page.waitForEvent('download', { timeout: 60_000 }),
    (async () => {
      await pick(page, 'Film');
      await page.waitForFunction(() => Number(document.querySelector('.filming progress')?.value) > 0.1);
      await page.click('.filming button');
    })(),
  ]);
  const path = join(folder(t), 'film.webm');
  await download.saveAs(path);
  const bytes = readFileSync(path);
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3);
  assert.ok(bytes.includes('webm') && bytes.length > 2000, `${bytes.length} bytes`);
  assert.equal(await page.isVisible('.filming'), false);
});

test('the saved page opens by itself and moves', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const html = await save(page, 'Page for a colleague', folder(t));
  assert.match(head(html, 20), /^<!doctype html>/);
  const shown = await page.context().newPage();
  await shown.goto(`file://${html.path}`);
  await shown.waitForFunction(() => globalThis.solaris?.ready);
  assert.equal(await text(shown, 'h1'), 'A walk');
  await shown.evaluate(() => solaris.seek(0));
  const before = await shown.evaluate(() => solaris.outline());
  await shown.evaluate(() => solaris.seek(3));
  assert.notDeepEqual(await shown.evaluate(() => solaris.outline()), before);
  assert.match(await shown.locator('#summary').textContent(), /Step length/);
  // Dropped again it is shown as it is.
  await choose(page, { name: 'walk.html', mimeType: 'text/html', buffer: html.bytes });
  assert.match(await text(page, '.roles'), /a page of this program/);
  assert.equal(await text(page, '#title'), await page.evaluate(() => studio.show.data.figure));
  assert.ok(await page.evaluate(() => studio.motion === null && studio.show.data.time.length > 100));
});

test('a link gives back the scene and the walk', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const scene = await page.evaluate(() => studio.document.text.replace('73.0', '61.0'));
  await page.evaluate((next) => studio.document.set(next), scene);
  await page.fill('[aria-label="Height (m)"]', '1.6');
  await page.press('[aria-label="Height (m)"]', 'Tab');
  await page.selectOption('[aria-label="Gait"]', 'run');
  await pick(page, 'Link');
  const address = await page.inputValue('[aria-label="Link"]');
  assert.match(address, /studio\.html#s=[\w-]+$/);
  const other = await page.context().newPage();
  await other.goto(address);
  await other.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: 60_000 });
  assert.equal(await other.evaluate(() => studio.document.text), scene);
  assert.equal(await other.inputValue('[aria-label="Height (m)"]'), '1.6');
  assert.equal(await other.inputValue('[aria-label="Gait"]'), 'run');
  assert.equal(await text(other, '#title'), 'A run');
});

test('a link that is none is told, and the studio begins', async (t) => {
  const page = await open(t, { still: true, hash: '#s=nonsense' });
  if (!page) return;
  assert.match(await text(page, '.notice'), /the link cannot be opened/);
  assert.equal(await text(page, '#title'), 'A walk');
});

// A page as the program writes it, of data that a studio has.
function pageOf(data, into) {
  const asset = (name) => readFileSync(fileURLToPath(new URL(`../../crates/view/assets/${name}`, import.meta.url)), 'utf8');
  const values = { title: 'Handed over', style: asset('viewer.css'), legend: '', table: '', data: data.replaceAll('<', '\\u003c'), viewer: asset('viewer.js') };
  const path = join(into, 'motion.html');
  writeFileSync(path, asset('page.html').replace(/\{\{(\w+)\}\}/g, (_, name) => values[name]));
  return `file://${path}`;
}

test('a page hands its motion over to the studio beside it', async (t) => {
  const studio = await open(t, { still: true });
  if (!studio) return;
  const into = folder(t);
  const url = pageOf(await studio.evaluate(() => globalThis.studio.motion.data), into);
  await studio.close();
  copyFileSync(STUDIO, join(into, 'studio.html'));
  const page = await open(t, { still: true, url, ready: false });
  const [beside] = await Promise.all([page.context().waitForEvent('page'), page.click('#studio')]);
  await beside.waitForFunction(() => document.querySelector('#title')?.textContent === 'Handed over', null, { timeout: 60_000 });
  assert.ok((await beside.evaluate(() => globalThis.studio.show.data.time.length)) > 100);
  assert.equal(await page.isVisible('#no-studio'), false);
});

test('a page with no studio beside it says how to get one', async (t) => {
  const studio = await open(t, { still: true });
  if (!studio) return;
  const url = pageOf(await studio.evaluate(() => globalThis.studio.motion.data), folder(t));
  await studio.close();
  const page = await open(t, { still: true, url, ready: false });
  await page.click('#studio');
  await page.waitForSelector('#no-studio:not([hidden])', { timeout: 30_000 });
  assert.match(await text(page, '#no-studio'), /solaris studio -o studio\.html/);
});
