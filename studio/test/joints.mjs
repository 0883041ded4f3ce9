// Joints are driven as a person does it: by clicks, keys and drags; what is written and what comes of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open } from './browser.mjs';

const GRAVITY = 9.80665;

const scene = (page) => page.evaluate(() => studio.document.text);
const squeezed = async (page) => (await scene(page)).replace(/\s+/g, ' ');
const hasText = (page, text) => page.waitForFunction((text) => studio.document.text.includes(text), text);
// Another text, as the editor of the scene would set it.
const setScene = async (page, text) => {
  await page.evaluate((text) => studio.document.set(text), text);
  await page.waitForFunction(() => studio.document.outline && studio.document.faults.length === 0);
};
const dof = (page, name) => page.locator(`.dof[aria-label="${name}"]`);
const angle = async (page, name) => Number(await dof(page, name).locator('.slider input[type=number]').inputValue());
const type = async (field, value) => {
  await field.fill(String(value));
  await field.press('Enter');
};

async function openJoints(t, options) {
  const page = await open(t, options);
  if (!page) return null;
  await page.click('#tab-joints');
  await page.waitForSelector('.joint-list [role=option]');
  await page.waitForFunction(() => studio.show.isLive());
  return page;
}

// Finds a joint by the search field.
async function find(page, words, name) {
  await page.fill('.joint-tree input', words);
  await page.click(`.joint-list [data-joint="${name}"]`);
  await page.waitForSelector(`.joint > h2:text-is("${name}")`);
  await page.fill('.joint-tree input', '');
}

async function choose(page, name, mode) {
  const bar = dof(page, name).locator('.bar-of').first();
  if ((await bar.getAttribute('aria-pressed')) !== 'true') await bar.click();
  await dof(page, name).locator('select[aria-label=Mode]').selectOption(mode);
}

async function simulate(page) {
  await page.click('button:text-is("Simulate")');
  await page.waitForSelector('.outcomes li');
}

// Where a point of a link is on the page.
async function onPage(page, link, point = [0, -0.1, 0]) {
  return page.evaluate(
    ([link, point]) => {
      const { show } = studio;
      const { camera, renderer } = show.picture.stage;
      show.picture.draw();
      const bone = show.picture.body().group.children[show.data.links.findIndex(({ name }) => name === link)];
      bone.updateWorldMatrix(true, false);
      const seen = new solarisView.three.Vector3(...point).applyMatrix4(bone.matrixWorld).project(camera);
      const box = renderer.domElement.getBoundingClientRect();
      return [box.left + (box.width * (1 + seen.x)) / 2, box.top + (box.height * (1 - seen.y)) / 2];
    },
    [link, point],
  );
}

async function shiftDrag(page, [x, y], [dx, dy], meanwhile = async () => {}) {
  await page.keyboard.down('Shift');
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 6; i += 1) {
    await page.mouse.move(x + (dx * i) / 6, y + (dy * i) / 6);
    await page.waitForTimeout(50);
  }
  await meanwhile();
  await page.mouse.up();
  await page.keyboard.up('Shift');
}

const places = (page, link) =>
  page.evaluate((link) => {
    const { data } = studio.show;
    const at = data.links.findIndex(({ name }) => name === link);
    return [0, 1, 2].map((axis) => data.root[axis] + data.positions[3 * at + axis]);
  }, link);

test('an elbow posed by a number is held by the weight of the forearm', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await find(page, 'left elb', 'left_elbow');
  await type(dof(page, 'left_elbow.rx').locator('.slider input[type=number]'), -90);
  await hasText(page, '"left_elbow.rx": deg(-90)');
  await page.waitForFunction(() => /held by −[1-9]/.test(document.querySelector('.dof[aria-label="left_elbow.rx"] .moment').textContent));
  const said = await dof(page, 'left_elbow.rx').locator('.moment').innerText();
  const moment = Number(/held by −([\d.]+) N m/.exec(said)[1]);
  // By hand: forearm and hand reach forward; their masses are about 43 % along the one and in the middle of the other.
  const { forearm, hand } = await page.evaluate(async () => {
    const { links } = await studio.engine.call('poseScene', [studio.document.text]);
    const mass = (name) => links.find((link) => link.name === name).mass;
    return { forearm: mass('left_forearm'), hand: mass('left_hand') };
  });
  const [elbow, wrist] = [await places(page, 'left_forearm'), await places(page, 'left_hand')];
  const length = wrist[2] - elbow[2];
  assert.ok(length > 0.2 && Math.abs(wrist[1] - elbow[1]) < 0.03, 'the forearm is level');
  const byHand = GRAVITY * (forearm * 0.43 * length + hand * (length + 0.07));
  assert.ok(Math.abs(moment - byHand) < 0.15 * byHand, `${moment} N m, by hand ${byHand.toFixed(2)}`);
  // Out of its limits it does not go, and says so.
  await type(dof(page, 'left_elbow.rx').locator('.slider input[type=number]'), 40);
  assert.match(await dof(page, 'left_elbow.rx').locator('.slider .fault').innerText(), /goes from −150 to 5/);
  assert.ok((await scene(page)).includes('deg(-90)'));
});

test('a click chooses a link, and a drag with Shift bends the arm and writes where it begins', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await page.selectOption('#view', 'front');
  const at = await onPage(page, 'left_forearm');
  await page.mouse.click(...at);
  await page.waitForSelector('.joint > h2:text-is("left_elbow")');
  assert.equal(await page.locator('.joint-list [aria-selected=true]').getAttribute('data-joint'), 'left_elbow');
  const before = await places(page, 'left_hand');
  assert.ok(!(await scene(page)).includes('start'));
  await shiftDrag(page, at, [30, -40]);
  await hasText(page, 'start: {');
  assert.match(await scene(page), /"left_(elbow|shoulder)\.r[xyz]": deg\(/);
  const after = await places(page, 'left_hand');
  assert.ok(Math.hypot(...after.map((x, i) => x - before[i])) > 0.03, 'the hand went along');
  // Only the arm: the rest stays where it was.
  assert.doesNotMatch(await scene(page), /"(root|right|lumbar)/);
  // Escape takes a drag back.
  const held = await scene(page);
  const again = await onPage(page, 'left_forearm');
  await shiftDrag(page, again, [-20, 20], () => page.keyboard.press('Escape'));
  await page.waitForTimeout(600);
  assert.equal(await scene(page), held);
});

test('frozen, free, servo and move are written, and the run ends where they lead', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await find(page, 'left elbow', 'left_elbow');
  const name = 'left_elbow.rx';
  const ended = async () => {
    await simulate(page);
    return (await dof(page, name).locator('.outcomes').innerText()).replaceAll('−', '-');
  };
  await choose(page, name, 'Move');
  await type(dof(page, name).getByLabel('To (°)'), -60);
  await type(dof(page, name).getByLabel('Over (s)'), 0.5);
  await hasText(page, `"${name}": Move(to: deg(-60), over: 0.5)`);
  assert.match(await ended(), /0–0\.5 s move.*: reached, -60°/);
  assert.match(await page.locator('#title').innerText(), /ann/);

  await choose(page, name, 'Servo');
  await type(dof(page, name).getByLabel('To (°)'), -40);
  await type(dof(page, name).getByLabel('Stiffness (N m/rad)'), 60);
  await type(dof(page, name).getByLabel('Damping (N m s/rad)'), 6);
  await hasText(page, 'Servo(to: deg(-40), stiffness: 60.0, damping: 6.0)');
  const servo = Number(/, (-[\d.]+)°/.exec(await ended())[1]);
  // It sags by what it bears: some 2 N m at 60 N m/rad are two degrees.
  assert.ok(servo > -41 && servo < -36, `${servo}°`);

  await choose(page, name, 'Free');
  await hasText(page, `"${name}": Free`);
  await type(dof(page, name).locator('.slider input[type=number]'), -90);
  await hasText(page, `"${name}": deg(-90)`);
  const free = Number(/, (-?[\d.]+)°/.exec(await ended())[1]);
  assert.ok(Math.abs(free + 90) > 5, `it fell, to ${free}°`);

  await choose(page, name, 'Frozen');
  await hasText(page, `"${name}": Frozen`);
  await page.click('button:text-is("Simulate")');
  await page.waitForFunction(() => !studio.show.isLive());
  const heights = await page.evaluate(() => {
    const { data } = studio.show;
    const [count, hand] = [data.links.length, data.links.findIndex(({ name }) => name === 'left_hand')];
    return [0, data.time.length - 1].map((frame) => data.root[3 * frame + 1] + data.positions[3 * (frame * count + hand) + 1]);
  });
  assert.ok(Math.abs(heights[0] - heights[1]) < 1e-4, 'it stays');
});

test('what is typed faster than the engine writes it is kept', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await find(page, 'left elbow', 'left_elbow');
  const name = 'left_elbow.rx';
  await choose(page, name, 'Servo');
  await hasText(page, `"${name}": Servo`);
  await page.waitForFunction(() => studio.document.outline);
  // Edits wait until they are let go, one by one.
  await page.evaluate(() => {
    const { engine } = studio;
    const call = engine.call.bind(engine);
    Object.assign(globalThis, { held: [], checks: 0 });
    studio.document.onCheck(() => (checks += 1));
    engine.call = async (name, ...more) => {
      const value = await call(name, ...more);
      if (name === 'editScene') await new Promise((go) => held.push(go));
      return value;
    };
  });
  const letGo = async () => {
    await page.waitForFunction(() => held.length > 0);
    await page.evaluate(() => held.shift()());
  };
  const field = (label) => dof(page, name).getByLabel(label);
  await type(field('To (°)'), -40);
  await type(field('Stiffness (N m/rad)'), 60);
  await letGo();
  // The first is in the text and checked, the second is not.
  await page.waitForFunction(() => checks === 1);
  assert.equal(await field('Stiffness (N m/rad)').inputValue(), '60');
  await type(field('Damping (N m s/rad)'), 6);
  await letGo();
  await letGo();
  await hasText(page, `"${name}": Servo(to: deg(-40), stiffness: 60.0, damping: 6.0)`);
  // And of the person: the mass is not in the text yet when the height before it is checked.
  await page.click('summary:text-is("Figure, ground, duration")');
  const before = await page.evaluate(() => checks);
  await type(page.getByLabel('Height of the person (m)'), 1.9);
  await type(page.getByLabel('Mass of the person (kg)'), 90);
  await letGo();
  await page.waitForFunction((before) => checks > before, before);
  await type(page.getByLabel('Height of the person (m)'), 1.8);
  await letGo();
  await letGo();
  await hasText(page, 'Human(height: 1.8, mass: 90.0)');
});

test('drives follow one another in a row that is written by keys and clicks', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await setScene(page, 'Scene(version: 1, figures: {"ann": Human(height: 1.75, mass: 73.0)}, duration: 3.0, drives: {"*": Frozen, "left_elbow.rx": Sum([Torque(Line(from: 1, to: 1, duration: 1)), Servo(to: 0, stiffness: 9)])})');
  await find(page, 'left elbow', 'left_elbow');
  const part = dof(page, 'left_elbow.rx');
  // What is more than the panel knows is shown as it stands.
  await part.locator('.bar-of').click();
  assert.match(await part.locator('.written').innerText(), /^Sum\(\[Torque/);
  await part.locator('.bar-of').press('Delete');
  await page.waitForFunction(() => !studio.document.text.includes('Sum'));
  // The row is drawn after the text.
  await part.locator('.bar-of', { hasText: /^Frozen$/ }).waitFor();

  await choose(page, 'left_elbow.rx', 'Free');
  await part.getByLabel('Until').selectOption('Passes');
  await part.getByLabel('Of', { exact: true }).selectOption('right_elbow.rx');
  await type(part.getByLabel('Passes (°)'), -10);
  await hasText(page, 'Free(until: Passes("right_elbow.rx", deg(-10)))');
  await part.getByLabel('Until').selectOption('Lasting');
  await type(part.getByLabel('After (s)'), 0.75);
  await hasText(page, 'Free(until: Lasting(0.75))');
  await part.locator('.add').click();
  await hasText(page, '[Free(until: Lasting(0.75)), Move(');
  // The row is drawn after the text. Widths are by their times: 0.75 s of 3 s.
  await part.locator('.bar-of').nth(1).waitFor();
  const [count, share] = await part.locator('.bars').evaluate((row) => {
    const bars = [...row.querySelectorAll('.bar-of')];
    return [bars.length, bars[0].getBoundingClientRect().width / row.getBoundingClientRect().width];
  });
  assert.equal(count, 2);
  assert.ok(Math.abs(share - 0.25) < 0.02);
  await part.locator('.bar-of').nth(1).press('Alt+ArrowLeft');
  await hasText(page, '), Free(until: Lasting(0.75))]');
  await part.locator('.bar-of').nth(0).press('Delete');
  await hasText(page, '"left_elbow.rx": Free(until: Lasting(0.75))');
  // What the run did stands on the row.
  await simulate(page);
  assert.equal(await part.locator('.event').count(), 1);
  assert.match(await part.locator('.event').getAttribute('title'), /^0\.75 s/);
  // One mode for the whole joint.
  await page.getByLabel('Whole joint').selectOption('Free');
  await hasText(page, '"left_elbow.rz": Free');
  assert.match(await squeezed(page), /"left_elbow.rx": Free,? .*"left_elbow.ry": Free/);
});

test('a curve is drawn by its points and says where it turns round', async (t) => {
  const page = await openJoints(t, { width: 1200, height: 900 });
  if (!page) return;
  await find(page, 'left elbow', 'left_elbow');
  await choose(page, 'left_elbow.rx', 'Curve');
  const part = dof(page, 'left_elbow.rx');
  await hasText(page, 'MonotoneCubic(keys: [(0.0, deg(0)), (1.0, deg(-30)), (2.0, deg(0))])');
  await part.locator('.turn-label').waitFor();
  assert.equal(await part.locator('.turn-label').innerHTML(), '1 s');
  assert.equal(await part.locator('.line').count(), 2);
  // By keys: the middle one later and lower.
  await part.locator('[data-point="1"]').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowDown');
  await hasText(page, '(1.05, deg(-31))');
  await page.waitForFunction(() => document.querySelector('.turn-label')?.textContent === '1.05 s');
  // A double click adds one, a key deletes it.
  const box = await part.locator('.curve-drawing').boundingBox();
  await page.mouse.dblclick(box.x + 0.32 * box.width, box.y + 0.2 * box.height);
  await page.waitForFunction(() => document.querySelectorAll('.curve-drawing .point').length === 4);
  await part.locator('[data-point="1"]').press('Delete');
  await page.waitForFunction(() => document.querySelectorAll('.curve-drawing .point').length === 3);
  // Dragged down.
  await page.waitForTimeout(300);
  const point = await part.locator('[data-point="1"]').boundingBox();
  await page.mouse.move(point.x + point.width / 2, point.y + point.height / 2);
  await page.mouse.down();
  await page.mouse.move(point.x + point.width / 2 + 10, point.y - 20, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction(() => !studio.document.text.includes('(1.05, deg(-31))'));
  await part.getByLabel('Curve', { exact: true }).selectOption('MinimumJerk');
  await hasText(page, 'MinimumJerk(from: deg(0), to: deg(0), duration: 2.0)');
  await type(part.getByLabel('Time (s)'), 1.5);
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => studio.document.faults.length), 0);
});

test('a live scene gives way to a pull, obeys its servo, and goes back to what it was', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await setScene(page, 'Scene(version: 1, figures: {"ann": Human(height: 1.75, mass: 73.0, joints: Limp)}, duration: 3.0, method: Impulses(step: 0.001), drives: {"*": Frozen, "left_shoulder.*": Free, "left_elbow.rx": Servo(to: 0.0, stiffness: 40.0, damping: 4.0)})');
  await page.selectOption('#view', 'front');
  await find(page, 'left elbow', 'left_elbow');
  await page.click('button:text-is("Play live")');
  await page.waitForFunction(() => parseFloat(document.querySelector('.alive output').textContent) > 0.2);
  assert.match(await page.locator('.energy').innerText(), /Energy\s+[−\d.]+\s+J/);
  const hangs = await places(page, 'left_hand');
  const at = await onPage(page, 'left_forearm');
  let newtons = '';

  await shiftDrag(page, at, [70, -60], async () => {
    await page.waitForFunction((x) => {
      const { data } = studio.show;
      return Math.abs(data.root[0] + data.positions[3 * data.links.findIndex(({ name }) => name === 'left_hand')] - x) > 0.05;
    }, hangs[0]);
    newtons = await page.locator('.pull-label').innerText();
  });
  assert.match(newtons, /^[1-9]\d* N$/);
  assert.ok(await page.locator('.pull-label').isHidden());
  // By keys as well: as long as one is held.
  await page.focus('button:text-is("Pull by keys")');
  await page.keyboard.down('ArrowUp');
  await page.waitForSelector('.pull-label:not([hidden])');
  await page.keyboard.up('ArrowUp');
  await page.waitForSelector('.pull-label', { state: 'hidden' });
  // The slider is the servo's target now.
  await type(dof(page, 'left_elbow.rx').locator('.slider input[type=number]'), -60);
  await page.waitForFunction(() => /at −[4-7]\d/.test(document.querySelector('.dof[aria-label="left_elbow.rx"] .moment').textContent));
  await page.click('button:text-is("Pause")');
  await page.waitForTimeout(300);
  const pose = () => page.evaluate(() => [...studio.show.data.positions, ...studio.show.data.turns].join());
  const now = await pose();
  // Back by keys, forth again: the same to the bit; and on from there.
  const scrub = page.locator('.alive input[type=range]');
  const last = Number(await scrub.inputValue());
  await scrub.focus();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  const before = await pose();
  assert.notEqual(before, now);
  await page.keyboard.press('End');
  assert.equal(await pose(), now);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('ArrowLeft');
  await page.click('button:text-is("Step")');
  await page.waitForFunction((count) => Number(document.querySelector('.alive input[type=range]').max) === count, last - 2);
  await page.click('button:text-is("Back")');
  assert.equal(await pose(), before);
});

test('a shoulder in gimbal lock says so, and takes joints that never lock', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await setScene(page, 'Scene(version: 1, figures: {"ann": Human(height: 1.75, mass: 73.0)}, duration: 1.0, drives: {"*": Frozen, "left_shoulder.*": Free}, start: {"left_shoulder.ry": deg(89.9)})');
  await page.click('button:text-is("Play live")');
  await page.waitForSelector('text=from gimbal lock');
  await page.click('button:text-is("Take joints that never lock")');
  await hasText(page, 'joints: Limp');
});

test('what is wrong is said in the program’s words beside what it is about', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await find(page, 'left elbow', 'left_elbow');
  await choose(page, 'left_elbow.rx', 'Move');
  await type(dof(page, 'left_elbow.rx').getByLabel('Over (s)'), -1);
  await page.waitForFunction(() => studio.document.faults.length > 0);
  const words = await page.evaluate(() => studio.document.faults[0].message);
  await page.waitForFunction(() => document.querySelector('.dof[aria-label="left_elbow.rx"] .drives > .fault')?.hidden === false);
  assert.ok((await dof(page, 'left_elbow.rx').locator('.drives > .fault').innerText()).includes(words));
  assert.ok(await page.locator('button:text-is("Simulate")').isDisabled());
  await type(dof(page, 'left_elbow.rx').getByLabel('Over (s)'), 1);
  await page.waitForFunction(() => studio.document.faults.length === 0);
  assert.ok(await dof(page, 'left_elbow.rx').locator('.drives > .fault').isHidden());
  assert.ok(await page.locator('button:text-is("Simulate")').isEnabled());
});

test('ground, gravity, duration and the figure are set', async (t) => {
  const page = await openJoints(t);
  if (!page) return;
  await page.click('summary:text-is("Figure, ground, duration")');
  await page.getByLabel('Ground, to stand on').check();
  await hasText(page, 'ground: Flat(friction: 0.8, stand: true)');
  await page.getByLabel('Gravity').uncheck();
  await hasText(page, 'gravity: (0.0, 0.0, 0.0)');
  await page.getByLabel('Gravity').check();
  await page.waitForFunction(() => !studio.document.text.includes('gravity'));
  await type(page.getByLabel('Duration (s)'), 1.5);
  await hasText(page, 'duration: 1.5');
  await type(page.getByLabel('Mass of the person (kg)'), 60);
  await hasText(page, 'Human(height: 1.75, mass: 60.0)');
  await page.getByLabel('Figure', { exact: true }).selectOption('limp');
  await hasText(page, 'Human(height: 1.75, mass: 60.0, joints: Limp)');
  await page.waitForFunction(() => studio.document.outline.joints.some(({ name, dofs }) => name === 'left_shoulder' && dofs[0].name.endsWith('.wx')));
  await find(page, 'left shoulder', 'left_shoulder');
  await page.getByLabel('Whole joint').selectOption('Free');
  await hasText(page, '"left_shoulder": Free');
  assert.equal(await page.evaluate(() => studio.document.faults.length), 0);
});

test('all of it goes by keys, on a telephone too', async (t) => {
  const page = await open(t, { width: 390, height: 844, dark: true });
  if (!page) return;
  const number = await page.evaluate(() => 1 + [...document.querySelectorAll('#tool-tabs button')].findIndex(({ id }) => id === 'tab-joints'));
  await page.keyboard.press(`Alt+${number}`);
  await page.waitForSelector('.joint-list [role=option]');
  await page.focus('.joint-tree input');
  await page.keyboard.type('right knee');
  await page.keyboard.press('ArrowDown');
  await page.waitForSelector('.joint > h2:text-is("right_knee")');
  const bend = dof(page, 'right_knee.rx').locator('.slider input[type=range]');
  await bend.focus();
  for (let i = 0; i < 5; i += 1) await page.keyboard.press('ArrowRight');
  await hasText(page, '"right_knee.rx": deg(5)');
  assert.equal(await angle(page, 'right_knee.rx'), 5);
  const wide = await page.evaluate(() => document.querySelector('#tools').scrollWidth - document.querySelector('#tools').clientWidth);
  assert.ok(wide <= 0, `nothing is cut off (${wide} px)`);
  await page.focus('button:text-is("Play live")');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => parseFloat(document.querySelector('.alive output').textContent) > 0.05);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('Space');
  await page.waitForSelector('.alive button:text-is("Play")');
});
