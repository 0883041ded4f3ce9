// How long frames take while somebody is steered.
//
//     node chores/frames.mjs [--seconds 60] [--size 1400x860] [--page FILE] [--push] [--undrawn]
//
// Walks in a curve by keys that are held, pulled aside all the while with --push, and prints frames a second, the times between frames after the first second, the page's own work and the engine's
// answers, and what the picture cost in the process that draws. With --undrawn nothing is drawn, and the engine's answers are all that is told: its own share. Where other programs share the processors compare ratios, and that cost.

import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';

const { values } = parseArgs({ options: { seconds: { type: 'string', default: '60' }, size: { type: 'string', default: '1400x860' }, page: { type: 'string' }, push: { type: 'boolean' }, undrawn: { type: 'boolean' } } });
const file = values.page ?? fileURLToPath(new URL('../dist/studio.html', import.meta.url));
const [width, height] = values.size.split('x').map(Number);
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
if (![file, executablePath].every(existsSync)) {
  console.error(`there is no ${[file, executablePath].find((path) => !existsSync(path))}`);
  process.exit(2);
}

// The process below another that draws, and how long one has computed (ms); nothing where the system does not tell.
const stat = (id) => readFileSync(`/proc/${id}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');
function drawing(root) {
  try {
    const parents = new Map(readdirSync('/proc').filter((name) => /^\d+$/.test(name)).flatMap((id) => {
      try {
        return [[id, stat(id)[1]]];
      } catch {
        return [];
      }
    }));
    const below = (id) => id === String(root) || (parents.has(id) && below(parents.get(id)));
    return [...parents.keys()].find((id) => below(id) && readFileSync(`/proc/${id}/cmdline`, 'utf8').includes('--type=gpu-process'));
  } catch {
    return undefined;
  }
}
const computed = (id) => 10 * (Number(stat(id)[11]) + Number(stat(id)[12]));

const args = ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];
const server = await chromium.launchServer({ executablePath, args });
const browser = await chromium.connect(server.wsEndpoint());
const page = await browser.newPage({ viewport: { width, height } });
await page.goto(pathToFileURL(file).href);
await page.waitForFunction(() => document.body.dataset.ready === 'true', null, { timeout: 60_000 });
await page.click('#tab-steer');
await page.waitForFunction(() => document.querySelector('.steer-out output')?.textContent === '0 m/s');
const drawer = drawing(server.process().pid);
await page.keyboard.down('w');
await page.keyboard.down('a');
if (values.push) {
  const box = await page.locator('#picture canvas').first().boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.keyboard.down('Shift');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 4 });
}
await page.waitForTimeout(1000);
const before = drawer && computed(drawer);
const found = await page.evaluate(async ([seconds, undrawn]) => {
  const { picture } = studio.show;
  const { draw } = picture;
  const [frames, draws, answers] = [[], [], []];
  picture.draw = () => {
    if (undrawn) return false;
    const from = performance.now();
    const drew = draw();
    if (drew) draws.push(performance.now() - from);
    return drew;
  };
  const { call } = studio.engine;
  studio.engine.call = async function (name, ...rest) {
    const from = performance.now();
    const answer = await call.call(this, name, ...rest);
    if (name === 'steerFrame') answers.push(performance.now() - from);
    return answer;
  };
  await new Promise((done) => {
    const begun = performance.now();
    let last = begun;
    const next = (now) => {
      frames.push(now - last);
      last = now;
      if (now - begun > 1000 * seconds) done();
      else requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  });
  delete studio.engine.call;
  picture.draw = draw;
  const { renderer } = picture.stage;
  return { frames: frames.slice(1), draws, answers, size: `${renderer.domElement.width}x${renderer.domElement.height}`, lines: renderer.info.render.lines, triangles: renderer.info.render.triangles };
}, [Number(values.seconds), values.undrawn]);
const cost = drawer && computed(drawer) - before;
await browser.close();
await server.close();

const at = (numbers, share) => [...numbers].sort((a, b) => a - b)[Math.min(numbers.length - 1, Math.floor(share * numbers.length))] ?? NaN;
const ms = (value) => value.toFixed(1);
const sum = found.frames.reduce((a, b) => a + b, 0);
const answered = `engine there and back: median ${ms(at(found.answers, 0.5))} ms, 95 % ${ms(at(found.answers, 0.95))} ms, most ${ms(Math.max(...found.answers))} ms`;
if (values.undrawn) {
  console.log(`${found.answers.length} frames; ${answered}`);
  process.exit();
}
console.log(`${((1000 * found.frames.length) / sum).toFixed(1)} frames/s over ${(sum / 1000).toFixed(0)} s; ${found.draws.length} pictures of ${found.size}, ${found.triangles} triangles, ${found.lines} lines`);
console.log(`between frames: median ${ms(at(found.frames, 0.5))} ms, 95 % ${ms(at(found.frames, 0.95))} ms, most ${ms(Math.max(...found.frames))} ms, ${found.frames.filter((time) => time > 50).length} above 50 ms`);
console.log(`page's drawing: median ${ms(at(found.draws, 0.5))} ms; ${answered}`);
if (drawer) console.log(`the process that draws computed ${ms(cost / found.draws.length)} ms a picture`);
