// The curves: one joint's angle, moment and power, and the forces of the ground. A line follows the time; a click seeks.

import uPlot from 'uplot';

// A true minus sign, and none before zero.
const minus = (text) => (Number(text) === 0 ? text.replace('-', '') : text.replace('-', '−'));

// The range of an axis; a curve that does not move lies in the middle of a range of 2.
function yRange(_, low, high) {
  const around = high - low < 1e-6 ? 1 : 0;
  return uPlot.rangeNum(low - around, high + around, 0.1, true);
}

// Digits behind the point.
const DIGITS = { m: 3, 'N m/kg': 2, 'N/kg': 2, 'W/kg': 2 };

// What fills the band around the line of a side; on a dark page as little would not be seen.
const pale = (theme, side) => `color-mix(in srgb, ${theme.line[side]} ${theme.dark ? 26 : 18}%, transparent)`;

// The lower and the upper edge of the band around a line.
const edges = ({ values, spread }) => [-1, 1].map((sign) => values.map((value, i) => value + sign * spread[i]));

// Whether a plot of one can show the other: lines and bands of the same sides in the same unit.
const alike = (a, b) =>
  a.unit === b.unit &&
  a.lines.length === b.lines.length &&
  a.lines.every(({ side, spread }, i) => side === b.lines[i].side && Boolean(spread) === Boolean(b.lines[i].spread));

// One plot in `section`. `first`: { unit, lines: [{ side, values, spread }] }, over `time`.
function makePlot(section, time, clock, first, theme) {
  let quantity = first;
  const holder = section.querySelector('.curve');
  const readout = section.querySelector('.readout');
  const font = `11px ${theme.font}`;
  const axis = { stroke: theme.soft, font, grid: { stroke: theme.grid, width: 1 }, ticks: { show: false } };
  const size = () => ({ width: Math.max(160, holder.clientWidth), height: Math.max(80, holder.clientHeight) });
  // Edges come before lines: bands lie behind all of these, and the axis holds them.
  const banded = quantity.lines.filter(({ spread }) => spread);
  const columns = (times, { lines }) => [times, ...lines.filter(({ spread }) => spread).flatMap(edges), ...lines.map(({ values }) => values)];
  section.classList.toggle('banded', banded.length > 0);
  const edge = { width: 0, points: { show: false }, pxAlign: 0 };
  const plot = new uPlot(
    {
      ...size(),
      legend: { show: false },
      padding: [6, 16, 0, 0],
      cursor: { drag: { x: false, y: false }, y: false, points: { show: false } },
      scales: { x: { time: false }, y: { range: yRange } },
      axes: [
        { ...axis, size: 25, gap: 5, values: (_, ticks) => ticks.map((tick) => `${tick} s`), space: 56 },
        { ...axis, size: 46, gap: 4, space: 18, values: (_, ticks) => ticks.map((tick) => minus(String(tick))) },
      ],
      series: [
        {},
        ...banded.flatMap(() => [edge, edge]),
        ...quantity.lines.map(({ side }) => ({ stroke: theme.line[side], width: 1.75, pxAlign: 0 })),
      ],
      bands: banded.map(({ side }, i) => ({ series: [2 * i + 2, 2 * i + 1], fill: pale(theme, side) })),
    },
    columns(time, quantity),
    holder,
  );
  const marker = document.createElement('div');
  marker.className = 'now';
  plot.over.append(marker);

  const seek = (event) => clock.seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  plot.over.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    if (event.pointerType === 'mouse') plot.over.setPointerCapture(event.pointerId);
    seek(event);
  });
  plot.over.addEventListener('pointermove', (event) => {
    if (plot.over.hasPointerCapture(event.pointerId) && event.buttons === 1) seek(event);
  });
  const span = (className, ...children) => {
    const element = document.createElement('span');
    element.className = className;
    element.append(...children);
    return element;
  };
  const values = quantity.lines.map(() => span('value'));
  const arounds = quantity.lines.map(({ spread }) => spread && span('around'));
  const sides = quantity.lines.map(({ side }, i) => span(side, values[i], arounds[i] ?? ''));
  readout.replaceChildren(...sides, span('', quantity.unit));

  const digits = DIGITS[quantity.unit] ?? 1;
  const update = () => {
    marker.style.transform = `translateX(${plot.valToPos(clock.time(), 'x')}px)`;
    const { index, next, fraction } = clock.frame();
    quantity.lines.forEach((line, i) => {
      const at = (numbers) => numbers[index] + (numbers[next] - numbers[index]) * fraction;
      values[i].textContent = minus(at(line.values).toFixed(digits));
      if (!line.spread) return;
      const spread = at(line.spread);
      arounds[i].textContent = spread > 0 ? ` ± ${spread.toFixed(digits)}` : '';
    });
  };
  const observer = new ResizeObserver(() => {
    plot.setSize(size());
    update();
  });
  observer.observe(holder);
  return {
    update,
    // Shows another quantity in place, where it is like the one before; says whether it does.
    load(times, next) {
      if (!alike(quantity, next)) return false;
      quantity = next;
      plot.setData(columns(times, quantity));
      update();
      return true;
    },
    destroy() {
      observer.disconnect();
      plot.destroy();
    },
  };
}

function makeSection(root, title) {
  const section = document.createElement('section');
  section.className = 'plot';
  section.innerHTML = '<header><h2></h2><span class="readout"></span></header><div class="curve" role="img"></div>';
  section.querySelector('h2').textContent = title;
  root.append(section);
  return section;
}

// The buttons of the first three joints and a list of the others.
function makeChooser(root, joints, choose) {
  const bar = document.createElement('div');
  bar.className = 'chooser';
  bar.setAttribute('role', 'group');
  bar.setAttribute('aria-label', 'Joint');
  const buttons = joints.slice(0, 3).map((joint, i) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = joint.label;
    button.addEventListener('click', () => choose(i));
    return button;
  });
  const list = document.createElement('select');
  list.setAttribute('aria-label', 'Other joints');
  list.append(new Option('More', ''), ...joints.slice(3).map((joint, i) => new Option(joint.label, i + 3)));
  list.addEventListener('change', () => list.value !== '' && choose(Number(list.value)));
  list.hidden = joints.length <= 3;
  bar.append(...buttons, list);
  root.append(bar);
  return (chosen) => {
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(i === chosen)));
    list.value = chosen >= 3 ? String(chosen) : '';
  };
}

// `joints` and `forces`: where the curves of a joint and those of the ground's forces go.
export function makePlots(joints, forces, first, clock, theme) {
  let [data, colours] = [first, theme];
  let chosen = 0;
  const live = new Map();
  // `loads`: the same curves of another motion.
  const put = (section, quantity, loads) => {
    if (loads && quantity && live.get(section)?.load(data.time, quantity)) return;
    live.get(section)?.destroy();
    live.delete(section);
    section.hidden = !quantity;
    section.querySelector('.curve').setAttribute('aria-label', `${section.querySelector('h2').textContent} over time`);
    if (quantity) live.set(section, makePlot(section, data.time, clock, quantity, colours));
    live.get(section)?.update();
  };

  const drawn = [];
  if (data.joints.length > 0) {
    const mark = makeChooser(joints, data.joints, (index) => {
      chosen = index;
      showJoint(false);
    });
    const angle = makeSection(joints, '');
    const moment = makeSection(joints, '');
    const power = makeSection(joints, '');
    const caption = document.createElement('p');
    caption.className = 'caption';
    caption.textContent = `areas: ${data.bands}`;
    power.before(caption);
    const showJoint = (loads) => {
      const joint = data.joints[chosen];
      mark(chosen);
      angle.querySelector('h2').textContent = joint.label;
      moment.querySelector('h2').textContent = `${joint.label} ${joint.effort?.unit.startsWith('N/') ? 'force' : 'moment'}`;
      power.querySelector('h2').textContent = `${joint.label} power`;
      put(angle, joint.position, loads);
      put(moment, joint.effort, loads);
      put(power, joint.power, loads);
      const shown = [joint.position, joint.effort].flatMap((plot) => plot?.lines ?? []);
      caption.hidden = !data.bands || !shown.some(({ spread }) => spread);
    };
    drawn.push(showJoint);
  }
  data.forces.forEach(({ label }, i) => {
    const section = makeSection(forces, label);
    drawn.push((loads) => put(section, data.forces[i], loads));
  });
  forces.hidden = data.forces.length === 0;
  joints.hidden = data.joints.length === 0;
  drawn.forEach((draw) => draw(false));
  const forget = clock.onChange(() => live.forEach((plot) => plot.update()));

  return {
    // Takes all curves away.
    destroy() {
      forget();
      live.forEach((plot) => plot.destroy());
      [joints, forces].forEach((root) => root.replaceChildren());
    },
    paint(next) {
      colours = next;
      drawn.forEach((draw) => draw(false));
    },
    // The same joints and forces of another motion, in place; says whether it has them.
    load(next) {
      const labels = (one) => [one.bands, ...[...one.joints, ...one.forces].map(({ label }) => label)].join('\n');
      if (next.joints.length !== data.joints.length || labels(next) !== labels(data)) return false;
      data = next;
      drawn.forEach((draw) => draw(true));
      return true;
    },
  };
}
