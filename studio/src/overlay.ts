// What can be drawn beside the shapes of a figure: axes of joints, centres of mass, inertia, soles, markers. All of it hangs on the figure's links
// and goes with them.

import type * as Three from 'three';
import type { App } from './app.ts';
import type { Anatomy } from './engine/protocol.ts';
import { three, view } from './view.ts';

export const KINDS = ['axes', 'masses', 'inertia', 'soles', 'markers'] as const;
export type Kind = (typeof KINDS)[number];

// In sizes of the figure.
const [AXIS, DOT] = [0.055, 0.006];

export interface Overlay {
  show(kind: Kind, visible: boolean): void;
}

// `ours`: whether what is shown is of the files that are open.
export function makeOverlay(app: App, ours: () => boolean): Overlay {
  const wanted = new Set<Kind>();
  let drawn: Three.Object3D[] = [];
  let asked = 0;

  const take = (): void => {
    for (const object of drawn) {
      object.removeFromParent();
      object.traverse((part) => {
        const { geometry, material } = part as Partial<Three.Mesh>;
        geometry?.dispose();
        (material as Three.Material | undefined)?.dispose();
      });
    }
    drawn = [];
  };

  // Of whom the figure that is shown is: of a motion, of files, or of a figure that is posed.
  async function find(): Promise<Anatomy | null> {
    const names = app.show.data.links.map(({ name }) => name).join('\n');
    const { motion } = app;
    const tries: [string, unknown[]][] = [['poseAnatomy', []]];
    if (motion) tries.unshift(['anatomy', [motion.key]]);
    if (ours()) tries.unshift(['openedAnatomy', []]);
    for (const [name, args] of tries) {
      const engine = name === 'anatomy' ? motion!.engine : app.engine;
      const found = await engine.call<Anatomy>(name, args).catch(() => null);
      if (found && found.links.map((link) => link.name).join('\n') === names) return found;
    }
    return null;
  }

  async function draw(): Promise<void> {
    take();
    app.show.picture?.touch();
    const { picture } = app.show;
    const mine = ++asked;
    if (!picture || wanted.size === 0) return;
    const anatomy = await find();
    if (mine !== asked || !anatomy) return;
    take();
    // The body's first children are its links, in their order.
    const bones = picture.body().group.children;
    const size = app.show.data.size;
    const colours = view.readTheme();
    const put = (kind: Kind, link: number, object: Three.Object3D): void => {
      if (!wanted.has(kind) || !bones[link]) return;
      object.traverse((part) => {
        // Never in the way of who points at the figure, and never behind its skin.
        part.raycast = () => {};
        part.renderOrder = 5;
      });
      object.name = kind;
      drawn.push(object);
      bones[link].add(object);
    };
    const paint = (colour: string, opacity = 0.9): { color: string; depthTest: boolean; transparent: boolean; opacity: number } => ({
      color: colour, depthTest: false, transparent: true, opacity,
    });
    const line = (points: number[][], colour: string): Three.Line =>
      new three.Line(new three.BufferGeometry().setFromPoints(points.map((point) => new three.Vector3(...point))), new three.LineBasicMaterial(paint(colour)));
    const dot = (at: number[], radius: number, colour: string): Three.Mesh => {
      const mesh = new three.Mesh(new three.SphereGeometry(radius, 16, 10), new three.MeshBasicMaterial(paint(colour)));
      mesh.position.fromArray(at);
      return mesh;
    };
    const most = Math.max(1e-9, ...anatomy.links.map(({ mass }) => mass));
    anatomy.links.forEach(({ mass, com, ellipsoid, axes, points }, link) => {
      for (const { on, at, along } of axes) {
        const ends = [-1, 1].map((sign) => at.map((x, i) => x + sign * AXIS * size * along[i]));
        put('axes', on, line(ends, colours.line.right));
        put('axes', on, dot(at, 0.5 * DOT * size, colours.line.right));
      }
      if (mass > 0) put('masses', link, dot(com, DOT * size * (0.6 + 1.4 * Math.cbrt(mass / most)), colours.ink));
      if (ellipsoid) put('inertia', link, egg(com, ellipsoid, colours.line.left));
      for (const { at } of points) put('markers', link, dot(at, DOT * size, colours.line.left));
    });
    for (const { link, from, to } of anatomy.soles) put('soles', link, line([from, to], colours.ink));
    picture.touch();
  }

  app.show.onShow(() => void draw());
  view.onThemeChange(() => void draw());
  return {
    show(kind, visible) {
      if (visible) wanted.add(kind);
      else wanted.delete(kind);
      void draw();
    },
  };
}

function egg(com: number[], { half, along }: { half: number[]; along: number[][] }, colour: string): Three.Mesh {
  const mesh = new three.Mesh(
    new three.SphereGeometry(1, 24, 16),
    new three.MeshBasicMaterial({ color: colour, depthTest: false, transparent: true, opacity: 0.28, depthWrite: false }),
  );
  const turn = new three.Matrix4().makeBasis(...(along.map((axis) => new three.Vector3(...axis)) as [Three.Vector3, Three.Vector3, Three.Vector3]));
  mesh.position.fromArray(com);
  mesh.quaternion.setFromRotationMatrix(turn);
  mesh.scale.fromArray(half);
  return mesh;
}
