// A small chart of lines, each with an x of its own (what a plane of two quantities needs), and what they are at the pointer.

import './chart.css';
import { el, number } from './dom.ts';

export interface ChartLine {
  name: string;
  // Of its colour.
  side: 'left' | 'right' | 'middle';
  dashed?: boolean;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

// What lies behind the lines: a mean, and how far others are from it.
export interface ChartBand {
  name: string;
  x: ArrayLike<number>;
  mean: ArrayLike<number>;
  deviation: ArrayLike<number>;
}

export interface Chart {
  element: HTMLElement;
  // `path`: x goes to and fro, as in a plane of two quantities.
  draw(lines: ChartLine[], units: { x: string; y: string }, path: boolean, band?: ChartBand | null): void;
  // Marks a place of each line.
  mark(places: ([number, number] | null)[]): void;
}

type Place = [number, number];
const HEIGHT = 200;
// How many deviations a band is wide to each side, the widest first.
const WIDTHS = [2, 1];
// Room for the numbers beside the lines (px).
const [LEFT, RIGHT, TOP, BOTTOM] = [44, 10, 8, 20];

const svg = (tag: string, attributes: Record<string, string | number>): SVGElement => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
};
const digits = (value: number): string => number(value, Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : 3);

// Round numbers between two, some `count` of them.
function ticks(low: number, high: number, count: number): number[] {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const found: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) found.push(Number((k * step).toPrecision(12)));
  return found;
}

// A value of a line whose places go up, at a place.
function between(x: ArrayLike<number>, y: ArrayLike<number>, at: number): number {
  let i = 1;
  while (i < x.length - 1 && x[i] < at) i += 1;
  return y[i - 1] + (y[i] - y[i - 1]) * Math.min(1, Math.max(0, (at - x[i - 1]) / (x[i] - x[i - 1])));
}

export function makeChart(label: string): Chart {
  const picture = svg('svg', { role: 'img', 'aria-label': label, class: 'chart' });
  const readout = el('div', { class: 'chart-values' });
  const element = el('div', { class: 'charted' }, picture, readout);
  let drawn: { lines: ChartLine[]; units: { x: string; y: string }; path: boolean; band: ChartBand | null } | null = null;
  let marks: SVGElement[] = [];
  let [under, last]: [boolean, (Place | null)[]] = [false, []];
  let [px, py]: ((value: number) => number)[] = [Number, Number];

  const say = (places: (Place | null)[]): void => {
    if (!drawn) return;
    const { lines, units, band } = drawn;
    readout.replaceChildren(...lines.map(({ name, side, dashed }, i) => {
      const at = places[i];
      return el('span', { class: `line ${side}${dashed ? ' dashed' : ''}` }, `${name}${at ? `: ${digits(at[1])} ${units.y} at ${digits(at[0])} ${units.x}` : ''}`);
    }));
    if (!band) return;
    const at = places.find(Boolean);
    const value = (of: ArrayLike<number>): string => digits(between(band.x, of, at![0]));
    readout.append(el('span', { class: 'line band' }, `${band.name}${at ? `: ${value(band.mean)} ± ${value(band.deviation)} ${units.y}` : ''}`));
  };
  // The point of a line that is nearest to a place of the chart.
  const nearest = ({ x, y }: ChartLine, left: number, top: number): Place | null => {
    let [best, least] = [-1, Infinity];
    for (let i = 0; i < x.length; i += 1) {
      const far = Math.hypot(px(x[i]) - left, drawn!.path ? py(y[i]) - top : 0);
      if (far < least) [best, least] = [i, far];
    }
    return best < 0 ? null : [x[best], y[best]];
  };

  function draw(): void {
    picture.replaceChildren();
    readout.replaceChildren();
    const width = element.clientWidth;
    if (!drawn || width === 0 || drawn.lines.length === 0) return;
    const { lines, path, band } = drawn;
    const range = (which: 'x' | 'y'): Place => {
      let [low, high] = [Infinity, -Infinity];
      for (const line of lines) {
        for (let i = 0; i < line[which].length; i += 1) {
          low = Math.min(low, line[which][i]);
          high = Math.max(high, line[which][i]);
        }
      }
      if (which === 'y') {
        for (let i = 0; i < (band?.x.length ?? 0); i += 1) {
          low = Math.min(low, band!.mean[i] - WIDTHS[0] * band!.deviation[i]);
          high = Math.max(high, band!.mean[i] + WIDTHS[0] * band!.deviation[i]);
        }
      }
      if (high - low < 1e-9) return [low - 1, high + 1];
      const edge = which === 'x' && !path ? 0 : 0.06 * (high - low);
      return [low - edge, high + edge];
    };
    const [[x0, x1], [y0, y1]] = [range('x'), range('y')];
    px = (x) => LEFT + ((x - x0) / (x1 - x0)) * (width - LEFT - RIGHT);
    py = (y) => HEIGHT - BOTTOM - ((y - y0) / (y1 - y0)) * (HEIGHT - TOP - BOTTOM);
    picture.setAttribute('viewBox', `0 0 ${width} ${HEIGHT}`);
    picture.setAttribute('height', String(HEIGHT));
    const write = (x: number, y: number, anchor: string, value: number): SVGElement => {
      const text = svg('text', { x, y, 'text-anchor': anchor });
      text.textContent = String(value).replace('-', '−');
      return text;
    };
    if (band) {
      const edge = (way: number): string[] => Array.from(band.x, (at, i) => `${px(at).toFixed(1)} ${py(band.mean[i] + way * band.deviation[i]).toFixed(1)}`);
      for (const wide of WIDTHS) picture.append(svg('path', { class: 'band', d: `M${[...edge(wide), ...edge(-wide).reverse()].join('L')}Z` }));
      picture.append(svg('path', { class: 'mean', d: `M${edge(0).join('L')}` }));
    }
    for (const tick of ticks(x0, x1, width / 70)) {
      picture.append(svg('path', { class: 'grid', d: `M${px(tick)} ${TOP}V${HEIGHT - BOTTOM}` }), write(px(tick), HEIGHT - 5, 'middle', tick));
    }
    for (const tick of ticks(y0, y1, 5)) {
      picture.append(svg('path', { class: 'grid', d: `M${LEFT} ${py(tick)}H${width - RIGHT}` }), write(LEFT - 6, py(tick) + 4, 'end', tick));
    }
    for (const { x, y, side, dashed } of lines) {
      const d = Array.from(x, (at, i) => `${i === 0 ? 'M' : 'L'}${px(at).toFixed(1)} ${py(y[i]).toFixed(1)}`).join('');
      picture.append(svg('path', { class: `line ${side}${dashed ? ' dashed' : ''}`, d }));
    }
    marks = lines.map(({ side }) => svg('circle', { class: `mark ${side}`, r: 4, visibility: 'hidden' }));
    picture.append(...marks);
    put();
  }
  function put(): void {
    marks.forEach((mark, i) => {
      const at = last[i];
      mark.setAttribute('visibility', at ? 'visible' : 'hidden');
      if (!at) return;
      mark.setAttribute('cx', px(at[0]).toFixed(1));
      mark.setAttribute('cy', py(at[1]).toFixed(1));
    });
    if (!under && element.clientWidth > 0) say(last);
  }

  picture.addEventListener('pointermove', (event) => {
    if (!drawn) return;
    under = true;
    const box = picture.getBoundingClientRect();
    say(drawn.lines.map((line) => nearest(line, event.clientX - box.left, event.clientY - box.top)));
  });
  picture.addEventListener('pointerleave', () => (under = false));
  new ResizeObserver(draw).observe(element);
  return {
    element,
    draw(lines, units, path, band = null) {
      [drawn, last] = [{ lines, units, path, band }, []];
      draw();
    },
    mark(places) {
      last = places;
      put();
    },
  };
}
