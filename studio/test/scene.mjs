// What people do with the panel of scenes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { open } from './browser.mjs';

// The panel, with its figure standing.
async function begin(t, options) {
  const page = await open(t, options);
  if (!page) return null;
  await page.click('#tab-scene');
  await page.waitForFunction(() => globalThis.studio.show.isLive());
  return page;
}

const text = (page) => page.evaluate(() => globalThis.studio.document.text);
const rows = (page) => page.$$eval('#panel-numbers tr', (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
const outline = (page) => page.locator('.scene .outline').innerText();

// Cursor behind what is written somewhere.
async function behind(page, what) {
  await page.locator('.scene .cm-line', { hasText: what }).first().click();
  await page.keyboard.press('End');
}

async function example(page, title) {
  await page.click('.scene .examples summary');
  await page.getByRole('button', { name: title, exact: true }).click();
}

test('a misspelt word is underlined at its place, and mended by a click and by a key', async (t) => {
  const page = await begin(t);
  if (!page) return;
  for (const mend of [() => page.click('.scene .faults .mend'), () => page.keyboard.press('Control+.')]) {
    await behind(page, '"*": Frozen');
    await page.keyboard.type('\n"left_elbow.rx": Frozn,');
    await page.waitForSelector('.scene .faults .mend');
    assert.equal(await page.locator('.cm-lintRange-error').innerText(), 'Frozn');
    const said = await page.locator('.scene .faults li').innerText();
    assert.match(said, /7:26/);
    assert.match(said, /'Frozn' is not known here; did you mean 'Frozen'\?/);
    await mend();
    await page.waitForFunction(() => document.querySelector('.scene .faults').hidden);
    assert.match(await text(page), /"left_elbow.rx": Frozen,/);
    assert.equal(await page.locator('.cm-lintRange-error').count(), 0);
    // And all of it taken back, for the second way.
    await page.click('.scene .cm-content');
    for (let i = 0; i < 6; i += 1) await page.keyboard.press('Control+z');
    await page.waitForFunction(() => !globalThis.studio.document.text.includes('left_elbow'));
  }
});

test('a fault under the pointer says what is wrong in a tip, and its mend stands there too', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await behind(page, 'duration');
  await page.keyboard.type('\nrat: 50.0,');
  await page.waitForSelector('.cm-lintRange-error');
  await page.hover('.cm-lintRange-error');
  await page.waitForSelector('.cm-tooltip-hover');
  assert.match(await page.locator('.cm-tooltip-hover').innerText(), /rat/);
  await page.click('.cm-tooltip-hover .cm-diagnosticAction');
  await page.waitForFunction(() => globalThis.studio.document.text.includes('rate: 50.0'));
});

test('a degree of freedom is completed while its name is typed, and a field on Ctrl-Space', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await behind(page, '"*": Frozen');
  await page.keyboard.type('\n"left_el', { delay: 20 });
  await page.waitForSelector('.cm-tooltip-autocomplete li');
  const offered = await page.$$eval('.cm-tooltip-autocomplete li', (all) => all.map((item) => item.textContent));
  assert.ok(offered.some((item) => item.startsWith('left_elbow.rx')), offered.join());
  await page.locator('.cm-tooltip-autocomplete li', { hasText: 'left_elbow.rx' }).click();
  await page.keyboard.press('End');
  await page.keyboard.type(': Servo(to: 1, ');
  await page.waitForTimeout(300);
  await page.keyboard.press('Control+Space');
  await page.waitForSelector('.cm-tooltip-autocomplete li');
  await page.locator('.cm-tooltip-autocomplete li', { hasText: 'stiffness' }).click();
  await page.keyboard.type('40.0, damping: 4.0');
  await page.keyboard.press('End');
  await page.keyboard.type(',');
  await page.waitForFunction(() => /"left_elbow.rx": Servo\(to: 1, stiffness: 40.0, damping: 4.0\),/.test(globalThis.studio.document.text));
  await page.waitForFunction(() => globalThis.studio.document.outline?.drives.some(({ steps }) => steps[0].drive === 'servo'));
  assert.match(await outline(page), /servo\s+1\s+left_elbow.rx/);
});

test('an example is opened by a click, stands in its first pose, and runs with its error estimate', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await example(page, 'A pendulum');
  await page.waitForFunction(() => globalThis.studio.show.data.links[0]?.name === 'rod');
  assert.match(await outline(page), /pendulum, 1 degree of freedom: 10 s, 100 frames a second/);
  await page.click('.scene .cm-content');
  await page.keyboard.press('Control+Enter');
  await page.waitForFunction(() => !globalThis.studio.show.isLive());
  await page.click('#tab-numbers');
  const found = await rows(page);
  const error = found.find(([label]) => label === 'Error of positions');
  assert.ok(error, JSON.stringify(found));
  assert.match(error[1], /^\d\.\de−\d+$/);
  assert.ok(Number(error[1].replaceAll('−', '-')) <= 1e-8);
  assert.ok(found.some(([label]) => label === 'Energy imbalance'));
  assert.ok(Number(found.find(([label]) => label === 'Steps')[1]) > 100);
});

test('a scene that includes a file runs in the engine behind, which gets the file', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await example(page, 'A crowd watches a bird');
  await page.waitForFunction(() => globalThis.studio.document.outline?.joints.some(({ name }) => name.startsWith('crowd')), null, { timeout: 60_000 });
  await page.click('.scene .main');
  await page.waitForFunction(() => !globalThis.studio.show.isLive(), null, { timeout: 120_000 });
  assert.equal(await page.locator('.notice.wrong').isVisible(), false);
});

test('a run that takes long is stopped at once, and the page goes on working', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await example(page, 'Somebody goes limp (long)');
  await page.waitForFunction(() => globalThis.studio.document.outline?.method.includes('1e-5'));
  await page.click('.scene .main');
  await page.waitForFunction(() => document.querySelector('.scene progress').hasAttribute('value'));
  assert.match(await page.locator('.scene .words').innerText(), /^Running, pass 1, /);
  // While it runs, text is written and checked.
  await behind(page, 'duration: 2.0');
  await page.keyboard.type('\nrat: 100.0,');
  await page.waitForSelector('.scene .faults .mend', { timeout: 3000 });
  const begun = Date.now();
  await page.click('.scene .stop');
  await page.waitForFunction(() => document.querySelector('.scene .work').hidden);
  assert.ok(Date.now() - begun < 2000);
  assert.equal(await page.locator('.scene > .remark').innerText(), 'Stopped.');
  await example(page, 'A falling cat');
  await page.waitForFunction(() => globalThis.studio.document.outline?.name === 'cat');
  await page.click('.scene .main');
  await page.waitForFunction(() => !globalThis.studio.show.isLive());
});

test('what was run is taken away as a table, also after another run was stopped', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await example(page, 'A pendulum');
  await page.waitForFunction(() => globalThis.studio.document.outline?.name === 'pendulum');
  await page.click('.scene .main');
  await page.waitForFunction(() => !globalThis.studio.show.isLive());
  await page.getByRole('button', { name: 'Error against run time' }).click();
  await page.waitForFunction(() => document.querySelector('.scene progress').value > 0);
  await page.click('.scene .stop');
  await page.waitForFunction(() => document.querySelector('.scene .work').hidden);
  await page.click('#save summary');
  const [saved] = await Promise.all([page.waitForEvent('download'), page.click('#save >> text=Table')]);
  const lines = readFileSync(await saved.path(), 'utf8').trim().split('\n');
  assert.match(lines[0], /pivot/);
  assert.ok(lines.length > 1000, String(lines.length));
});

test('what another panel writes comes in as one step, keeps the cursor, and is undone', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await behind(page, 'duration: 3.0');
  await page.keyboard.type(' // long');
  await page.waitForFunction(() => globalThis.studio.document.text.includes('// long'));
  const typed = await text(page);
  await page.evaluate(() => globalThis.studio.document.edit([
    { path: ['drives', '"left_elbow.rx"'], value: 'Free' },
    { path: ['version'], value: '1' },
    { path: ['rate'], value: '60.0' },
  ]));
  const written = await text(page);
  assert.match(written, /"left_elbow.rx": Free/);
  assert.match(await page.locator('.scene .cm-content').innerText(), /"left_elbow.rx": Free/);
  // The cursor is where it was.
  await page.keyboard.type('er');
  await page.waitForFunction(() => globalThis.studio.document.text.includes('// longer'));
  await page.keyboard.press('Control+z');
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.waitForFunction((before) => globalThis.studio.document.text === before, typed);
  await page.getByRole('button', { name: 'Redo' }).click();
  await page.waitForFunction((after) => globalThis.studio.document.text === after, written);
});

test('what is typed while another panel writes is not lost', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await behind(page, 'duration: 3.0');
  await page.keyboard.type(' // one');
  await Promise.all([
    page.evaluate(() => globalThis.studio.document.edit([{ path: ['drives', '"left_elbow.rx"'], value: 'Free' }])),
    page.keyboard.type(' two three four', { delay: 15 }),
  ]);
  await page.waitForFunction(() => globalThis.studio.document.text.includes('// one two three four') && globalThis.studio.document.text.includes('"left_elbow.rx": Free'));
});

test('error against run time shows a page with a picture, which is saved', async (t) => {
  const page = await begin(t);
  if (!page) return;
  await example(page, 'A pendulum');
  await page.waitForFunction(() => globalThis.studio.document.outline?.name === 'pendulum');
  await page.getByRole('button', { name: 'Error against run time' }).click();
  await page.waitForFunction(() => document.querySelector('.scene progress').value > 0);
  await page.waitForSelector('dialog.study[open]', { timeout: 120_000 });
  const frame = page.frameLocator('dialog.study iframe');
  await frame.locator('svg').first().waitFor();
  assert.ok((await frame.locator('svg').first().boundingBox()).width > 200);
  assert.match(await frame.locator('h1').innerText(), /pendulum: precision against work/);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save page' }).click()]);
  assert.equal(saved.suggestedFilename(), 'pendulum-precision.html');
  assert.match(readFileSync(await saved.path(), 'utf8'), /<svg/);
  await page.getByRole('button', { name: 'Close', exact: true }).click();
});

test('the text is saved as a file, and another file is opened', async (t) => {
  const page = await begin(t);
  if (!page) return;
  const tools = page.getByRole('group', { name: 'The text' });
  const [saved] = await Promise.all([page.waitForEvent('download'), tools.getByRole('button', { name: 'Save' }).click()]);
  assert.equal(saved.suggestedFilename(), 'ann.ron');
  const before = readFileSync(await saved.path(), 'utf8');
  assert.equal(before, await text(page));
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), tools.getByRole('button', { name: 'Open' }).click()]);
  await chooser.setFiles({ name: 'other.ron', mimeType: 'text/plain', buffer: Buffer.from(before.replace('duration: 3.0', 'duration: 7.5').replaceAll('\n', '\r\n')) });
  await page.waitForFunction(() => globalThis.studio.document.outline?.duration === 7.5);
  assert.doesNotMatch(await text(page), /\r/);
});

test('on a telephone the text is written and run, in the dark', async (t) => {
  const page = await begin(t, { width: 390, height: 844, dark: true });
  if (!page) return;
  await example(page, 'A falling cat');
  await page.waitForFunction(() => globalThis.studio.document.outline?.name === 'cat');
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 390));
  const paper = await page.$eval('.scene .cm-editor', (editor) => getComputedStyle(editor).backgroundColor);
  assert.equal(paper, 'rgb(23, 26, 30)');
  await page.click('.scene .main');
  await page.waitForFunction(() => !globalThis.studio.show.isLive());
});

test('people of a scene with several are people, before it runs and after', async (t) => {
  const page = await begin(t, { still: true });
  if (!page) return;
  const skins = () => page.evaluate(() => globalThis.studio.show.data.bodies.length);
  await page.evaluate(() => globalThis.studio.document.set('Scene(version: 1, figures: {"ann": Human(height: 1.6, mass: 55), "bob": Human(height: 1.9, mass: 90)}, places: {"bob": Place(at: (1.2, 0, 0))}, duration: 0.2)'));
  await page.waitForFunction(() => globalThis.studio.show.data.figure === 'ann and bob');
  assert.equal(await skins(), 2);
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await page.waitForFunction(() => globalThis.studio.show.data.time.length > 5);
  assert.equal(await skins(), 2);
});
