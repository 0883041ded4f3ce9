// A curve drawn by its points: dragged, added by a double click, deleted by a key. What is between them is the engine's.

import type { Engine } from '../engine/client.ts';
import { button, el, latest, number } from '../ui/dom.ts';
import { asKind, CURVES, writeCurve, type Curve } from './curves.ts';
import { choose, typed } from './inputs.ts';
import { DEGREE, plain } from './ron.ts';

// Of the drawing, in its own units: as wide as a panel is in pixels.
const [WIDTH, LEFT, RIGHT, TOP, BOTTOM, BELOW, END] = [300, 34, 8, 14, 128, 146, 196];
const SAMPLES = 120;
// The least time between two points (s).
const APART = 0.01;

interface Sampled {
  fault?: string;
  times: number[];
  position: number[];
  velocity: number[];
  turns: { time: number; position: number; reverses: boolean }[];
}

interface Options {
  engine: Engine;
  label: string;
  // Of what is drawn, `°` for angles; `turns`: the curve's values are angles (rad).
  unit: string;
  turns: boolean;
  curve: Curve;
  // When a point was let go, added, deleted.
  change(curve: Curve): void;
  // What is wrong with the curve; null: nothing.
  fault(message: string | null): void;
}

export function svg(tag: string, attributes: Record<string, string | number>, ...children: (Node | string)[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

export function makeCurveEditor({ engine, label, unit, turns, curve: first, change, fault }: Options): HTMLElement {
  let curve = first;
  const scale = turns ? DEGREE : 1;
  const step = turns ? 1 : 0.05;
  let chosen = 0;
  // The axes stand still while a point is dragged.
  let [last, low, high] = [1, 0, 1];
  let sampled: Sampled | null = null;

  const lines = svg('g', {});
  const points = svg('g', {});
  const drawing = svg('svg', { viewBox: `0 0 ${WIDTH} ${END + 4}`, class: 'curve-drawing', role: 'group', 'aria-label': `${label}: points of the curve` }, lines, points) as SVGSVGElement;
  const [time, value] = [typed('Time', 's', (next) => move(chosen, next, curve.keys[chosen][1])), typed('Value', unit, (next) => move(chosen, curve.keys[chosen][0], next * scale))];
  const kinds = choose('Curve', Object.entries(CURVES).map(([name, { label: words }]) => [name, words]), curve.kind, (kind) => put(asKind(curve, kind)));
  const add = button('Add a point', () => insert());
  const remove = button('Delete it', () => cut());
  const element = el('div', { class: 'curve-editor' }, kinds.element, drawing as unknown as HTMLElement, el('div', { class: 'row' }, time.element, value.element), el('div', { class: 'row' }, add, remove));

  const x = (at: number): number => LEFT + ((WIDTH - LEFT - RIGHT) * at) / last;
  const y = (at: number): number => BOTTOM - ((BOTTOM - TOP) * (at / scale - low)) / (high - low);

  const sample = latest(async () => {
    const answer = await engine.call<Sampled>('curve', [writeCurve(curve, turns), SAMPLES]).catch(() => null);
    if (!answer) return;
    sampled = answer.fault ? null : answer;
    fault(answer.fault ?? null);
    draw();
  });

  function axes(): void {
    last = Math.max(0.1, curve.keys.at(-1)![0]) * 1.04;
    const all = [...curve.keys.map(([, at]) => at / scale), ...(sampled?.position ?? []).map((at) => at / scale)];
    [low, high] = [Math.min(...all), Math.max(...all)];
    const air = Math.max(0.12 * (high - low), turns ? 2 : 0.02);
    [low, high] = [low - air, high + air];
  }

  function draw(): void {
    const text = (at: string, place: [number, number], of: Record<string, string> = {}): SVGElement => svg('text', { x: place[0], y: place[1], ...of }, at);
    const parts: SVGElement[] = [
      svg('path', { class: 'axis', d: `M${LEFT} ${TOP}V${BOTTOM}H${WIDTH - RIGHT}M${LEFT} ${BELOW}V${END}` }),
      text(`${number(high, 1)}${turns ? '°' : ''}`, [LEFT - 3, TOP + 4], { 'text-anchor': 'end' }),
      text(`${number(low, 1)}${turns ? '°' : ''}`, [LEFT - 3, BOTTOM], { 'text-anchor': 'end' }),
      text(`${number(curve.keys.at(-1)![0])} s`, [WIDTH - RIGHT, BOTTOM + 11], { 'text-anchor': 'end' }),
    ];
    if (sampled) {
      const path = (ys: number[]): string => ys.map((at, i) => `${i ? 'L' : 'M'}${x(sampled!.times[i]).toFixed(1)} ${at.toFixed(1)}`).join('');
      const most = Math.max(...sampled.velocity.map(Math.abs), 1e-9);
      const middle = (BELOW + END) / 2;
      const rise = (END - BELOW) / 2;
      parts.push(
        svg('path', { class: 'line', d: path(sampled.position.map(y)) }),
        svg('path', { class: 'axis', d: `M${LEFT} ${middle}H${WIDTH - RIGHT}` }),
        svg('path', { class: 'line velocity', d: path(sampled.velocity.map((at) => middle - (rise * at) / most)) }),
        text(`±${number(most / scale, most / scale < 10 ? 2 : 0)} ${unit}/s`, [LEFT + 3, BELOW + 3]),
      );
      for (const { time: at, position, reverses } of sampled.turns) {
        if (!reverses) continue;
        parts.push(
          svg('path', { class: 'turn', d: `M${x(at)} ${TOP}V${END}` }),
          svg('circle', { class: 'turn', cx: x(at), cy: y(position), r: 3 }),
          text(`${number(at)} s`, [Math.min(x(at), WIDTH - 30), TOP - 4], { class: 'turn-label', 'text-anchor': 'middle' }),
        );
      }
    }
    lines.replaceChildren(...parts);
    const was = focused;
    points.replaceChildren(...curve.keys.map((_, i) => circle(i)));
    focused = was;
    fields();
  }

  function fields(): void {
    chosen = Math.min(chosen, curve.keys.length - 1);
    time.value = curve.keys[chosen][0];
    value.value = curve.keys[chosen][1] / scale;
    remove.disabled = !CURVES[curve.kind].keyed || curve.keys.length < 3;
    add.disabled = !CURVES[curve.kind].keyed;
  }

  function circle(i: number): SVGElement {
    const [at, height] = curve.keys[i];
    return svg('circle', {
      class: i === chosen ? 'point chosen' : 'point',
      cx: x(at),
      cy: y(height),
      r: 6,
      tabindex: 0,
      role: 'button',
      'data-point': i,
      'aria-label': `point ${i + 1} of ${curve.keys.length}: ${number(at)} s, ${number(height / scale)} ${unit}`,
    });
  }

  // Another curve, said to whoever listens; the axes follow.
  function put(next: Curve): void {
    curve = next;
    kinds.value = curve.kind;
    axes();
    draw();
    change(curve);
    void sample().then(() => {
      axes();
      draw();
      refocus();
    });
    refocus();
  }

  let focused = false;
  function refocus(): void {
    if (focused) points.querySelector<SVGElement>(`[data-point="${chosen}"]`)?.focus();
  }

  // Within its neighbours; the first stays where it begins.
  function within(i: number, at: number): number {
    if (i === 0) return curve.keys[0][0];
    const next = CURVES[curve.kind].keyed ? curve.keys[i + 1]?.[0] : undefined;
    return Math.min((next ?? Infinity) - APART, Math.max(curve.keys[i - 1][0] + APART, at));
  }
  const moved = (i: number, at: number, height: number): Curve => ({ ...curve, keys: curve.keys.map((key, k) => (k === i ? [within(i, at), height] : key)) });
  function move(i: number, at: number, height: number): void {
    if (Number.isFinite(at) && Number.isFinite(height)) put(moved(i, at, height));
  }
  function insert(at?: number, height?: number): void {
    if (!CURVES[curve.kind].keyed) return;
    const end = curve.keys.at(-1)!;
    const next = curve.keys[chosen + 1];
    const when = at ?? (next ? (curve.keys[chosen][0] + next[0]) / 2 : end[0] + 0.5);
    const before = curve.keys.filter(([time]) => time < when).length;
    if (before === 0 || curve.keys.some(([time]) => Math.abs(time - when) < APART)) return;
    const nearest = sampled?.times.findIndex((time) => time >= when) ?? -1;
    const there = height ?? (nearest >= 0 ? sampled!.position[nearest] : end[1]);
    chosen = before;
    const key: [number, number] = [Number(plain(when, 2)), there];
    put({ ...curve, keys: [...curve.keys.slice(0, before), key, ...curve.keys.slice(before)] });
  }
  function cut(): void {
    if (remove.disabled) return;
    const keys = curve.keys.filter((_, i) => i !== chosen);
    chosen = Math.max(0, chosen - 1);
    put({ ...curve, keys: keys.map(([at, height], i) => [i === 0 ? 0 : at, height]) });
  }

  const which = (event: Event): number => Number((event.target as Element).getAttribute('data-point') ?? -1);
  const place = (event: MouseEvent): [number, number] => {
    const box = drawing.getBoundingClientRect();
    const unitsPer = WIDTH / box.width;
    const at = (((event.clientX - box.left) * unitsPer - LEFT) / (WIDTH - LEFT - RIGHT)) * last;
    const height = low + ((BOTTOM - (event.clientY - box.top) * unitsPer) / (BOTTOM - TOP)) * (high - low);
    const snap = turns ? 1 : 100;
    return [Math.round(at * 100) / 100, (Math.round(height * snap) / snap) * scale];
  };
  let dragged = -1;
  points.addEventListener('pointerdown', (event) => {
    if (which(event) < 0) return;
    [chosen, dragged] = [which(event), which(event)];
    drawing.setPointerCapture((event as PointerEvent).pointerId);
    event.preventDefault();
    focused = true;
    draw();
    refocus();
  });
  drawing.addEventListener('pointermove', (event) => {
    if (dragged < 0) return;
    curve = moved(dragged, ...place(event));
    draw();
    void sample();
  });
  const release = (): void => {
    if (dragged < 0) return;
    dragged = -1;
    put(curve);
  };
  drawing.addEventListener('pointerup', release);
  drawing.addEventListener('pointercancel', release);
  drawing.addEventListener('dblclick', (event) => {
    if (which(event) < 0) insert(...place(event));
  });
  points.addEventListener('focusin', (event) => {
    focused = true;
    if (which(event) < 0 || which(event) === chosen) return;
    chosen = which(event);
    points.querySelectorAll('.point').forEach((point, i) => point.classList.toggle('chosen', i === chosen));
    fields();
  });
  points.addEventListener('focusout', (event) => (focused = points.contains((event as FocusEvent).relatedTarget as Node | null)));
  points.addEventListener('keydown', (event) => {
    const { key, shiftKey } = event as KeyboardEvent;
    const by = { ArrowLeft: [-0.05, 0], ArrowRight: [0.05, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[key];
    if (!by && !['Delete', 'Backspace', 'Insert', '+'].includes(key)) return;
    event.preventDefault();
    event.stopPropagation();
    const [at, height] = curve.keys[chosen];
    const fast = shiftKey ? 10 : 1;
    if (by) move(chosen, at + fast * by[0], height + fast * by[1] * scale);
    else if (key === 'Insert' || key === '+') insert();
    else cut();
  });

  axes();
  draw();
  void sample().then(() => {
    axes();
    draw();
  });
  return element;
}
