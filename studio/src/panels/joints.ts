// Joints are driven: posed, frozen, freed, sent along curves. A face of the scene's text, which says all of it.

import './joints.css';
import type { App } from '../app.ts';
import type { Edit, SceneDocument } from '../document.ts';
import type { Pose } from '../engine/figures.ts';
import type { Dof, PosedFigure } from '../engine/protocol.ts';
import type { RanScene } from '../engine/scenes.ts';
import { makeChosen } from '../joints/chosen.ts';
import type { Outcome } from '../joints/drives.ts';
import { makeHands } from '../hands.ts';
import { makeHighlight } from '../joints/highlight.ts';
import { choose } from '../joints/inputs.ts';
import { makeLive } from '../joints/live.ts';
import { ranRows } from '../joints/ran.ts';
import { makeScenePart } from '../joints/scene-part.ts';
import { field, parse } from '../joints/ron.ts';
import { limbOf, startEdits } from '../joints/start.ts';
import { nothing } from '../joints/state.ts';
import { makeJointList } from '../joints/tree.ts';
import type { Picked } from '../pick.ts';
import { button, byId, el, later, latest } from '../ui/dom.ts';
import { view } from '../view.ts';

// How long a slider rests before its place is written (ms).
const REST = 300;
const SCENE = 'scene';
// For whatever is too stiff to be simulated while it is looked at.
const IMPULSES = 'Impulses(step: 0.001)';
// Of a human whose shoulders no motion takes into gimbal lock.
const LIMP = 'Limp';

export function makeJointsPanel(app: App, text: SceneDocument): void {
  const at = nothing();
  let mass = 1;
  // Which figure the engine poses, and what the picture has of it.
  let posed = '';
  let data = '';
  // The picture has it already, by the camera that the reader turned.
  let seen = false;
  const isOpen = (): boolean => app.tools.current() === 'joints';

  // --- what is written
  let waiting: Edit[] = [];
  const flush = latest(async () => {
    while (waiting.length > 0) {
      const edits = waiting;
      waiting = [];
      await text.edit(edits);
    }
  });
  function write(edits: Edit[]): Promise<void> {
    const same = (a: Edit, b: Edit): boolean => a.path.join('\0') === b.path.join('\0');
    waiting = [...waiting.filter((old) => !edits.some((edit) => same(edit, old))), ...edits];
    return flush();
  }
  const openText = (): void => app.tools.open(SCENE);

  // --- the parts of the panel
  const simulate = button('Simulate', () => void runScene(), { class: 'main' });
  const playLive = button('Play live', () => void goLive());
  const pose = button('Pose', () => void showPose(), { title: 'Back to how it begins' });
  const bar = el('progress', { max: 1, hidden: true, 'aria-label': 'How far the run is' });
  const words = el('span', { class: 'remark', 'aria-live': 'polite' });
  const stop = button('Stop', () => app.engine.stop(), { hidden: true });
  const wrong = el('div', { role: 'alert' });
  // Of the last run.
  const failed = el('div', { role: 'alert' });
  const remarks = el('div', { class: 'remark', 'aria-live': 'polite' });
  const live = makeLive(app, {
    link: () => highlight.link,
    showing: (act) => showing('live', act),
    frame(frame) {
      at.q = frame.q;
      at.moments = frame.forces;
      chosen.numbers(true);
    },
    fault: (error) => say(error),
    state() {
      chosen.enable();
    },
  });
  const list = makeJointList((name) => select(name));
  const chosen = makeChosen(at, text, {
    engine: app.engine,
    isLive: () => live.on,
    moves: async (dof, to) => (live.on ? live.target(dof.index, to) : moveTo(dof, to)),
    write,
    openText,
  });
  const reach = choose('A drag with Shift moves', [['0', 'the limb'], ...[1, 2, 3, 4, 6].map((n): [string, string] => [String(n), n === 1 ? 'one joint' : `up to ${n} joints`])], '0', () => {});
  const scenePart = makeScenePart(app, text, write, openText);
  const element = el(
    'div',
    { class: 'joints' },
    el('div', { class: 'row actions-row' }, simulate, playLive, pose, stop),
    bar,
    words,
    wrong,
    failed,
    live.element,
    remarks,
    scenePart.element,
    list.element,
    chosen.element,
    reach.element,
  );

  // What is typed is the field's, not the picture's.
  element.addEventListener('keydown', (event) => {
    const typing = (event.target as Element).matches('input:not([type=checkbox])');
    if (typing && !event.altKey && !event.ctrlKey && !event.metaKey && event.key !== 'Escape') event.stopPropagation();
  });

  const highlight = makeHighlight(app.show);
  let ours = false;
  app.show.onShow(() => {
    if (ours) return;
    // Somebody else shows something.
    live.stop();
    at.shows = null;
  });
  let starting = false;
  const showing = (what: typeof at.shows, act: () => void): void => {
    ours = true;
    act();
    ours = false;
    at.shows = what;
  };

  // --- what is wrong, in the program's own words
  function say(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    if (message === 'stopped') return;
    failed.replaceChildren(el('p', { class: 'fault' }, message));
    if (/too long for|stiff/.test(message) && !field(at.tree, 'method')) {
      failed.append(button('Take steps by impulses', () => void write([{ path: ['method'], value: IMPULSES }]), { title: `method: ${IMPULSES}` }));
    }
    const angles = (field(at.tree, 'figures')?.entries ?? []).filter(({ value }) => value.name === 'Human' && !value.fields?.has('joints'));
    if (message.includes('gimbal lock') && angles.length > 0) {
      const edits = angles.map(({ key }) => ({ path: ['figures', key, 'joints'], value: LIMP }));
      failed.append(button('Take joints that never lock', () => void write(edits), { title: `joints: ${LIMP}` }));
    }
    // Beside the joint that it names, too.
    const named = at.joints.find(({ name, dofs }) => message.includes(`'${name}'`) || dofs.some((dof) => message.includes(`'${dof.name}'`)));
    if (!named) return;
    if (named.name !== at.chosen) failed.append(button(`Show ${named.name}`, () => select(named.name)));
    chosen.fault(message);
  }

  function sayFaults(): void {
    const own = chosen.faults();
    const others = text.faults.filter((fault) => !own.has(fault));
    wrong.replaceChildren(
      ...others.slice(0, 5).map(({ line, message }) => el('p', { class: 'fault' }, `Line ${line}: ${message}`)),
      ...(text.faults.length > 0 ? [button('Edit in Scene', openText)] : []),
    );
    for (const control of [simulate, playLive, pose]) control.disabled = text.faults.length > 0;
  }

  // --- the pose
  // What makes it another figure.
  const figureKey = (): string =>
    ['include', 'figures', 'places', 'gravity', 'ground'].map((name) => field(at.tree, name)).map((node) => (node ? text.text.slice(node.from, node.to) : '')).join('\0');

  async function ensurePosed(): Promise<void> {
    const key = figureKey();
    if (posed !== key) {
      const before = at.shows;
      const figure = await app.engine.call<PosedFigure>('poseScene', [text.text]);
      // What began to move meanwhile is not stopped.
      if (live.on || starting || at.shows !== before) return;
      [posed, data, at.links, mass] = [key, figure.data, figure.links, figure.mass];
      at.shows = null;
      seen = false;
      showList();
    }
    if (at.shows === 'pose') return;
    const still = seen;
    seen = true;
    showing('pose', () => app.show.live(view.readData(data), undefined, { still }));
    byId('title').textContent = text.outline?.name ?? '';
  }

  const posing = latest(async () => {
    if (live.on || starting) return;
    try {
      await ensurePosed();
      const now = await app.engine.call<Pose>('poseTo', [at.q]);
      if (at.shows !== 'pose') return;
      at.moments = now.moments;
      app.show.frame(now.poses);
      chosen.numbers(false);
    } catch (error) {
      posed = '';
      say(error);
    }
  });

  async function showPose(): Promise<void> {
    live.stop();
    forget();
    if (!at.ahead && text.outline) at.q = [...text.outline.q];
    await posing();
  }

  function showJoint(): void {
    chosen.show();
    sayFaults();
  }

  function syncJoint(): void {
    chosen.sync();
    sayFaults();
  }

  function forget(): void {
    at.outcomes = [];
    remarks.replaceChildren();
    failed.replaceChildren();
    chosen.forget();
  }

  async function writeStart(): Promise<void> {
    const edits = startEdits(at, text.outline?.q ?? at.q);
    if (edits.length > 0) await write(edits);
    at.ahead = false;
  }
  const writeLater = later(REST, () => void writeStart());

  function moveTo(dof: Dof, value: number): void {
    at.q = [...at.q];
    at.q[dof.coordinate!] = value;
    at.ahead = true;
    void posing();
    writeLater();
  }

  // How many joints give way to a drag: as many as said, or those of the limb.
  const reachOf = (link: number): number => Number(reach.value) || limbOf(at, link);

  // --- hands on the picture
  let grip: { link: number; point: number[] } | null = null;
  let was: number[] = [];
  const dragTo = latest(async (place: [number, number, number]) => {
    if (!grip) return;
    const now = await app.engine.call<Pose>('poseDrag', [grip.link, grip.point, place, reachOf(grip.link)]).catch((error) => say(error));
    if (!now || !grip) return;
    [at.q, at.moments, at.ahead] = [now.q, now.moments, true];
    app.show.frame(now.poses);
    chosen.numbers(false);
  });
  makeHands(app.show, {
    active: () => isOpen() && (at.shows === 'pose' || at.shows === 'live' || at.shows === 'motion'),
    picked: (what) => selectLink(what),
    begin(what) {
      selectLink(what);
      if (live.on) return live.begin(what);
      was = [...at.q];
      void (async () => {
        if (at.shows !== 'pose') return;
        grip = { link: what.link, point: await app.engine.call<number[]>('posePoint', [what.link, what.place]) };
      })().catch(say);
    },
    move(place) {
      if (live.on) live.move(place);
      else void dragTo(place);
    },
    end(given) {
      if (live.on) return live.letGo();
      if (!grip) return;
      grip = null;
      if (given) void writeStart();
      else {
        [at.q, at.ahead] = [was, false];
        void posing();
      }
    },
  });

  function selectLink({ link }: Picked): void {
    // The joint that carries it, or the nearest one above that moves.
    for (let one: number | null = link; one !== null; one = at.links[one]?.parent ?? null) {
      const joint = at.joints.find(({ link: name }) => name === app.show.data.links[one!]?.name);
      if (joint && joint.dofs.length > 0) return select(joint.name, link);
    }
  }

  function select(name: string, link?: number): void {
    const joint = at.joints.find((one) => one.name === name);
    if (!joint) return;
    const again = at.chosen === name;
    at.chosen = name;
    list.choose(name);
    highlight.link = link ?? app.show.data.links.findIndex((one) => one.name === joint.link);
    if (!again) showJoint();
  }

  function showList(): void {
    const depths = new Map<string, number>();
    for (const { name, parent } of at.links) depths.set(name, parent === null ? 0 : (depths.get(at.links[parent].name) ?? 0) + 1);
    const drives = text.outline?.drives ?? [];
    list.set(
      at.joints
        .filter(({ dofs }) => dofs.length > 0)
        .map((joint) => ({
          joint,
          depth: Math.min(8, depths.get(joint.link) ?? 0),
          word: [...new Set(joint.dofs.map(({ index }) => drives[index]?.steps.map(({ drive }) => drive).join(', ') || 'free'))].join(' · '),
        })),
    );
  }

  // --- the text changed
  let fresh = true;
  function sync(): void {
    at.tree = parse(text.text) ?? at.tree;
    const { outline } = text;
    if (outline) {
      const other = JSON.stringify(outline.joints) !== JSON.stringify(at.joints);
      if (other) at.joints = outline.joints;
      if (!at.ahead && !live.on) at.q = [...outline.q];
      if (other) {
        if (!at.joints.some(({ name }) => name === at.chosen)) at.chosen = null;
        showList();
        showJoint();
      }
      showList();
    }
    scenePart.sync(at.tree);
    failed.replaceChildren();
    syncJoint();
    if (outline && !live.on && (at.shows !== 'motion' || !fresh)) {
      if (at.shows === 'motion') forget();
      void posing();
    }
    fresh = false;
  }
  text.onCheck(() => {
    if (isOpen()) sync();
    else fresh = true;
  });
  const anew = app.engine.onAnew;
  app.engine.onAnew = () => {
    anew();
    live.stop();
    [posed, at.shows] = ['', null];
  };

  // --- runs
  async function settled(): Promise<void> {
    if (at.ahead) await writeStart();
    await flush();
  }

  async function runScene(): Promise<void> {
    await settled();
    live.stop();
    forget();
    [bar.hidden, stop.hidden, simulate.disabled] = [false, false, true];
    bar.removeAttribute('value');
    try {
      const ran = await app.engine.call<RanScene>('runScene', [text.text], (share, now) => {
        if (share !== null) bar.value = share;
        if (now) words.textContent = now;
      });
      const report = ran.report as unknown as Record<string, unknown> & { drives: Outcome[] };
      at.outcomes = report.drives ?? [];
      showing('motion', () => app.showMotion(ran, ranRows(ran)));
      remarks.replaceChildren(...ran.remarks.map((remark) => el('p', {}, remark)));
      syncJoint();
    } catch (error) {
      say(error);
      if (error instanceof Error && error.message === 'stopped') void showPose();
    } finally {
      [bar.hidden, stop.hidden, simulate.disabled] = [true, true, false];
      words.textContent = '';
    }
  }

  async function goLive(): Promise<void> {
    await settled();
    forget();
    starting = true;
    try {
      await live.start(text.text, mass);
    } catch (error) {
      say(error);
    } finally {
      starting = false;
    }
    syncJoint();
  }

  document.addEventListener('keydown', (event) => {
    if (!isOpen() || !live.on || event.ctrlKey || event.metaKey || event.altKey) return;
    if ((event.target as Element).closest?.('button, select, summary, input, [role=listbox], .curve-drawing')) return;
    const act = { ' ': live.pause, ArrowRight: live.step, ArrowLeft: () => live.back(event.shiftKey ? 10 : 1) }[event.key];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  }, true);

  app.tools.add({
    id: 'joints',
    title: 'Joints',
    element,
    shown() {
      // Others may have posed another figure meanwhile.
      [posed, at.shows, fresh, seen] = ['', null, true, false];
      highlight.show(true);
      if (text.outline || text.faults.length > 0) sync();
      else text.set(text.text);
    },
    left() {
      live.stop();
      highlight.show(false);
    },
  });
  showJoint();
}
