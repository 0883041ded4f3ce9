// Somebody who is driven by hand: keys, the stick of a gamepad, a click on the floor, buttons.

import './steer.css';
import type { App } from '../app.ts';
import { makeArrow } from '../arrow.ts';
import type { Who } from '../engine/protocol.ts';
import type { Steer, SteeredFrame, SteerPull } from '../engine/steering.ts';
import { makeHands } from '../hands.ts';
import { makeInput, type Way } from '../steer/input.ts';
import { makeMarks, type Marks } from '../steer/marks.ts';
import { button, byId, el, later, number } from '../ui/dom.ts';
import { slider } from '../ui/slider.ts';
import { fold } from '../ui/tabs.ts';
import { three, view, type Data } from '../view.ts';

const DEGREE = Math.PI / 180;
// The longest frame of a walker (s), and how many are asked for before the first of them is there.
const LONGEST = 0.25;
const AHEAD = 3;
// How far limbs and shadows go from the middle, in sizes of the figure: half of a box.
const REACH = [0.36, 0.55, 0.36];
// How far ahead it is to face while it turns: as far as it turns in a step (rad).
const TURN = 24 * DEGREE;
// How much faster with Shift, and how much slower backward and aside.
const [FASTER, SLOWER] = [1.6, 0.5];
// A click moves no farther (pixels) and takes no longer (ms); nobody is sent farther (m).
const [STILL, SHORT, FAR] = [6, 500, 60];
// Larger forces (weights) are none: at the very start of a walk its acceleration jumps.
const MOST = 3.5;
// How often numbers are written (ms), and after how long the hints on the picture go (ms).
const [WRITTEN, HINTED] = [200, 15000];
// Newtons a metre for each kilogram of a hand that drags, its greatest force (weights), and how long (s) and hard (weights) a button pushes.
const [PULL, HARDEST] = [3, 0.25];
const [SHOVE, SHOVES] = [0.5, 0.15];
// What a button pushes, and how far ahead its spring draws (m): so far that the force is always the greatest.
const [SHOVED, AWAY] = ['thorax', 10];
const GRAVITY = 9.80665;
// Steps of which the cadence is the mean, and after how long none it is over (s).
const [STEPS, OVER] = [4, 1.5];

const BENT: Record<string, string> = {
  fast: 'Slower than asked: nobody of this size walks faster.',
  aside: 'Slower than asked: aside and backward nobody walks as fast.',
  sharp: 'Turns more slowly than asked: 25 degrees a step at most.',
  sudden: 'Changes its speed over several steps.',
  balance: 'A foot lands elsewhere than the speed alone would have it, for balance.',
};
const LIMBS: [string, string[]][] = [
  ['Left arm', ['left_shoulder', 'left_elbow', 'left_wrist']],
  ['Right arm', ['right_shoulder', 'right_elbow', 'right_wrist']],
  ['Left forearm', ['left_elbow', 'left_wrist']],
  ['Right forearm', ['right_elbow', 'right_wrist']],
  ['Head', ['neck', 'head']],
];
const WAYS: ([Way, string, string] | 'stop')[] = [
  ['turnLeft', '↶', 'Turn left'], ['forward', '↑', 'Forward'], ['turnRight', '↷', 'Turn right'],
  ['asideLeft', '←', 'Aside to the left'], 'stop', ['asideRight', '→', 'Aside to the right'],
  ['back', '↓', 'Backward'],
];
const PUSHES: [string, string, [number, number]][] = [
  ['From the left', '→', [-1, 0]], ['From behind', '↑', [0, 1]], ['From the front', '↓', [0, -1]], ['From the right', '←', [1, 0]],
];
const AGAINST: Record<Way, Way> = {
  forward: 'back', back: 'forward', turnLeft: 'turnRight', turnRight: 'turnLeft', asideLeft: 'asideRight', asideRight: 'asideLeft',
};

export function makeSteerPanel(app: App): void {
  const { show } = app;
  const who: Who = { height: 1.75, mass: 73 };
  let speed = 1.2;
  let data: Data | null = null;
  let marks: Marks | null = null;
  let state: SteeredFrame | null = null;
  let point: [number, number] | null = null;
  // What was told last, in words: the engine is told again only what is new.
  let told = '';
  let aside = false;
  const loose = new Set<string>();
  const mine = (): boolean => data !== null && show.data === data;

  // --- what is seen
  const out = { speed: el('output'), heading: el('output'), cadence: el('output') };
  const bent = el('p', { class: 'remark', 'aria-live': 'polite' });
  const hints = el('ul', { class: 'steer-hints', hidden: true },
    ...[['↑', 'or', 'W', 'go'], ['←', '→', 'turn'], ['Q', 'E', 'aside'], ['Shift', 'faster']].map((parts) =>
      el('li', {}, ...parts.flatMap((part, i) => [i > 0 && ' ', i === parts.length - 1 || part === 'or' ? part : el('kbd', {}, part)]))),
    el('li', {}, 'click the floor: walk there'),
    el('li', {}, el('kbd', {}, 'Shift'), ' and drag the body: pull'));
  byId('over').append(hints);
  const hide = later(HINTED, () => (hints.hidden = true));
  const begun = (): void => {
    if (hints.classList.contains('used')) return;
    hints.classList.add('used');
    setTimeout(() => (hints.hidden = true), 4000);
  };

  // --- what is asked
  const goTo = (to: [number, number] | null): void => {
    point = to;
    marks?.aim(to);
  };
  const stop = (): void => {
    input.release();
    goTo(null);
    press();
  };
  const input = makeInput(
    (at) => mine() && app.tools.current() === 'steer' && (at === document.body || at?.closest('#picture, #panel-steer, #tool-tabs, .bar') != null),
    begun,
    stop,
  );
  const buttons = WAYS.map((way) => {
    if (way === 'stop') return button('■', stop, { class: 'stop', 'aria-label': 'Stop', title: 'Stop (space bar)' });
    const [name, sign, label] = way;
    return button(sign, () => {
      begun();
      if (!input.down.delete(name)) input.down.add(name);
      input.down.delete(AGAINST[name]);
      press();
    }, { class: name, 'aria-label': label, title: label, 'aria-pressed': 'false' });
  });
  const press = (): void => {
    for (const one of buttons) if (one.hasAttribute('aria-pressed')) one.setAttribute('aria-pressed', String(input.down.has(one.className as Way)));
  };

  function command(): Steer {
    const { left, forward, turn, fast } = input.wanted();
    if (left || forward || turn) {
      if (point) goTo(null);
      begun();
      aside = left !== 0 || forward < 0;
      const full = speed * (fast ? FASTER : 1);
      const heading = (state?.heading ?? 0) + TURN * turn;
      return { kind: 'go', left: full * SLOWER * left, forward: full * (forward < 0 ? SLOWER : 1) * forward, ...(turn !== 0 && { heading }) };
    }
    return point ? { kind: 'to', x: point[0], z: point[1], speed } : { kind: 'stop' };
  }

  // --- pushes: a hand that drags a point of the body, or a button
  const arrow = makeArrow(show);
  let grip: { link: number; point: number[] | null; from: number[]; to: number[] } | null = null;
  let shove = { left: 0, way: [0, 0] as [number, number] };
  const armOf = (link: number): string[] => {
    const side = /^(left|right)_(upper_arm|forearm|hand)$/.exec(data?.links[link]?.name ?? '')?.[1];
    return side ? ['shoulder', 'elbow', 'wrist'].map((joint) => `${side}_${joint}`) : [];
  };
  // An arm that is held gives way.
  let taken: string[] = [];
  const hang = (joints: string[], isLoose: boolean): void =>
    joints.filter((joint) => !wanted().has(joint)).forEach((joint) => app.engine.call('loosen', [joint, isLoose]).catch(app.fault));
  const letGo = (): void => {
    hang(taken, false);
    [grip, taken] = [null, []];
    arrow.draw(null);
  };
  makeHands(show, {
    active: () => mine() && app.tools.current() === 'steer',
    picked: () => {},
    begin({ link, place }) {
      letGo();
      begun();
      grip = { link, point: null, from: place, to: place };
      taken = armOf(link);
      hang(taken, true);
    },
    move(place) {
      if (grip) grip.to = place;
    },
    end: letGo,
  });
  const spring = (): Omit<SteerPull, 'link' | 'point' | 'place'> => ({ stiffness: PULL * who.mass, most: HARDEST * who.mass * GRAVITY });
  // What pushes in a frame of `dt`: the hand, or what is left of a button's push.
  async function pushing(dt: number): Promise<SteerPull | undefined> {
    const held = grip;
    if (held) {
      held.point ??= await app.engine.call<number[]>('steerPoint', [held.link, held.from]);
      return held === grip ? { ...spring(), link: held.link, point: held.point, place: held.to } : undefined;
    }
    const link = data?.links.findIndex(({ name }) => name === SHOVED) ?? -1;
    if (shove.left <= 0 || !state || link < 0) return undefined;
    shove.left -= dt;
    const { stiffness } = spring();
    const most = SHOVES * who.mass * GRAVITY;
    const [sin, cos] = [Math.sin(state.heading), Math.cos(state.heading)];
    const [left, forward] = shove.way;
    const at = [0, 1, 2].map((axis) => state!.poses[7 * link + axis]);
    const place = [at[0] + AWAY * (cos * left + sin * forward), at[1], at[2] + AWAY * (cos * forward - sin * left)];
    return { stiffness, most, link, point: [0, 0, 0], place };
  }
  function drawPull(frame: SteeredFrame): void {
    const { pull, poses } = frame;
    // A frame that was asked for before the hand let go comes after it.
    if (!pull || (!grip && shove.left <= 0)) return arrow.draw(null);
    const length = PULL * who.mass;
    const link = data?.links.findIndex(({ name }) => name === SHOVED) ?? -1;
    if (grip) arrow.draw({ to: grip.to, from: grip.to.map((x, axis) => x - pull[axis] / length), force: pull });
    else if (link >= 0) {
      const at = [0, 1, 2].map((axis) => poses[7 * link + axis]);
      arrow.draw({ from: at, to: at.map((x, axis) => x + pull[axis] / length), force: pull });
    }
  }

  // --- on and on: the next frames are asked for before the last has come, so that neither the screen nor the engine waits for the other.
  let [owed, asked, since] = [0, 0, 0];
  const landings: number[] = [];
  let time = 0;
  function tick(elapsed: number): void {
    owed = Math.min(LONGEST, owed + elapsed);
    if (asked >= AHEAD || owed <= 0) return;
    const ours = data;
    const wish = command();
    const words = JSON.stringify(wish);
    if (words !== told) {
      app.engine.call('steerBy', [wish]).catch(app.fault);
      told = words;
    }
    const dt = owed;
    owed = 0;
    asked += 1;
    pushing(dt)
      .then((pull) => app.engine.call<SteeredFrame>('steerFrame', [dt, pull]))
      .finally(() => (asked -= 1))
      .then(
        (frame) => {
          if (ours === data && mine()) take(frame, dt);
        },
        (error) => {
          if (ours !== data) return;
          data = null;
          app.fault(error);
        },
      );
  }

  function take(frame: SteeredFrame, dt: number): void {
    const { poses, ground, place, heading, velocity, stands, bent: words } = frame;
    state = frame;
    time += dt;
    const [x, y, z] = ground;
    const known = Math.hypot(x, y, z) < MOST * (data?.weight ?? Infinity);
    show.frame(poses, known ? [{ force: [...ground.subarray(0, 3)], cop: [...ground.subarray(3, 6)] }] : []);
    drawPull(frame);
    if (marks?.step(poses, dt)) landings.push(time);
    if (landings.length > STEPS) landings.shift();
    if (point && stands && Math.hypot(point[0] - place[0], point[1] - place[1]) < 0.3) goTo(null);
    const clock = performance.now();
    if (clock - since < WRITTEN) return;
    since = clock;
    out.speed.textContent = `${number(stands ? 0 : Math.hypot(velocity[0], velocity[1]), 2)} m/s`;
    const degrees = Math.round(Math.atan2(Math.sin(heading), Math.cos(heading)) / DEGREE);
    out.heading.textContent = degrees === 0 ? 'straight on' : `${Math.abs(degrees)}° to the ${degrees > 0 ? 'left' : 'right'}`;
    const steps = landings.length - 1;
    const goes = steps > 0 && time - landings[steps] < OVER;
    out.cadence.textContent = goes ? `${number((60 * steps) / (landings[steps] - landings[0]), 0)} steps/min` : '–';
    // A walk that turns goes a little aside by itself.
    const said = stands ? '' : words.filter((word) => word !== 'aside' || aside).map((word) => BENT[word] ?? word).join(' ');
    if (bent.textContent !== said) bent.textContent = said;
  }

  async function start(): Promise<void> {
    try {
      const [json, body] = await Promise.all([app.engine.call<string>('steer', [who]), app.skin({ ...who })]);
      const next = view.readData(json);
      if (body) next.body = body;
      next.camera.reach = REACH.map((part) => part * next.size);
      if (app.tools.current() !== 'steer') return;
      // One arrow for both feet: it stands where the force of the ground as a whole does.
      next.feet = [{ link: 'ground', side: 'middle', force: new Float32Array(3), cop: new Float32Array(3) }];
      // The path of the centre of mass is that of a motion: footprints take its place.
      next.com = null;
      await Promise.all([...wanted()].map((joint) => app.engine.call('loosen', [joint, true])));
      marks?.clear();
      [data, state, point, told, owed] = [next, null, null, '', 0];
      landings.length = 0;
      app.clear();
      byId('title').textContent = 'Steered';
      show.live(next, tick);
      marks = makeMarks(show, who.height);
      if (!hints.classList.contains('used')) {
        hints.hidden = false;
        hide();
      }
    } catch (error) {
      app.fault(error);
    }
  }
  show.onShow(() => {
    if (mine()) return;
    marks?.clear();
    [marks, data] = [null, null];
    letGo();
    shove.left = 0;
    hints.hidden = true;
  });

  // --- who, and what hangs
  const anew = later(300, () => void start());
  const wanted = (): Set<string> => new Set(LIMBS.filter(([label]) => loose.has(label)).flatMap(([, joints]) => joints));
  const limb = (label: string): HTMLElement => {
    const box = el('input', { type: 'checkbox', autocomplete: 'off' });
    box.addEventListener('change', () => {
      const before = wanted();
      if (box.checked) loose.add(label);
      else loose.delete(label);
      const after = wanted();
      for (const joint of new Set([...before, ...after])) {
        if (before.has(joint) !== after.has(joint)) app.engine.call('loosen', [joint, after.has(joint)]).catch(app.fault);
      }
    });
    return el('label', {}, box, label);
  };

  // --- a click on the floor
  const canvas = show.picture?.stage.renderer.domElement;
  let from: { x: number; y: number; at: number } | null = null;
  canvas?.addEventListener('pointerdown', ({ clientX: x, clientY: y, button: which, shiftKey, isPrimary, timeStamp: at }) => {
    from = which === 0 && isPrimary && !shiftKey ? { x, y, at } : null;
  });
  canvas?.addEventListener('pointerup', ({ clientX: x, clientY: y, timeStamp }) => {
    const clicked = from && Math.hypot(x - from.x, y - from.y) < STILL && timeStamp - from.at < SHORT;
    from = null;
    if (!clicked || !mine() || app.tools.current() !== 'steer') return;
    const to = floor(x, y);
    if (!to) return;
    begun();
    input.release();
    press();
    goTo(to);
  });
  function floor(x: number, y: number): [number, number] | null {
    if (!canvas || !data || !show.picture) return null;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const ray = new three.Raycaster();
    ray.setFromCamera(new three.Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height), show.picture.stage.camera);
    const hit = ray.ray.intersectPlane(new three.Plane(new three.Vector3(0, 1, 0), -data.ground.height), new three.Vector3());
    if (!hit || hit.distanceTo(show.picture.stage.controls.target) > FAR) return null;
    return [hit.x + data.origin[0], hit.z + data.origin[2]];
  }

  app.tools.add({
    id: 'steer',
    title: 'Steer',
    element: el(
      'div',
      {},
      el('div', { class: 'steer-pad', role: 'group', 'aria-label': 'Ways to go; each stays pressed until it is pressed again' }, ...buttons),
      el('dl', { class: 'steer-out' }, el('dt', {}, 'Speed'), el('dd', {}, out.speed), el('dt', {}, 'Faces'), el('dd', {}, out.heading), el('dt', {}, 'Cadence'), el('dd', {}, out.cadence)),
      bent,
      slider({ label: 'Walking speed', unit: 'm/s', low: 0.3, high: 2, step: 0.05, value: speed, change: (value) => (speed = value) }).element,
      el('fieldset', { class: 'steer-limbs' }, el('legend', {}, 'Let hang loose'), ...LIMBS.map(([label]) => limb(label))),
      el('div', { class: 'steer-pushes row', role: 'group', 'aria-label': 'Push' },
        el('span', {}, 'Push'),
        ...PUSHES.map(([label, sign, way]) => button(sign, () => {
          begun();
          shove = { left: SHOVE, way };
        }, { 'aria-label': `Push ${label.toLowerCase()}`, title: `${label}, with ${Math.round(SHOVES * 100)} % of the weight for half a second` }))),
      fold(
        'Who walks',
        false,
        slider({ label: 'Height of the walker', unit: 'm', low: 1.2, high: 2.1, step: 0.01, value: who.height, change: (value) => { who.height = value; anew(); } }).element,
        slider({ label: 'Mass of the walker', unit: 'kg', low: 30, high: 150, step: 1, value: who.mass, change: (value) => { who.mass = value; anew(); } }).element,
      ),
      fold(
        'Keys',
        false,
        el('dl', { class: 'steer-keys' }, ...[
          ['↑ ↓, W S', 'forward, backward'], ['← →, A D', 'turn, also on the spot'], ['Q E', 'aside, without turning'], ['Shift', 'faster'], ['Space', 'stop'],
          ['Click, tap', 'on the floor: walk there and stop'], ['Shift and drag', 'at the body: pull it; an arm that is pulled hangs loose meanwhile'], ['Gamepad', 'left stick: go and turn; right stick: aside'],
        ].flatMap(([keys, does]) => [el('dt', {}, keys), el('dd', {}, does)])),
      ),
      button('Back to the start', () => { stop(); void start(); }),
    ),
    shown: () => {
      if (!mine()) void start();
    },
    left: () => {
      stop();
      hints.hidden = true;
    },
  });
}
