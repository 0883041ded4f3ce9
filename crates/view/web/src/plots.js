// The curves: one joint's angle, moment and power, and the forces of the ground. A line follows the time; a click seeks.

import uPlot from 'uplot';

// A true minus sign, and none before zero.
const minus = (text) => (Number(text) === 0 ? text.replace('-', '') : text.replace('-', '−'));

// The range of an axis; a curve that does not move lies in the middle of a range of 2.
function yRange(_, low, high) {
  const around = high - low < 1e-6 ? 1 : 0;
  return uPlot.rangeNum(low - around, high + around, 0.1, true);
}

// One plot in `section`. `quantity`: { unit, lines: [{ side, values }] }.
function makePlot(section, data, clock, quantity, theme) {
  const holder = section.querySelector('.curve');
  const readout = section.querySelector('.readout');
  const font = `11px ${theme.font}`;
  const axis = { stroke: theme.soft, font, grid: { stroke: theme.grid, width: 1 }, ticks: { show: false } };
  const size = () => ({ width: Math.max(160, holder.clientWidth), height: Math.max(80, holder.clientHeight) });
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
        ...quantity.lines.map(({ side }) => ({ stroke: theme.line[side], width: 1.75, pxAlign: 0 })),
      ],
    },
    [data.time, ...quantity.lines.map(({ values }) => values)],
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
  const values = quantity.lines.map(({ side }) => {
    const value = document.createElement('span');
    value.className = side;
    return value;
  });
  const unit = document.createElement('span');
  unit.textContent = quantity.unit;
  readout.replaceChildren(...values, unit);

  const digits = quantity.unit.includes('/kg') ? 2 : 1;
  const update = () => {
    marker.style.transform = `translateX(${plot.valToPos(clock.time(), 'x')}px)`;
    const { index, next, fraction } = clock.frame();
    quantity.lines.forEach((line, i) => {
      const [a, b] = [line.values[index], line.values[next]];
      values[i].textContent = minus((a + (b - a) * fraction).toFixed(digits));
    });
  };
  const observer = new ResizeObserver(() => {
    plot.setSize(size());
    update();
  });
  observer.observe(holder);
  return {
    update,
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
export function makePlots(joints, forces, data, clock, theme) {
  let colours = theme;
  let chosen = 0;
  const live = new Map();
  const put = (section, quantity) => {
    live.get(section)?.destroy();
    live.delete(section);
    section.hidden = !quantity;
    section.querySelector('.curve').setAttribute('aria-label', `${section.querySelector('h2').textContent} over time`);
    if (quantity) live.set(section, makePlot(section, data, clock, quantity, colours));
    live.get(section)?.update();
  };

  const drawn = [];
  if (data.joints.length > 0) {
    const mark = makeChooser(joints, data.joints, (index) => {
      chosen = index;
      showJoint();
    });
    const angle = makeSection(joints, '');
    const moment = makeSection(joints, '');
    const power = makeSection(joints, '');
    const showJoint = () => {
      const joint = data.joints[chosen];
      mark(chosen);
      angle.querySelector('h2').textContent = joint.label;
      moment.querySelector('h2').textContent = `${joint.label} ${joint.effort?.unit.startsWith('N/') ? 'force' : 'moment'}`;
      power.querySelector('h2').textContent = `${joint.label} power`;
      put(angle, joint.position);
      put(moment, joint.effort);
      put(power, joint.power);
    };
    drawn.push(showJoint);
  }
  for (const plot of data.forces) {
    const section = makeSection(forces, plot.label);
    drawn.push(() => put(section, plot));
  }
  forces.hidden = data.forces.length === 0;
  joints.hidden = data.joints.length === 0;
  drawn.forEach((draw) => draw());
  clock.onChange(() => live.forEach((plot) => plot.update()));

  return {
    paint(next) {
      colours = next;
      drawn.forEach((draw) => draw());
    },
  };
}
