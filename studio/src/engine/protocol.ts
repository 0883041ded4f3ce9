// What page and worker say to each other.

// A call of one of the worker's functions.
export interface Call {
  id: number;
  name: string;
  args: unknown[];
}

export interface Fault {
  message: string;
  // The engine itself broke, and is begun anew.
  broken?: boolean;
}

export type Reply =
  | { id: number; value: unknown }
  | { id: number; fault: Fault }
  // How far it has come (0 to 1; null: not known), in which words, and what there is so far.
  | { id: number; share: number | null; words: string | null; soFar?: string };

// What begins a worker: the engine, compiled.
export interface Begin {
  module: WebAssembly.Module;
}

// A motion that is shown: `key` is the engine's own.
export interface ShownMotion {
  key: number;
  title: string;
  duration: number;
  // What a page holds of it.
  data: string;
}

export interface Who {
  height: number;
  mass: number;
  age?: number;
  // What hands carry (kg), and by how much a leg is shorter (m).
  load?: { left?: number; right?: number };
  shorterLeg?: { left?: number; right?: number };
  // The hand that holds a cane.
  cane?: 'left' | 'right';
}

export interface Row {
  label: string;
  value: string;
  unit: string;
  note: string;
}

export interface Dof {
  name: string;
  // Index in `v`.
  index: number;
  // Index in `q`; null where it has none of its own.
  coordinate: number | null;
  turns: boolean;
  lower: number | null;
  upper: number | null;
}

export interface JointOutline {
  name: string;
  // The link that it carries.
  link: string;
  dofs: Dof[];
}

// A still pose to begin a picture with, and who it is.
export interface PosedFigure {
  data: string;
  q: number[];
  name: string;
  mass: number;
  links: { name: string; parent: number | null; mass: number }[];
  joints: JointOutline[];
  findings: string[];
}

// What a figure is made of, in the frames of its links (m, kg).
export interface Anatomy {
  links: {
    name: string;
    mass: number;
    com: number[];
    // Of a homogeneous body with the same inertia: half axes, and where they point.
    ellipsoid: { half: number[]; along: number[][] } | null;
    // Axes that its joint turns about, on the link that they are fixed to.
    axes: { on: number; at: number[]; along: number[] }[];
    points: { name: string; at: number[] }[];
  }[];
  soles: { link: number; from: number[]; to: number[] }[];
}

// What people do over a stride, from one strike of a foot to its next, evenly.
export interface People {
  pace: string;
  curves: { name: string; unit: string; mean: number[]; deviation: number[] }[];
}

export interface TextFault {
  from: number;
  to: number;
  line: number;
  column: number;
  message: string;
  instead: string | null;
}

// What a scene says.
export interface SceneOutline {
  name: string;
  figure: string;
  duration: number;
  rate: number;
  method: string;
  ground: boolean;
  walk: boolean;
  walked: number;
  joints: JointOutline[];
  // One for each degree of freedom: what drives it, and what the text says of it by its own name.
  drives: { steps: { drive: string; until: Record<string, unknown> | null }[]; written: string | null }[];
  q: number[];
  v: number[];
  notes: string[];
}
