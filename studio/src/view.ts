// The parts of the pages' viewer, whose bundle runs before this one (`crates/view/web/src/main.js`).

import type * as Three from 'three';

export interface Clock {
  first: number;
  last: number;
  playing: boolean;
  speed: number;
  loop: boolean;
  time(): number;
  load(times: ArrayLike<number>): void;
  onChange(listener: () => void): () => void;
  play(): void;
  pause(): void;
  seek(time: number): void;
  tick(elapsed: number): void;
  frame(): Frame;
}

export interface Frame {
  index: number;
  next: number;
  fraction: number;
}

export interface Line {
  side: 'left' | 'right' | 'middle';
  values: Float32Array;
  spread?: Float32Array;
}

export interface Quantity {
  unit: string;
  lines: Line[];
}

// A skin that has been read; the same one is drawn once.
export interface Body {
  palette: string[];
}

// What a page holds (see the README of `solaris-view`).
export interface Data {
  figure: string;
  weight: number | null;
  origin: number[];
  size: number;
  // `reach`: half of the box in which shadows are thrown, where it is not `half`.
  camera: { half: number[]; aim: Float32Array; reach?: number[] };
  ground: { height: number; solid: boolean; relief?: number[][] };
  links: { name: string; side: string; parts: unknown[] }[];
  // A person's skin, in place of the links' shapes.
  body?: Body;
  time: Float32Array;
  root: Float32Array;
  positions: Float32Array;
  turns: Float32Array;
  com: Float32Array | null;
  // `weight`: of the figure whose foot it is, where there are several.
  feet: { link: string; side: string; weight?: number; force: Float32Array; cop: Float32Array }[];
  joints: { label: string; position: Quantity | null; effort: Quantity | null; power: Quantity | null }[];
  forces: (Quantity & { label: string })[];
}

export interface Theme {
  ink: string;
  soft: string;
  grid: string;
  font: string;
  body: Record<string, string>;
  line: Record<string, string>;
  dark: boolean;
}

export interface Part {
  group: Three.Group;
  paint(theme: Theme): void;
  pose(frame: Frame): void;
}

export interface Stage {
  scene: Three.Scene;
  camera: Three.PerspectiveCamera;
  controls: { target: Three.Vector3; enabled: boolean };
  renderer: Three.WebGLRenderer;
  width: number;
  height: number;
}

export interface Picture {
  stage: Stage;
  body(): Part;
  data(): Data;
  load(data: Data, clock: Clock, how?: { still?: boolean }): void;
  touch(): void;
  paint(theme: Theme): void;
  view(name: string): void;
  show(part: string, visible: boolean): void;
  onTurn(listener: () => void): void;
  setFollow(follow: boolean): void;
  outline(): number[];
  draw(): boolean;
}

export interface Plots {
  // Shows the same curves of another motion in place; says whether it has them.
  load(data: Data): boolean;
  paint(theme: Theme): void;
  destroy(): void;
}

interface Parts {
  makeBody(data: Data): Part;
  makeClock(times: ArrayLike<number>): Clock;
  makeControls(clock: Clock, picture: Picture | null, data: Data): { load(data: Data): void };
  makePicture(holder: HTMLElement, data: Data, clock: Clock): Picture;
  makePlots(joints: HTMLElement, forces: HTMLElement, data: Data, clock: Clock, theme: Theme): Plots;
  mixAt(points: ArrayLike<number>, frame: Frame, out: Three.Vector3): Three.Vector3;
  onThemeChange(listener: () => void): void;
  readBody(json: unknown): Body;
  readData(json: string): Data;
  readTheme(): Theme;
  three: typeof Three;
  // uPlot's own class.
  uPlot: new (options: unknown, data: unknown, root: HTMLElement) => {
    root: HTMLElement;
    over: HTMLElement;
    setData(data: unknown): void;
    setSize(size: { width: number; height: number }): void;
    valToPos(value: number, scale: string): number;
    posToVal(position: number, scale: string): number;
    destroy(): void;
  };
}

declare global {
  var solarisView: Parts;
}

export const view = globalThis.solarisView;
export const three = view.three;
