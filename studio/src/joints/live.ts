// A scene that goes on by itself: frame by frame, as fast as the machine can, one call at a time.

import type { App } from '../app.ts';
import { makeArrow } from '../arrow.ts';
import type { AliveFrame } from '../engine/scenes.ts';
import type { Picked } from '../pick.ts';
import { button, el, number } from '../ui/dom.ts';
import { three, view } from '../view.ts';

// The longest step of a frame, and that of a single one (s).
const LONGEST = 1 / 20;
const STEP = 1 / 60;
// Frames that are kept, as many as the engine keeps.
const KEPT = 600;
// How far a key pulls (m).
const REACH = 0.3;
// Newtons a metre for each kilogram of the figure: what lifts an arm, and does not shake a toe.
const PULL = 3;

export interface LiveHooks {
  // The link that is chosen.
  link(): number | null;
  // Puts its picture in the place of another.
  showing(act: () => void): void;
  frame(frame: AliveFrame): void;
  fault(error: unknown): void;
  // It began to move, or stands.
  state(playing: boolean): void;
}

export interface Live {
  element: HTMLElement;
  readonly on: boolean;
  start(text: string, mass: number): Promise<void>;
  stop(): void;
  pause(): void;
  step(): void;
  // Back by so many frames of those that were.
  back(frames: number): void;
  target(dof: number, to: number): Promise<void>;
  begin(what: Picked): void;
  move(place: [number, number, number]): void;
  letGo(): void;
}

export function makeLive(app: App, hooks: LiveHooks): Live {
  let on = false;
  let playing = false;
  let busy = false;
  // Seconds that the screen has drawn and the engine has not yet made.
  let owed = 0;
  let mass = 1;
  // What was: the last is now. `at`: which of them is shown.
  let frames: AliveFrame[] = [];
  let at = 0;
  let speed = 1;
  let grip: { link: number; point: number[] | null; from: [number, number, number]; to: [number, number, number] } | null = null;
  // Of which begin the answers are.
  let run = 0;

  const play = button('Pause', () => self.pause(), { class: 'play-live' });
  const one = button('Step', () => self.step());
  const backward = button('Back', () => self.back(1), { 'aria-label': 'Back by a frame' });
  const scrub = el('input', { type: 'range', min: 0, max: 0, step: 1, value: 0, 'aria-label': 'Back to what was' });
  const told = el('output', {});
  const energy = el('table', { class: 'energy' });
  const again = button('Anew', () => void begin(), { title: 'From the beginning' });
  let begin: () => Promise<void> = async () => {};
  const element = el('div', { class: 'alive', hidden: true }, el('div', { class: 'row' }, play, backward, one, again, told), scrub, energy);
  scrub.addEventListener('input', () => {
    if (playing) self.pause();
    show(Number(scrub.value));
  });

  // --- by keys: towards where the arrow points in the picture, while it is held
  const hold = button('Pull by keys', () => hold.focus(), { title: 'The arrow keys pull the chosen link while they are held' });
  element.querySelector('.row')!.append(hold);
  hold.addEventListener('keydown', (event) => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const link = hooks.link();
    const [picture, frame] = [app.show.picture, frames[at]];
    if (!way || link === null || !picture || !frame) return;
    event.preventDefault();
    event.stopPropagation();
    if (grip) return;
    const from = [0, 1, 2].map((axis) => frame.poses[7 * link + axis]) as [number, number, number];
    const [right, up] = [new three.Vector3(), new three.Vector3()];
    picture.stage.camera.matrixWorld.extractBasis(right, up, new three.Vector3());
    self.begin({ link, place: from });
    self.move(from.map((x, axis) => x + REACH * (way[0] * right.getComponent(axis) + way[1] * up.getComponent(axis))) as [number, number, number]);
  });
  for (const over of ['keyup', 'blur']) hold.addEventListener(over, () => grip && self.letGo());

  // --- the pull
  const arrow = makeArrow(app.show);
  function drawPull(force: number[] | null): void {
    if (!force || !grip) return arrow.draw(null);
    // From where the point is: where it should be, less what the spring is long.
    const { to } = grip;
    arrow.draw({ to, from: to.map((x, axis) => x - force[axis] / (PULL * mass)), force });
  }

  const forces = (frame: AliveFrame): { force: number[]; cop: number[] }[] => {
    const links = new Map(app.show.data.links.map(({ name }, link) => [name, link]));
    return app.show.data.feet.map(({ link }) => {
      for (let i = 0; i < frame.contacts.length; i += 7) {
        if (frame.contacts[i] === links.get(link)) return { force: frame.contacts.slice(i + 1, i + 4), cop: frame.contacts.slice(i + 4, i + 7) };
      }
      return { force: [0, 0, 0], cop: [0, 0, 0] };
    });
  };

  function show(index: number): void {
    const frame = frames[index];
    if (!frame) return;
    at = index;
    app.show.frame(frame.poses, forces(frame));
    scrub.max = String(frames.length - 1);
    scrub.value = String(index);
    scrub.setAttribute('aria-valuetext', `${number(frame.time)} s`);
    told.textContent = `${frame.time.toFixed(2)} s${playing && speed < 0.9 ? `, ×${number(speed, 1)}` : ''}`;
    const [moving, height, all] = frame.energy;
    energy.replaceChildren(
      ...[['Motion', moving], ['Height, springs', height], ['Energy', all]].map(([name, value]) =>
        el('tr', {}, el('th', { scope: 'row' }, String(name)), el('td', { class: 'value' }, number(Number(value), 2)), el('td', { class: 'unit' }, 'J')),
      ),
    );
    hooks.frame(frame);
  }

  function keep(frame: AliveFrame): void {
    frames.push(frame);
    if (frames.length > KEPT) frames.shift();
    show(frames.length - 1);
  }

  // One after the other, whatever is asked.
  async function turn(act: () => Promise<void>): Promise<void> {
    if (busy) return;
    busy = true;
    const mine = run;
    try {
      await act();
    } catch (error) {
      if (mine === run) {
        playing = false;
        state();
        hooks.fault(error);
      }
    } finally {
      busy = false;
    }
  }

  // Goes on from what is shown, not from what was beyond it.
  async function rewind(): Promise<void> {
    if (at >= frames.length - 1) return;
    const beyond = frames.length - 1 - at;
    frames.length = at + 1;
    await app.engine.call('aliveBack', [beyond]);
    // Who pulled then does not pull now.
    if (!grip) await app.engine.call('aliveLetGo');
  }

  async function ahead(dt: number): Promise<void> {
    const mine = run;
    await rewind();
    const held = grip;
    if (held) held.point ??= await app.engine.call<number[]>('alivePoint', [held.link, held.from]);
    // Who has let go meanwhile pulls no more.
    const pull = held && held === grip ? { link: held.link, point: held.point, place: held.to, stiffness: PULL * mass } : undefined;
    const frame = await app.engine.call<AliveFrame>('aliveFrame', [dt, pull]);
    if (mine !== run || !on) return;
    keep(frame);
    if (frame.pull && held === grip) drawPull(frame.pull);
  }

  function tick(elapsed: number): void {
    if (!playing) return;
    owed += elapsed;
    if (busy || owed < 1 / 120) return;
    const dt = Math.min(owed, LONGEST);
    speed += 0.1 * (dt / owed - speed);
    owed = 0;
    void turn(() => ahead(dt));
  }

  function state(): void {
    play.textContent = playing ? 'Pause' : 'Play';
    hooks.state(playing);
  }

  const self: Live = {
    element,
    get on() {
      return on;
    },
    async start(text, weighs) {
      begin = () => self.start(text, weighs);
      run += 1;
      const mine = run;
      mass = weighs;
      const { data } = await app.engine.call<{ data: string }>('startScene', [text]);
      if (mine !== run) return;
      [on, playing, owed, at, frames, speed, grip] = [true, true, 0, 0, [], 1, null];
      element.hidden = false;
      hooks.showing(() => app.show.live(view.readData(data), tick, { still: true }));
      state();
      keep(await app.engine.call<AliveFrame>('aliveBack', [0]));
    },
    stop() {
      if (!on) return;
      run += 1;
      [on, playing, grip] = [false, false, null];
      element.hidden = true;
      drawPull(null);
      state();
    },
    pause() {
      if (!on) return;
      playing = !playing;
      owed = 0;
      state();
    },
    step() {
      if (!on) return;
      playing = false;
      state();
      void turn(() => ahead(STEP));
    },
    back(count) {
      if (!on) return;
      playing = false;
      state();
      show(Math.max(0, at - count));
    },
    async target(dof, to) {
      await rewind();
      await app.engine.call('aliveTarget', [dof, to]);
    },
    begin(what) {
      grip = { link: what.link, point: null, from: what.place, to: what.place };
    },
    move(place) {
      if (grip) grip.to = place;
    },
    letGo() {
      grip = null;
      drawPull(null);
      if (on) app.engine.call('aliveLetGo').catch(hooks.fault);
    },
  };
  return self;
}
