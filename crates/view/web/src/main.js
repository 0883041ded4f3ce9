// The page of a motion: reads the embedded data, puts picture, plots and controls together, and runs the clock.

import './style.css';
import uPlot from 'uplot';
import { makeBody, mixAt } from './body.js';
import { makeClock } from './clock.js';
import { makeControls } from './controls.js';
import { readBody, readData } from './data.js';
import { makePicture } from './picture.js';
import { makePlots } from './plots.js';
import { makeStudioButton } from './studio.js';
import { makeTabs } from './tabs.js';
import { onThemeChange, readTheme } from './theme.js';
import * as three from './three.js';

// What other pages show motions with, and what they build on: the studio loads this bundle for its parts.
globalThis.solarisView = {
  makeBody,
  makeClock,
  makeControls,
  makePicture,
  makePlots,
  makeTabs,
  mixAt,
  onThemeChange,
  readBody,
  readData,
  readTheme,
  three,
  uPlot,
};

// A page that was hidden does not catch up.
const LONGEST_TICK = 0.5;

// The page of one motion.
function showPage(holder) {
  const { textContent: json } = document.getElementById('data');
  const data = readData(json);
  const clock = makeClock(data.time);

  let picture = null;
  try {
    picture = makePicture(holder, data, clock);
  } catch (error) {
    // No WebGL: say so, and leave plots and table.
    const note = document.getElementById('no-picture');
    note.hidden = false;
    note.querySelector('small').textContent = error.message;
  }
  const [joints, forces] = ['joints', 'forces'].map((id) => document.getElementById(id));
  const plots = makePlots(joints, forces, data, clock, readTheme());
  makeTabs(document.getElementById('tabs'));
  makeControls(clock, picture, data);
  makeStudioButton(json, document.title);
  picture?.paint(readTheme());
  onThemeChange(() => {
    picture?.paint(readTheme());
    plots.paint(readTheme());
  });

  let before = performance.now();
  function run(time) {
    clock.tick(Math.min(LONGEST_TICK, Math.max(0, (time - before) / 1000)));
    before = time;
    picture?.draw();
    requestAnimationFrame(run);
  }
  requestAnimationFrame(run);
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) clock.play();

  // For scripts and tests.
  window.solaris = {
    ready: true,
    time: clock.time,
    play: clock.play,
    pause: clock.pause,
    seek: clock.seek,
    frame: () => clock.frame().index,
    // Least and greatest x and y of the figure in the picture, from 0 to 1; null without a picture.
    outline: () => picture?.outline() ?? null,
    // Height of the drawn ground at a place, in the data's coordinates (m); null without a picture.
    ground: (x, z) => picture?.ground(x, z) ?? null,
    show: (part, visible) => picture?.show(part, visible),
  };
}

if (document.getElementById('data')) showPage(document.getElementById('picture'));
