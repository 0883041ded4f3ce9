// The floor with a scale: strong lines and finer ones between them, as far apart as suits the figure (1 m and 0.5 m for a
// person), with numbers beside the path. It goes on for ever: a patch of it moves along with the camera.

import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  ShadowMaterial,
} from 'three';
import { SHAPE, makeNumbers, spacing } from './numbers.js';
import { SUN } from './stage.js';

// How far a shadow goes beyond what throws it, in sizes of the figure.
const SOFT = 0.12;
// Strong lines to each side of the middle: further out there is fog.
const LINES = 24;
// Cells in a piece of a line. In pieces: renderers lose long lines of which an end lies behind the camera.
const PIECE = 3;
// Numbers to each side of the middle.
const NUMBERS = 7;

// `count` cells to each side of the middle, each divided into `parts`, within a circle; the lines at whole cells are left out of the fine ones.
function lines(cell, count, parts) {
  const points = [];
  for (let k = -count * parts; k <= count * parts; k += 1) {
    if (parts > 1 && k % parts === 0) continue;
    const at = (k / parts) * cell;
    for (let piece = -count; piece < count; piece += PIECE) {
      const nearest = Math.min(Math.abs(piece), Math.abs(piece + PIECE));
      if (Math.hypot(k / parts, nearest) > count) continue;
      const [from, to] = [piece * cell, (piece + PIECE) * cell];
      points.push(at, 0, from, at, 0, to, from, 0, at, to, 0, at);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ transparent: true }));
}

// Whether the figure goes further along x than along z.
function goesAcross({ aim, half }) {
  const range = (axis) => {
    const values = aim.filter((_, i) => i % 3 === axis);
    return values.reduce((a, b) => Math.max(a, b), -Infinity) - values.reduce((a, b) => Math.min(a, b), Infinity);
  };
  return range(0) + 2 * half[0] > 1.5 * (range(2) + 2 * half[2]);
}

export function makeGround(first) {
  let data = first;
  const group = new Group();
  group.position.y = data.ground.height;
  const { strong: step, parts } = spacing(data.size);
  const fine = lines(step, LINES, parts);
  const strong = lines(step, LINES, 1);
  fine.position.y = 0.001 * step;
  strong.position.y = 0.002 * step;
  const grid = new Group();
  grid.add(fine, strong);

  const shadow = new Mesh(new PlaneGeometry(1, 1).rotateX(-Math.PI / 2), new ShadowMaterial({ opacity: 0.28 }));
  shadow.receiveShadow = true;
  // Below the lines, which lie too close to it for the depth to tell.
  shadow.material.depthWrite = false;
  shadow.renderOrder = -1;
  // Without a ground there is a scale, but nothing for a shadow to fall on.
  if (data.ground.solid) group.add(shadow);
  group.add(grid);
  // Only where a shadow can fall: what is drawn elsewhere would be seen through, and costs as much.
  function shade(aim) {
    const [wide, tall, deep] = data.camera.reach ?? data.camera.half;
    const soft = SOFT * data.size;
    const above = aim.y - group.position.y;
    const [low, high] = [Math.max(0, above - tall), Math.max(0, above + tall)];
    const falls = (axis) => [-low, -high].map((height) => (height * SUN[axis]) / SUN[1]);
    const [x, z] = [falls(0), falls(2)];
    const span = (values, half) => [Math.min(...values) - half - soft, Math.max(...values) + half + soft];
    const [[left, right], [back, front]] = [span(x, wide), span(z, deep)];
    shadow.scale.set(right - left, 1, front - back);
    shadow.position.set(aim.x + (left + right) / 2, 0, aim.z + (back + front) / 2);
  }

  // The numbers run along the axis `along` and stand beside the figure on the axis `beside`.
  const across = goesAcross(data.camera);
  const [along, beside] = across ? ['x', 'z'] : ['z', 'x'];
  const origin = { x: data.origin[0], z: data.origin[2] };
  const sign = new PlaneGeometry(0.15 * SHAPE * step, 0.15 * step).rotateX(-Math.PI / 2);
  const numbers = makeNumbers(group, step, NUMBERS, (texture, at) => {
    const mesh = new Mesh(sign, new MeshBasicMaterial({ map: texture, transparent: true, depthWrite: false }));
    mesh.position.y = 0.004 * step;
    mesh.position[along] = at - origin[along];
    return mesh;
  });
  // The nearest line to `at`, in the picture's coordinates.
  const snap = (at, axis, cell) => Math.round((at + origin[axis]) / cell) * cell - origin[axis];

  return {
    group,
    paint(theme) {
      fine.material.color.set(theme.grid);
      strong.material.color.set(theme.gridStrong);
      shadow.material.opacity = theme.dark ? 0.55 : 0.26;
      numbers.paint(theme);
    },
    height: () => group.position.y,
    // Serves another motion, where it is on the same floor: says whether it does.
    load(next) {
      const alike = (one) => JSON.stringify([one.ground, one.origin, spacing(one.size)]);
      const same = alike(next) === alike(data) && goesAcross(next.camera) === across;
      if (same) data = next;
      return same;
    },
    // The patch is where the camera looks; the numbers lie on the side of the path that the camera is on, turned towards it. The figure is at `aim`.
    face(camera, target, aim) {
      shade(aim);
      grid.position.set(snap(target.x, 'x', step), 0, snap(target.z, 'z', step));
      const quarter = Math.PI / 2;
      const turn = Math.round(Math.atan2(camera.position.x - target.x, camera.position.z - target.z) / quarter) * quarter;
      const away = data.camera.half[beside === 'x' ? 0 : 2] + 0.17 * data.size;
      const line = snap(target[beside], beside, step / parts) + (camera.position[beside] < target[beside] ? -away : away);
      for (const mesh of numbers.near(target[along] + origin[along])) {
        mesh.position[beside] = line;
        mesh.rotation.y = turn;
      }
    },
  };
}
