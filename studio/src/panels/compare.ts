// Compare and look: a motion that is kept beside the next one, any quantity over another, distances, paths.

import './compare.css';
import type { App } from '../app.ts';
import { distances, placeOf, quantities, stride, valueAt, type Quantity, type Stride } from '../curves.ts';
import type { People } from '../engine/protocol.ts';
import { makeGhost } from '../ghost.ts';
import { makeMeasure } from '../measure.ts';
import { makeChart, type ChartBand, type ChartLine } from '../ui/chart.ts';
import { button, el } from '../ui/dom.ts';
import { three, view, type Data, type Frame } from '../view.ts';

// How far beside the other one stands, in sizes of the figure.
const BESIDE = 0.7;
// The fastest pace that people's curves are of, over the root of gravity times the leg, and half a pace: who is faster runs.
const FASTEST = 0.76;
const DISTANCE = 'Distance of the two points';
const ACROSS: [string, string][] = [['time', 'time'], ['share', 'percent of the motion'], ['stride', 'percent of a stride']];

export function makeComparePanel(app: App): void {
  const { show } = app;
  const ghost = makeGhost(app);
  let kept: { data: Data; title: string; key: number | null } | null = null;

  // --- the motion that is kept
  const name = el('p', { class: 'remark', 'aria-live': 'polite' });
  const select = (label: string, options: [string, string][], change: () => void): HTMLSelectElement => {
    const made = el('select', { 'aria-label': label, autocomplete: 'off' }, ...options.map(([value, text]) => el('option', { value }, text)));
    made.addEventListener('change', change);
    return made;
  };
  const choice = (label: string, made: HTMLElement): HTMLElement => el('label', { class: 'choice' }, el('span', {}, label), made);
  const by = select('Goes along by', [['time', 'time'], ['share', 'percent of its duration']], () => set());
  const where = select('Stands', [['0', 'in the same place'], ['1', 'beside it']], () => set());
  const set = (): void => {
    ghost.set(by.value as 'time' | 'share', Number(where.value) * BESIDE * (kept?.data.size ?? 1));
    draw();
  };
  const keep = button('Keep this motion', () => {
    if (show.isLive() || show.data.time.length < 2) {
      app.fault(new Error('there is no motion to keep: what is shown stands still or goes on by itself'));
      return;
    }
    drop();
    const key = app.motion?.key ?? null;
    // What is held can be saved and drawn even when many others have come.
    if (key !== null) app.engine.call('hold', [key, true]).catch(app.fault);
    kept = { data: show.data, title: document.getElementById('title')!.textContent ?? '', key };
    ghost.keep(kept.data);
    tell();
    set();
  });
  const letGo = button('Let it go', () => {
    drop();
    ghost.keep(null);
    tell();
    draw();
  });
  function drop(): void {
    if (kept?.key !== null && kept) app.engine.call('hold', [kept.key, false]).catch(app.fault);
    kept = null;
  }
  const of = el('div', { hidden: true }, choice('Goes along by', by), choice('Stands', where));
  function tell(): void {
    name.textContent = kept
      ? `${kept.title} is kept (${(kept.data.time[kept.data.time.length - 1] - kept.data.time[0]).toFixed(2)} s): faint in the picture, dashed in the chart.`
      : 'Keep a motion, then make or open another one: both are shown.';
    of.hidden = letGo.hidden = !kept;
  }

  // --- the chart
  const chart = makeChart('The chosen quantity');
  const y = select('Quantity', [], () => draw());
  const x = select('Over', ACROSS, () => draw());
  const note = el('p', { class: 'fault', hidden: true });
  const behind = el('input', { type: 'checkbox', checked: true, autocomplete: 'off' });
  behind.addEventListener('change', () => draw());
  const offered = el('label', { class: 'check' }, behind, 'People behind it');
  const whose = el('p', { class: 'remark' }, 'Mean and one and two standard deviations of children and young people at the nearest of five paces (Schwartz, Rozumalski and Trost 2008).');
  let known: Quantity[] = [];
  let sides = new Map<string, ChartLine['side']>();
  interface Drawn {
    data: Data;
    x: ArrayLike<number>;
    y: ArrayLike<number>;
    // The motion's frame, and where in its time the line begins and ends.
    from: number;
    to: number;
    stride?: Stride;
  }
  let drawn: Drawn[] = [];

  const all = (data: Data): Quantity[] => {
    const found = quantities(data);
    const spots = measure.spots();
    const apart = spots.length === 2 ? distances(data, spots) : null;
    if (apart) found.unshift({ name: DISTANCE, unit: 'm', values: apart });
    return found;
  };
  function line(data: Data, found: Quantity[]): Drawn | string {
    const up = found.find((one) => one.name === y.value);
    if (!up) return `has no '${y.value}'`;
    const { time } = data;
    const [first, last] = [time[0], time[time.length - 1]];
    if (x.value === 'time') return { data, x: Float32Array.from(time, (t) => t - first), y: up.values, from: first, to: last };
    if (x.value === 'share') return { data, x: Float32Array.from(time, (t) => (100 * (t - first)) / (last - first)), y: up.values, from: first, to: last };
    if (x.value === 'stride') {
      const one = stride(data, sides.get(y.value) ?? 'middle');
      if (!one) return 'has no whole stride: no foot strikes the ground twice';
      const clock = view.makeClock(time);
      const shares = Float32Array.from({ length: 101 }, (_, i) => i);
      const values = shares.map((share) => {
        clock.seek(one.from + (share / 100) * (one.to - one.from));
        return valueAt(up.values, clock.frame());
      });
      return { data, x: shares, y: values, from: one.from, to: one.to, stride: one };
    }
    const across = found.find((other) => other.name === x.value);
    return across ? { data, x: across.values, y: up.values, from: first, to: last } : `has no '${x.value}'`;
  }
  const isPath = (): boolean => !ACROSS.some(([value]) => value === x.value);

  // --- people behind it
  let people: { speed: number; found: People | null } | null = null;
  const ask = (speed: number): void => {
    people = { speed, found: null };
    const asked = people;
    app.engine.call<People>('people', [speed]).then((found) => {
      asked.found = found;
      if (asked === people) draw();
    }, app.fault);
  };
  // What people do is told of the leg that strikes; of the pelvis, of the left one.
  function band([one]: Drawn[]): ChartBand | null {
    const { stride: of } = one ?? {};
    const side = sides.get(y.value) ?? 'middle';
    if (!of || of.speed === null || of.speed > FASTEST || !behind.checked || of.side !== (side === 'middle' ? 'left' : side)) return null;
    if (people?.speed !== of.speed) ask(of.speed);
    const plain = y.value.replace(/, (left|right)/, '');
    // OpenSim's pelvis turns the other way round, and some of its knees.
    const theirs = !known.some(({ name }) => name.startsWith('Ankle dorsiflexion'));
    if (theirs && side === 'middle') return null;
    const own = theirs ? plain.replace('Knee angle', 'Knee flexion').replace('Ankle angle', 'Ankle dorsiflexion') : plain;
    const bend = plain.startsWith('Knee angle') ? known.find(({ name }) => name === y.value.replace(/: .*/, ''))?.values : null;
    const sign = bend && !own.endsWith('power') ? Math.sign(Array.from(bend).reduce((sum, angle) => sum + angle, 0)) : 1;
    const { pace, curves } = people?.found ?? {};
    const curve = curves?.find(({ name }) => name === own);
    if (!curve) return null;
    const x = curve.mean.map((_, i) => (100 * i) / (curve.mean.length - 1));
    return { name: `people, ${pace} pace`, x, mean: curve.mean.map((mean) => sign * mean), deviation: curve.deviation };
  }

  function draw(): void {
    if (element.hidden) return;
    const made: [Drawn, string, boolean][] = [];
    const faults: string[] = [];
    for (const [data, title, dashed] of [[show.data, 'now', false], [kept?.data, kept?.title ?? '', true]] as const) {
      if (!data || (dashed && data === show.data)) continue;
      const one = show.isLive() && !dashed ? 'stands still or goes on by itself: it has no curves' : line(data, dashed ? all(data) : known);
      if (typeof one === 'string') faults.push(`${dashed ? title : 'What is shown'} ${one}.`);
      else made.push([one, dashed ? `${title}, kept` : 'shown now', dashed]);
    }
    drawn = made.map(([one]) => one);
    note.hidden = faults.length === 0;
    note.textContent = faults.join(' ');
    const unit = (chosen: string): string => known.find((one) => one.name === chosen)?.unit ?? '';
    const units = { x: x.value === 'time' ? 's' : isPath() ? unit(x.value) : '%', y: unit(y.value) };
    const side = sides.get(y.value) ?? 'middle';
    const shown = band(drawn);
    whose.hidden = !shown;
    offered.hidden = x.value !== 'stride';
    chart.draw(made.map(([one, title, dashed]) => ({ name: title, side, dashed, x: one.x, y: one.y })), units, isPath(), shown);
    mark();
  }

  // Where each line is now: of its own stride, or of its own time.
  function mark(): void {
    if (element.hidden || drawn.length === 0) return;
    chart.mark(drawn.map((one) => {
      const frame: Frame | null = one.data === show.data ? show.clock.frame() : ghost.frame();
      if (!frame) return null;
      if (x.value !== 'stride') return [valueAt(one.x, frame), valueAt(one.y, frame)];
      const share = (100 * (valueAt(one.data.time, frame) - one.from)) / (one.to - one.from);
      if (share < 0 || share > 100) return null;
      const index = Math.min(99, Math.floor(share));
      return [share, valueAt(one.y, { index, next: index + 1, fraction: share - index })];
    }));
  }

  // What there is to choose follows what is shown; what was chosen stays where it can.
  function refresh(): void {
    if (element.hidden) return;
    known = all(show.data);
    sides = new Map(known.map(({ name: of }) => [of, /, (left|right)/.exec(of)?.[1] as ChartLine['side'] ?? 'middle']));
    const fill = (into: HTMLSelectElement, options: [string, string][]): void => {
      const before = into.value;
      into.replaceChildren(...options.map(([value, text]) => el('option', { value }, text)));
      into.value = options.some(([value]) => value === before) ? before : (options[0]?.[0] ?? '');
    };
    const named = known.map((one): [string, string] => [one.name, `${one.name} (${one.unit})`]);
    fill(y, named);
    fill(x, [...ACROSS, ...named]);
    draw();
  }

  // --- in the picture
  const measured = el('p', { class: 'remark', 'aria-live': 'polite' });
  const measure = makeMeasure(app, (picking) => {
    const spots = measure.spots();
    pick.setAttribute('aria-pressed', String(picking));
    forget.hidden = spots.length === 0;
    if (picking) measured.textContent = spots.length === 0 ? 'Click a point of the figure.' : `From ${spots[0].link}: click another point.`;
    else if (spots.length === 2) {
      measured.textContent = `From ${spots[0].link} to ${spots[1].link}: ${now(spots)} m now; over time in the chart.`;
    } else measured.textContent = '';
    refresh();
    if (spots.length === 2 && !picking && y.value !== DISTANCE && known.some((one) => one.name === DISTANCE) && asked) {
      asked = false;
      y.value = DISTANCE;
      draw();
    }
  });
  let asked = false;
  const now = (spots: ReturnType<typeof measure.spots>): string => {
    const [a, b] = spots.map((spot) => placeOf(show.data, spot, show.clock.frame(), new three.Vector3()));
    return a && b ? a.distanceTo(b).toFixed(3) : '–';
  };
  const pick = button('Pick two points', () => {
    asked = true;
    measure.pick();
    pick.setAttribute('aria-pressed', 'true');
    forget.hidden = true;
    measured.textContent = 'Click a point of the figure.';
    refresh();
  }, { 'aria-pressed': 'false' });
  const forget = button('Clear', () => {
    measure.clear();
    forget.hidden = true;
    measured.textContent = '';
    refresh();
  }, { hidden: true });
  const chosen = new Set<string>();
  const trails = el('div', { class: 'checks', role: 'group', 'aria-label': 'Paths of links' });
  const add = select('Path of', [], () => {
    if (add.value) chosen.add(add.value);
    add.value = '';
    paths();
  });
  function paths(): void {
    measure.trails([...chosen]);
    trails.replaceChildren(...[...chosen].map((link) =>
      button(`${link} ×`, () => {
        chosen.delete(link);
        paths();
      }, { 'aria-label': `Take the path of ${link} away` })));
  }

  const element = el(
    'div',
    { class: 'compare' },
    el('h2', {}, 'Beside another motion'),
    name,
    el('div', { class: 'row' }, keep, letGo),
    of,
    el('h2', {}, 'Chart'),
    choice('Quantity', y),
    choice('Over', x),
    offered,
    note,
    chart.element,
    whose,
    el('h2', {}, 'Distance'),
    el('div', { class: 'row' }, pick, forget),
    measured,
    el('h2', {}, 'Paths'),
    choice('Path of', add),
    trails,
  );
  app.tools.add({
    id: 'compare',
    title: 'Compare',
    element,
    shown: refresh,
    left: () => {
      measure.stop();
      pick.setAttribute('aria-pressed', 'false');
    },
  });
  show.onShow(() => {
    add.replaceChildren(el('option', { value: '' }, 'choose a link'), ...show.data.links.map((link) => el('option', { value: link.name }, link.name)));
    refresh();
  });
  show.clock.onChange(mark);
  tell();
  of.hidden = letGo.hidden = true;
}
