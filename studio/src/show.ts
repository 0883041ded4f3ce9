// What is looked at: the picture, the time, the curves. Either a motion, or something that goes on by itself frame by frame.

import { byId, el } from './ui/dom.ts';
import type { Tabs } from './ui/tabs.ts';
import { view, type Clock, type Data, type Picture, type Plots } from './view.ts';

// A page that was hidden does not catch up.
const LONGEST_TICK = 0.5;

// Something that moves by itself: called once a frame with the seconds since the last one.
export type Live = (elapsed: number) => void;

export interface Show {
  picture: Picture | null;
  clock: Clock;
  data: Data;
  // Shows a motion, at the same time in it where it is the next version of the one before.
  motion(data: Data, how?: { again?: boolean }): void;
  // Shows a figure that is moved by `frame`; `tick` is called as often as the screen draws, until something else is shown;
  // `still`: the camera stays where it is.
  live(data: Data, tick?: Live, how?: { still?: boolean }): void;
  // Poses (seven numbers a link: place, quaternion) of the figure that is live; `forces` of its feet.
  frame(poses: ArrayLike<number>, forces?: { force: number[]; cop: number[] }[]): void;
  isLive(): boolean;
  // Called after every change of what is shown.
  onShow(listener: () => void): void;
}

// An empty floor, before anything is there.
const nothing = (): Data => ({
  figure: '',
  weight: null,
  origin: [0, 0, 0],
  size: 1.9,
  camera: { half: [0.45, 0.95, 0.45], aim: new Float32Array([0, 0.9, 0]) },
  ground: { height: 0, solid: true },
  links: [],
  skins: [],
  time: new Float32Array([0]),
  root: new Float32Array(3),
  positions: new Float32Array(0),
  turns: new Float32Array(0),
  com: null,
  feet: [],
  joints: [],
  forces: [],
} as Data);

export function makeShow(results: Tabs): Show {
  const holder = byId('picture');
  const clock = view.makeClock([0]);
  const [joints, forces] = [el('div', { class: 'curves' }), el('div', { class: 'curves' })];
  // The plots hide what has no curves: a panel of its own is around each.
  results.add({ id: 'joints-curves', title: 'Curves', element: el('div', {}, joints) });
  results.add({ id: 'forces-curves', title: 'Forces', element: el('div', {}, forces) });
  let plots: Plots | null = null;
  let tick: Live | null = null;
  let live = false;
  const listeners: (() => void)[] = [];
  const first = nothing();
  let picture: Picture | null = null;
  try {
    picture = view.makePicture(holder, first, clock);
  } catch (error) {
    // No WebGL: say so, and leave curves and tables.
    const note = byId('no-picture');
    note.hidden = false;
    note.querySelector('small')!.textContent = (error as Error).message;
  }
  const controls = view.makeControls(clock, picture, first);
  picture?.paint(view.readTheme());
  view.onThemeChange(() => {
    picture?.paint(view.readTheme());
    plots?.paint(view.readTheme());
  });
  const bar = document.querySelector<HTMLElement>('.bar')!;

  const self: Show = {
    picture,
    clock,
    data: first,
    motion(data, { again = false } = {}) {
      const share = again && clock.last > clock.first ? (clock.time() - clock.first) / (clock.last - clock.first) : 0;
      const still = again && !live;
      [self.data, live, tick] = [data, false, null];
      bar.classList.remove('live');
      clock.load(data.time);
      clock.seek(clock.first + share * (clock.last - clock.first));
      picture?.load(data, clock, { still });
      controls.load(data);
      if (!again || !plots?.load(data)) {
        plots?.destroy();
        plots = view.makePlots(joints, forces, data, clock, view.readTheme());
      }
      if (data.time.length > 1 && !clock.playing && !matchMedia('(prefers-reduced-motion: reduce)').matches) clock.play();
      listeners.forEach((listener) => listener());
    },
    live(data, next, { still = false } = {}) {
      clock.pause();
      [self.data, live, tick] = [data, true, next ?? null];
      bar.classList.add('live');
      // What one link has is moved in place: places relative to the root, which is told with the first link's.
      data.turns = new Float32Array(data.turns);
      data.positions = new Float32Array(data.positions);
      data.camera.aim = new Float32Array(data.camera.aim);
      // Nobody knows how far the limbs will reach, or whether it will lie.
      data.camera.reach ??= Array(3).fill(Math.max(...data.camera.half));
      clock.load(data.time);
      picture?.load(data, clock, { still });
      controls.load(data);
      plots?.destroy();
      plots = null;
      listeners.forEach((listener) => listener());
    },
    frame(poses, acting = []) {
      const { data } = self;
      const links = data.links.length;
      const origin = data.origin;
      const before = [data.root[0], data.root[1], data.root[2]];
      let moved = false;
      const write = (into: Float32Array, at: number, value: number): void => {
        const old = into[at];
        into[at] = value;
        moved ||= into[at] !== old;
      };
      for (let axis = 0; axis < 3; axis += 1) write(data.root, axis, poses[axis] - origin[axis]);
      for (let link = 0; link < links; link += 1) {
        for (let axis = 0; axis < 3; axis += 1) write(data.positions, 3 * link + axis, poses[7 * link + axis] - poses[axis]);
        for (let part = 0; part < 4; part += 1) write(data.turns, 4 * link + part, poses[7 * link + 3 + part]);
      }
      // The camera goes along on the level, and up and down only with what leaves it.
      data.camera.aim[0] += data.root[0] - before[0];
      data.camera.aim[2] += data.root[2] - before[2];
      data.feet.forEach((foot, i) => {
        for (let axis = 0; axis < 3; axis += 1) {
          write(foot.force, axis, acting[i]?.force[axis] ?? 0);
          write(foot.cop, axis, (acting[i]?.cop[axis] ?? 0) - origin[axis]);
        }
      });
      // Somebody who stands still is drawn once.
      if (moved) picture?.touch();
    },
    isLive: () => live,
    onShow: (listener) => listeners.push(listener),
  };

  let before = performance.now();
  function run(time: number): void {
    const elapsed = Math.min(LONGEST_TICK, Math.max(0, (time - before) / 1000));
    before = time;
    if (tick) tick(elapsed);
    else clock.tick(elapsed);
    picture?.draw();
    requestAnimationFrame(run);
  }
  requestAnimationFrame(run);
  return self;
}
