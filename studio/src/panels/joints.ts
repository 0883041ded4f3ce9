// Joints are driven: posed, frozen, freed, sent along curves. A face of the scene's text, which says all of it.

import './joints.css';
import type { App } from '../app.ts';
import { row } from '../app.ts';
import type { Edit, SceneDocument } from '../document.ts';
import type { Pose } from '../engine/figures.ts';
import type { Dof, JointOutline, PosedFigure, Row } from '../engine/protocol.ts';
import type { RanScene } from '../engine/scenes.ts';
import { makeDrives, unitOf, type Drives, type Outcome } from '../joints/drives.ts';
import { makeHands } from '../joints/hands.ts';
import { makeHighlight } from '../joints/highlight.ts';
import { choose } from '../joints/inputs.ts';
import { makeLive } from '../joints/live.ts';
import { coordinatesOf, drivesOf, isWhole } from '../joints/said.ts';
import { makeScenePart } from '../joints/scene-part.ts';
import { DEGREE, field, parse, plain, position, quote, type Node } from '../joints/ron.ts';
import { makeJointList } from '../joints/tree.ts';
import type { Picked } from '../pick.ts';
import { button, byId, el, later, latest, number } from '../ui/dom.ts';
import { slider, type Slider } from '../ui/slider.ts';
import { view } from '../view.ts';

// How long a slider rests before its place is written (ms).
const REST = 300;
// Of angles without limits, and of slides (m).
const [FAR, WIDE] = [Math.PI, 1];
const SCENE = 'scene';
// For whatever is too stiff to be simulated while it is looked at.
const IMPULSES = 'Impulses(step: 0.001)';

interface DofView {
  dof: Dof;
  slider: Slider | null;
  moment: HTMLElement;
  drives: Drives;
  hasServo: boolean;
}

export function makeJointsPanel(app: App, text: SceneDocument): void {
  let tree: Node | null = null;
  let joints: JointOutline[] = [];
  let links: PosedFigure['links'] = [];
  let mass = 1;
  let q: number[] = [];
  let moments: number[] = [];
  let chosen: string | null = null;
  let outcomes: Outcome[] = [];
  // Which figure the engine poses, and what the picture has of it.
  let posed = '';
  let data = '';
  // The picture has it already, by the camera that the reader turned.
  let seen = false;
  let shows: 'pose' | 'motion' | 'live' | null = null;
  // The pose of the panel is newer than that of the text.
  let ahead = false;
  let views: DofView[] = [];
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
    frame(frame) {
      q = frame.q;
      moments = frame.forces;
      showNumbers(true);
    },
    fault: (error) => say(error),
    state() {
      for (const one of views) enable(one);
    },
  });
  const list = makeJointList((name) => select(name));
  const details = el('div', { class: 'joint', role: 'region', 'aria-label': 'The chosen joint' });
  const reach = choose('A drag with Shift moves', [['0', 'the limb'], ...[1, 2, 3, 4, 6].map((n): [string, string] => [String(n), n === 1 ? 'one joint' : `up to ${n} joints`])], '0', () => {});
  const scenePart = makeScenePart(app, text, (edits) => void write(edits), openText);
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
    details,
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
    shows = null;
  });
  const showing = (what: typeof shows, act: () => void): void => {
    ours = true;
    act();
    ours = false;
    shows = what;
  };

  // --- what is wrong, in the program's own words
  function say(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    if (message === 'stopped') return;
    failed.replaceChildren(el('p', { class: 'fault' }, message));
    if (/too long for|stiff/.test(message) && !field(tree, 'method')) {
      failed.append(button('Take steps by impulses', () => void write([{ path: ['method'], value: IMPULSES }]), { title: `method: ${IMPULSES}` }));
    }
    // Beside the joint that it names, too.
    const named = joints.find(({ name, dofs }) => message.includes(`'${name}'`) || dofs.some((dof) => message.includes(`'${dof.name}'`)));
    if (!named) return;
    if (named.name !== chosen) failed.append(button(`Show ${named.name}`, () => select(named.name)));
    views.find(({ dof }) => message.includes(`'${dof.name}'`))?.drives.fault(message);
  }

  function sayFaults(): void {
    const own = new Set<unknown>();
    for (const { dof, drives } of views) {
      const joint = joints.find(({ dofs }) => dofs.includes(dof))!;
      const { span } = drivesOf(text.text, tree, joint, dof);
      const here = text.faults.filter(({ from, to }) => span && from >= span[0] && to <= span[1]);
      drives.fault(here.length > 0 ? here.map(({ message }) => message).join('\n') : null);
      here.forEach((fault) => own.add(fault));
    }
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
    ['include', 'figures', 'places', 'gravity', 'ground'].map((name) => field(tree, name)).map((node) => (node ? text.text.slice(node.from, node.to) : '')).join('\0');

  async function ensurePosed(): Promise<void> {
    const key = figureKey();
    if (posed !== key) {
      const figure = await app.engine.call<PosedFigure>('poseScene', [text.text]);
      [posed, data, links, mass] = [key, figure.data, figure.links, figure.mass];
      shows = null;
      seen = false;
      showList();
    }
    if (shows === 'pose') return;
    const still = seen;
    seen = true;
    showing('pose', () => app.show.live(view.readData(data), undefined, { still }));
    byId('title').textContent = text.outline?.name ?? '';
  }

  const posing = latest(async () => {
    if (live.on) return;
    try {
      await ensurePosed();
      const now = await app.engine.call<Pose>('poseTo', [q]);
      if (shows !== 'pose') return;
      moments = now.moments;
      app.show.frame(now.poses);
      showNumbers(false);
    } catch (error) {
      posed = '';
      say(error);
    }
  });

  async function showPose(): Promise<void> {
    live.stop();
    forget();
    if (!ahead && text.outline) q = [...text.outline.q];
    await posing();
  }

  function forget(): void {
    outcomes = [];
    remarks.replaceChildren();
    failed.replaceChildren();
    for (const { drives } of views) drives.outcomes([]);
  }

  // Coordinates of q that differ from those of the text, as edits of its start.
  function startEdits(before: number[]): Edit[] {
    const places = coordinatesOf(joints, q.length);
    return joints.flatMap(({ name, dofs }): Edit[] => {
      if (isWhole(dofs)) {
        const [at, count] = places.get(name) ?? [0, 0];
        const now = q.slice(at, at + count);
        // A free joint stays where it is: only turns are written.
        if (count !== 4 || now.every((value, i) => Math.abs(value - before[at + i]) < 1e-9)) return [];
        return [{ path: ['start', quote(name)], value: `Quaternion(${now.map((part) => plain(part, 8)).join(', ')})` }];
      }
      return dofs
        .filter(({ coordinate }) => coordinate !== null && Math.abs(q[coordinate] - before[coordinate]) > 1e-7)
        .map((dof) => ({ path: ['start', quote(dof.name)], value: position(q[dof.coordinate!], dof.turns) }));
    });
  }

  async function writeStart(): Promise<void> {
    const edits = startEdits(text.outline?.q ?? q);
    if (edits.length > 0) await write(edits);
    ahead = false;
  }
  const writeLater = later(REST, () => void writeStart());

  function moveTo(dof: Dof, value: number): void {
    q = [...q];
    q[dof.coordinate!] = value;
    ahead = true;
    void posing();
    writeLater();
  }

  // How many joints give way: as many as said, or up to the shoulder or the hip, or three.
  function reachOf(link: number): number {
    if (reach.value !== '0') return Number(reach.value);
    let count = 0;
    for (let at: number | null = link; at !== null; at = links[at]?.parent ?? null) {
      const joint = joints.find(({ link: name }) => name === links[at!]?.name);
      if (joint && joint.dofs.length > 0) count += 1;
      if (joint && /(shoulder|hip)$/.test(joint.name)) return count;
    }
    return 3;
  }

  // --- hands on the picture
  let grip: { link: number; point: number[] } | null = null;
  let was: number[] = [];
  const dragTo = latest(async (place: [number, number, number]) => {
    if (!grip) return;
    const now = await app.engine.call<Pose>('poseDrag', [grip.link, grip.point, place, reachOf(grip.link)]).catch((error) => say(error));
    if (!now || !grip) return;
    [q, moments, ahead] = [now.q, now.moments, true];
    app.show.frame(now.poses);
    showNumbers(false);
  });
  makeHands(app.show, {
    active: () => isOpen() && (shows === 'pose' || shows === 'live' || shows === 'motion'),
    picked: (what) => selectLink(what),
    begin(what) {
      selectLink(what);
      if (live.on) return live.begin(what);
      was = [...q];
      void (async () => {
        if (shows !== 'pose') return;
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
        [q, ahead] = [was, false];
        void posing();
      }
    },
  });

  function selectLink({ link }: Picked): void {
    // The joint that carries it, or the nearest one above that moves.
    for (let at: number | null = link; at !== null; at = links[at]?.parent ?? null) {
      const joint = joints.find(({ link: name }) => name === app.show.data.links[at!]?.name);
      if (joint && joint.dofs.length > 0) return select(joint.name, link);
    }
  }

  function select(name: string, link?: number): void {
    const joint = joints.find((one) => one.name === name);
    if (!joint) return;
    const again = chosen === name;
    chosen = name;
    list.choose(name);
    highlight.link = link ?? app.show.data.links.findIndex((one) => one.name === joint.link);
    if (!again) showJoint();
  }

  // --- the chosen joint
  function showJoint(): void {
    const joint = joints.find(({ name }) => name === chosen);
    views = [];
    if (!joint) {
      details.replaceChildren(el('p', { class: 'remark' }, 'Choose a joint in the list, or click a link in the picture.'));
      return;
    }
    const whole = isWhole(joint.dofs);
    views = joint.dofs.map((dof) => makeView(joint, dof));
    details.replaceChildren(
      el('h2', {}, joint.name),
      el('p', { class: 'remark' }, `carries ${joint.link.replaceAll('_', ' ')}`),
      ...(joint.dofs.length > 1 ? [wholeJoint(joint, whole)] : []),
      ...views.map(({ dof, slider: made, moment, drives }) =>
        el('section', { class: 'dof', 'aria-label': dof.name }, made?.element ?? el('h2', {}, dof.name), moment, ...(whole ? [] : [drives.element])),
      ),
    );
    syncJoint();
  }

  // One mode for all degrees of freedom of a joint; a ball or free joint has no other.
  function wholeJoint(joint: JointOutline, whole: boolean): HTMLElement {
    const said = drivesOf(text.text, tree, joint, null);
    const modes: [string, string][] = [['', 'each by itself'], ['Frozen', 'Frozen'], ['Free', 'Free'], ...(whole ? [] : [['Servo', 'Spring, servo'] as [string, string]]), ['others', 'as the others']];
    const mode = choose('Whole joint', modes, whole && said.from === null ? said.text : '', (kind) => {
      const names = whole ? [joint.name] : joint.dofs.map(({ name }) => name);
      void write([
        // What the joint's own name says is said by its parts from now on.
        ...(whole ? [] : [{ path: ['drives', quote(joint.name)], value: null }]),
        ...names.map((name, i) => {
          const servo = (): string => {
            const dof = joint.dofs[i];
            return `Servo(to: ${position(atOf(dof), dof.turns)}, stiffness: ${dof.turns ? '100.0' : '2000.0'}, damping: ${dof.turns ? '10.0' : '200.0'})`;
          };
          return { path: ['drives', quote(name)], value: kind === 'Servo' ? servo() : kind === 'Frozen' || kind === 'Free' ? kind : null };
        }),
      ]);
    });
    return mode.element;
  }

  const atOf = (dof: Dof): number => (dof.coordinate === null ? 0 : ((ahead ? q : text.outline?.q)?.[dof.coordinate] ?? 0));

  function makeView(joint: JointOutline, dof: Dof): DofView {
    const scale = dof.turns ? DEGREE : 1;
    const far = dof.turns ? FAR : WIDE;
    const short = dof.name.startsWith(`${joint.name}.`) ? dof.name.slice(joint.name.length + 1) : dof.name;
    const made =
      dof.coordinate === null
        ? null
        : slider({
            label: short === dof.name ? dof.name : `${joint.name} ${short}`,
            unit: unitOf('position', dof.turns),
            low: Math.round((dof.lower ?? -far) / scale),
            high: Math.round((dof.upper ?? far) / scale),
            step: dof.turns ? 1 : 0.01,
            value: (q[dof.coordinate] ?? 0) / scale,
            change(value) {
              const own = value * scale;
              const below = dof.lower !== null && own < dof.lower - 1e-9;
              if (below || (dof.upper !== null && own > dof.upper + 1e-9)) {
                made!.fault(`${dof.name} goes from ${number((dof.lower ?? 0) / scale, 1)} to ${number((dof.upper ?? 0) / scale, 1)} ${unitOf('position', dof.turns)}`);
                return;
              }
              made!.fault(null);
              if (live.on) live.target(dof.index, own).catch((error: Error) => made!.fault(error.message));
              else moveTo(dof, own);
            },
          });
    const drives = makeDrives(
      {
        engine: app.engine,
        names: () => joints.flatMap(({ dofs }) => dofs.filter(({ coordinate }) => coordinate !== null).map(({ name }) => name)),
        turns: (name) => joints.flatMap(({ dofs }) => dofs).find((one) => one.name === name)?.turns ?? true,
        duration: () => text.outline?.duration ?? 1,
        at: atOf,
        write: (name, value) => void write([{ path: ['drives', quote(name)], value }]),
        openText,
      },
      dof,
    );
    return { dof, slider: made, moment: el('p', { class: 'moment' }), drives, hasServo: false };
  }

  function enable({ slider: made, hasServo }: DofView): void {
    if (!made) return;
    const can = !live.on || hasServo;
    made.element.querySelectorAll('input').forEach((input) => (input.disabled = !can));
    made.element.classList.toggle('target', live.on && hasServo);
    made.element.title = live.on ? (hasServo ? 'The target of the servo' : 'Where it is') : 'Where it begins';
  }

  function syncJoint(): void {
    const joint = joints.find(({ name }) => name === chosen);
    if (!joint) return;
    for (const one of views) {
      const said = drivesOf(text.text, tree, joint, one.dof);
      one.drives.set(said.text, said.from);
      one.drives.outcomes(outcomes.filter(({ dof }) => dof === one.dof.name));
      one.hasServo = said.text.includes('Servo(');
      enable(one);
    }
    sayFaults();
    showNumbers(live.on);
  }

  // Positions and moments of the chosen joint.
  function showNumbers(running: boolean): void {
    for (const { dof, slider: made, moment, hasServo } of views) {
      if (made && !(running && hasServo)) made.value = (q[dof.coordinate!] ?? 0) / (dof.turns ? DEGREE : 1);
      const unit = unitOf('force', dof.turns);
      const where = running && dof.coordinate !== null ? `at ${number(q[dof.coordinate] / (dof.turns ? DEGREE : 1), 1)} ${unitOf('position', dof.turns)}, ` : '';
      const value = moments[dof.index];
      moment.textContent = value === undefined || shows === 'motion' ? '' : `${where}${running ? 'acts with' : 'held by'} ${number(value, 2)} ${unit}`;
    }
  }

  function showList(): void {
    const depths = new Map<string, number>();
    for (const { name, parent } of links) depths.set(name, parent === null ? 0 : (depths.get(links[parent].name) ?? 0) + 1);
    const drives = text.outline?.drives ?? [];
    list.set(
      joints
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
    tree = parse(text.text) ?? tree;
    const { outline } = text;
    if (outline) {
      const other = JSON.stringify(outline.joints) !== JSON.stringify(joints);
      if (other) joints = outline.joints;
      if (!ahead && !live.on) q = [...outline.q];
      if (other) {
        if (!joints.some(({ name }) => name === chosen)) chosen = null;
        showList();
        showJoint();
      }
      showList();
    }
    scenePart.sync(tree);
    failed.replaceChildren();
    syncJoint();
    sayFaults();
    if (outline && !live.on && (shows !== 'motion' || !fresh)) {
      if (shows === 'motion') forget();
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
    [posed, shows] = ['', null];
  };

  // --- runs
  async function settled(): Promise<void> {
    if (ahead) await writeStart();
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
      outcomes = report.drives ?? [];
      showing('motion', () => app.showMotion(ran, rows(ran)));
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
    try {
      ours = true;
      await live.start(text.text, mass);
      shows = 'live';
    } catch (error) {
      say(error);
    } finally {
      ours = false;
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
      [posed, shows, fresh, seen] = ['', null, true, false];
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

// What is measured of a run.
function rows({ report, remarks, duration }: RanScene): Row[] {
  const { method, why, energy } = report as unknown as { method: string; why: string; energy: Record<string, number> };
  const found: Row[] = [row('Duration', duration, 's'), { label: 'Method', value: '', unit: '', note: `${method}: ${why}` }];
  for (const [name, value] of Object.entries(energy ?? {})) {
    if (typeof value !== 'number' || !name.endsWith('_j')) continue;
    const plainName = name.slice(0, -2).replaceAll('_', ' ');
    found.push(row(plainName[0].toUpperCase() + plainName.slice(1), value, 'J', 3));
  }
  for (const remark of remarks) found.push({ label: '', value: '', unit: '', note: remark });
  return found;
}
