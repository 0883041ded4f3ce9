import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { choose, fixture, open, STUDIO, text } from './browser.mjs';

test('a robot that is chosen stands there with its mass and its joints', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await choose(page, 'figures/arm.urdf');
  await page.waitForSelector('#panel-files .about h2');
  assert.match(await text(page, '#panel-files .sum'), /^3\.2 kg, 3 links, 2 joints that move, 2 degrees of freedom/);
  const joints = await text(page, '#panel-files .joints');
  assert.match(joints, /shoulder[\s\S]*moves upper_arm[\s\S]*−177\.6 to 57\.3°, held by −?0 N m/);
  assert.match(await text(page, '#panel-files .roles'), /arm\.urdf\s*the figure 'arm' \(URDF\)/);
  assert.equal(await text(page, '#title'), 'arm');
  assert.equal(await page.evaluate(() => studio.show.isLive()), true);
});

test('a robot that was dropped is posed and driven, and says what holds it', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await choose(page, 'figures/arm.urdf');
  await page.click('button:text-is("Pose and drive it")');
  await page.click('.joint-list [data-joint="shoulder"]');
  const slider = page.locator('.dof[aria-label="shoulder"] .slider input[type=number]');
  await slider.fill('-60');
  await slider.press('Enter');
  // sin 60° · 9.80665 m/s² · (2 kg · 0.15 m + 1.2 kg · 0.5 m).
  await page.waitForFunction(() => /held by −?7\.64 N m/.test(document.querySelector('.dof[aria-label="shoulder"] .moment').textContent));
});

test('the files of a subject give the joint moments of the command line', async (t) => {
  const plates = await open(t, { still: true });
  if (!plates) return;
  // Of plates of which nobody says what they push the soles find the feet.
  await choose(plates, 'subject/subject.osim', 'subject/walk.mot', 'subject/grf.mot', 'subject/soles.ron');
  await plates.waitForFunction(() => /plate 1: right from 0 to 1\.175/.test(document.querySelector('#panel-files .found')?.textContent ?? ''));
  await plates.click('#tab-numbers');
  await plates.locator('#panel-numbers tr', { hasText: /ankle.*left.*−131\.2/i }).first().waitFor();

  const page = await open(t, { still: true });
  await choose(page, 'subject/subject.osim', 'subject/walk.mot', 'subject/grf.mot', 'subject/loads.xml', 'subject/soles.ron');
  await page.waitForFunction(() => document.querySelector('#panel-files .found')?.textContent);
  await page.click('#tab-numbers');
  // `solaris inverse subject.osim walk.mot --external-loads loads.xml --filter 6Hz` says -131.2 N m at 2.65 s.
  const row = page.locator('#panel-numbers tr', { hasText: /ankle.*left/i }).first();
  assert.match((await row.innerText()).replace(/\s+/g, ' '), /−131\.2 N m at 2\.65 s/);
  // Curves and forces are there too.
  await page.click('#tab-forces-curves');
  assert.ok((await page.locator('#panel-forces-curves canvas').count()) > 0);
  // Predicted forces give another moment.
  await page.selectOption('[aria-label="Forces of the ground"]', 'predicted');
  await page.click('#tab-numbers');
  await page.waitForFunction(() => /found from the motion/.test(document.querySelector('#panel-files .found').textContent));
  assert.doesNotMatch((await row.innerText()).replace(/\s+/g, ' '), /−131\.2 N m at 2\.65 s/);
});

test('files that come one after the other belong together', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await choose(page, 'subject/subject.osim');
  await choose(page, 'subject/walk.mot');
  await page.waitForFunction(() => /none|no forces/i.test(document.querySelector('#panel-files .found')?.textContent ?? ''));
  await choose(page, 'subject/loads.xml', 'subject/grf.mot');
  await page.waitForFunction(() => /grf\.mot/.test(document.querySelector('#panel-files .found')?.textContent ?? ''));
  assert.equal(await page.inputValue('[aria-label="Forces of the ground"]'), 'measured');
});

test('a broken file says what is wrong with it, and a name is no markup', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const broken = readFileSync(fixture('figures/arm.urdf'), 'utf8').replace('child link="forearm"', 'child link="nowhere"');
  await choose(page, { name: '<img src=x onerror=alert(1)>.urdf', mimeType: 'text/xml', buffer: Buffer.from(broken) });
  assert.match(await text(page, '#panel-files .said .fault'), /nowhere/);
  assert.equal(await page.locator('#panel-files img').count(), 0);
});

test('files dropped on the page are opened', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const source = readFileSync(fixture('figures/arm.urdf'), 'utf8');
  await page.evaluate((given) => {
    const data = new DataTransfer();
    data.items.add(new File([given], 'arm.urdf'));
    const target = document.querySelector('#results');
    target.dispatchEvent(new DragEvent('dragover', { dataTransfer: data, bubbles: true, cancelable: true }));
    if (document.querySelector('#drop').hidden) throw new Error('nothing says that files can be dropped');
    target.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  }, source);
  await page.waitForFunction(() => /3\.2 kg/.test(document.querySelector('#panel-files .sum')?.textContent ?? ''));
  assert.equal(await page.isVisible('#drop'), false);
});

test('a scene with a fault is opened all the same', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  const scene = 'Scene(version: 1, figures: {"ann": Human(height: 1.75, mass: 73.0)}, duration: 1.0, drives: {"nobody.rx": Frozen})\n';
  await choose(page, { name: 'one.ron', mimeType: 'text/plain', buffer: Buffer.from(scene) });
  await page.waitForFunction((expected) => studio.document.text === expected, scene);
});

test('what a figure is made of is drawn on it', async (t) => {
  const page = await open(t, { still: true });
  if (!page) return;
  await choose(page, 'figures/arm.urdf');
  const count = (kind) => page.evaluate((name) => {
    let found = 0;
    studio.show.picture.stage.scene.traverse((object) => (found += object.name === name ? 1 : 0));
    return found;
  }, kind);
  assert.equal(await count('inertia'), 0);
  await page.check('text=inertia');
  await page.check('text=axes of joints');
  await page.waitForFunction(() => {
    let found = 0;
    studio.show.picture.stage.scene.traverse((object) => (found += object.name === 'inertia' ? 1 : 0));
    return found === 2;
  });
  // Two hinges: a line and a dot each.
  assert.equal(await count('axes'), 4);
});

test('files that were put into the page are open when it begins', async (t) => {
  if (!existsSync(STUDIO)) return t.skip('there is no studio: `node build.mjs`');
  const into = mkdtempSync(join(tmpdir(), 'studio-'));
  t.after(() => rmSync(into, { recursive: true }));
  // As `solaris studio arm.urdf -o arm.html` writes it, or what it wrote.
  const base64 = readFileSync(fixture('figures/arm.urdf')).toString('base64');
  const given = `<script type="application/json" id="given">${JSON.stringify([{ name: 'arm.urdf', base64 }])}</script>\n<script id="boot">`;
  const made = join(into, 'arm.html');
  if (!process.env.GIVEN) writeFileSync(made, readFileSync(STUDIO, 'utf8').replace('<script id="boot">', given));
  const page = await open(t, { still: true, url: `file://${process.env.GIVEN ?? made}` });
  if (!page) return;
  assert.match(await text(page, '#panel-files .sum'), /^3\.2 kg/);
  assert.equal(await text(page, '#title'), 'arm');
});
