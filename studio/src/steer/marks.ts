// What lies on the floor around somebody who is steered: footprints, and a ring where the way ends.

import type { Show } from '../show.ts';
import { three, view } from '../view.ts';

// How many footprints there are, the oldest goes first; corners of one, and of the ring.
const PRINTS = 40;
const CORNERS = 14;
const RING = 40;
// Length and width of a foot, and how far its middle is before the ankle, in heights.
const [LONG, WIDE, AHEAD] = [0.145, 0.055, 0.055];
// Above the lines of the floor (m).
const ABOVE = 0.006;
// A foot that is slower stands, one that is faster has left (m/s).
const [STANDS, LEAVES] = [0.2, 0.8];

export interface Marks {
  // The feet by the poses of a frame; true where one has just landed.
  step(poses: ArrayLike<number>, elapsed: number): boolean;
  // Where the way ends (m); null: nowhere.
  aim(point: [number, number] | null): void;
  clear(): void;
}

export function makeMarks(show: Show, height: number): Marks {
  const { data, picture } = show;
  const group = new three.Group();
  group.position.set(-data.origin[0], data.ground.height + ABOVE, -data.origin[2]);
  const colour = (): string => view.readTheme().soft;
  const flat = (opacity: number): InstanceType<typeof three.MeshBasicMaterial> =>
    new three.MeshBasicMaterial({ color: colour(), transparent: true, opacity, depthWrite: false, side: 2 });

  const places = new Float32Array(9 * CORNERS * PRINTS);
  const prints = new three.Mesh(new three.BufferGeometry(), flat(0.4));
  const corners = new three.BufferAttribute(places, 3);
  prints.geometry.setAttribute('position', corners);
  prints.frustumCulled = false;
  let count = 0;
  const print = (x: number, z: number, sin: number, cos: number): void => {
    const from = 9 * CORNERS * (count++ % PRINTS);
    for (let i = 0; i < CORNERS; i += 1) {
      [[i, 0], [i, 1], [i + 1, 1]].forEach(([corner, size], k) => {
        const angle = (2 * Math.PI * corner) / CORNERS;
        const along = height * (AHEAD + (size * LONG * Math.cos(angle)) / 2);
        const across = (height * size * WIDE * Math.sin(angle)) / 2;
        places.set([x + sin * along + cos * across, 0, z + cos * along - sin * across], from + 9 * i + 3 * k);
      });
    }
    corners.needsUpdate = true;
  };

  const band = Array.from({ length: RING }, (_, i) => {
    const at = (corner: number, radius: number): number[] => {
      const angle = (2 * Math.PI * corner) / RING;
      return [radius * Math.sin(angle), 0, radius * Math.cos(angle)];
    };
    const [a, b, c, d] = [at(i, 0.13), at(i + 1, 0.13), at(i, 0.17), at(i + 1, 0.17)];
    return [a, c, b, b, c, d];
  });
  const ring = new three.Mesh(new three.BufferGeometry(), flat(0.9));
  ring.geometry.setAttribute('position', new three.BufferAttribute(Float32Array.from(band.flat(2)), 3));
  ring.name = 'ring';
  ring.visible = false;
  group.add(prints, ring);
  picture?.stage.scene.add(group);
  view.onThemeChange(() => [prints, ring].forEach(({ material }) => (material as InstanceType<typeof three.MeshBasicMaterial>).color.set(colour())));

  const feet = data.links.flatMap(({ name }, link) => (/^(left|right)_foot$/.test(name) ? [{ link, x: NaN, z: NaN, moves: false }] : []));
  return {
    step(poses, elapsed) {
      let landed = false;
      for (const foot of feet) {
        const [x, , z, qx, qy, qz, qw] = Array.from({ length: 7 }, (_, i) => poses[7 * foot.link + i]);
        const speed = Math.hypot(x - foot.x, z - foot.z) / elapsed;
        [foot.x, foot.z] = [x, z];
        if (speed > LEAVES) foot.moves = true;
        if (speed < STANDS && foot.moves) {
          foot.moves = false;
          landed = true;
          // Which way the foot points on the level.
          const [sin, cos] = [2 * (qx * qz + qw * qy), 1 - 2 * (qx * qx + qy * qy)];
          const length = Math.hypot(sin, cos) || 1;
          print(x, z, sin / length, cos / length);
        }
      }
      return landed;
    },
    aim(point) {
      ring.visible = point !== null;
      if (point) ring.position.set(point[0], 0, point[1]);
      picture?.touch();
    },
    clear() {
      group.removeFromParent();
      [prints, ring].forEach(({ geometry, material }) => {
        geometry.dispose();
        (material as InstanceType<typeof three.MeshBasicMaterial>).dispose();
      });
      picture?.touch();
    },
  };
}
