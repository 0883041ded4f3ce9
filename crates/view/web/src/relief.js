// Ground that is not level: a strip of it along the way, cut open at its sides down to below its lowest place, with the level
// floor's lines across and along it, its edges, and the floor's numbers below them.

import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  Raycaster,
  Sprite,
  SpriteMaterial,
  Vector3,
} from 'three';
import { SHAPE, makeNumbers, spacing } from './numbers.js';

// In heights of the figure: half of the strip's width beside the path, how far it goes on before and after it, where there is
// fog, and over how much below its lowest place the cut fades.
const HALF = 0.6;
const BEYOND = 10;
const DEEP = 0.6;
// Numbers to each side of the middle, and their height in strong lines' distances.
const NUMBERS = 7;
const TALL = 0.13;
const DOWN = new Vector3(0, -1, 0);

// Least and greatest of one coordinate of the points [x, y, z, …].
function range(points, axis) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = axis; i < points.length; i += 3) [low, high] = [Math.min(low, points[i]), Math.max(high, points[i])];
  return [low, high];
}

// Height of the profile [[z, y], …] at a place.
function heightAt(profile, z) {
  const after = profile.findIndex((point) => point[0] > z);
  if (after === 0) return profile[0][1];
  if (after < 0) return profile.at(-1)[1];
  const [[z0, y0], [z1, y1]] = [profile[after - 1], profile[after]];
  return y0 + ((y1 - y0) * (z - z0)) / (z1 - z0);
}

// Four corners, seen counter-clockwise from outside, as two triangles.
const quad = (a, b, c, d) => [...a, ...b, ...c, ...a, ...c, ...d];

function lines(points) {
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ transparent: true }));
}

function solid(corners, opacities) {
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(corners, 3));
  const material = { roughness: 1, metalness: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
  if (opacities) {
    const colours = opacities.flatMap((opacity) => [1, 1, 1, opacity]);
    geometry.setAttribute('color', new Float32BufferAttribute(colours, 4));
    Object.assign(material, { vertexColors: true, transparent: true });
  }
  geometry.computeVertexNormals();
  const mesh = new Mesh(geometry, new MeshStandardMaterial(material));
  mesh.receiveShadow = true;
  return mesh;
}

export function makeRelief(data) {
  // What the camera has in view may be higher than the figure: it climbs.
  const [feet, head] = range(data.positions.subarray(0, 3 * data.links.length), 1);
  const size = head - feet;
  const { strong: step, parts } = spacing(size);
  const cell = step / parts;
  const origin = { x: data.origin[0], z: data.origin[2] };
  const snap = (at, axis) => Math.round((at + origin[axis]) / cell) * cell - origin[axis];

  // Where it begins and ends, and what lies in between.
  const [nearest, farthest] = range(data.camera.aim, 2);
  const ends = [nearest - BEYOND * size, farthest + BEYOND * size];
  const inside = data.ground.relief.filter(([z]) => z > ends[0] && z < ends[1]);
  const [first, last] = ends.map((z) => [z, heightAt(data.ground.relief, z)]);
  const profile = [first, ...inside, last];
  const [right, left] = range(data.camera.aim, 0);
  const middle = snap((left + right) / 2, 'x');
  const half = Math.ceil((HALF * size + (left - right) / 2) / cell) * cell;
  const sides = [middle - half, middle + half];
  const lowest = Math.min(...profile.map((point) => point[1]));

  const [surface, walls, opacities, edges, fine] = [[], [], [], [], []];
  profile.slice(1).forEach(([z1, y1], i) => {
    const [z0, y0] = profile[i];
    const [a, b] = sides;
    surface.push(...quad([a, y0, z0], [a, y1, z1], [b, y1, z1], [b, y0, z0]));
    if (i > 0) edges.push(a, y0, z0, b, y0, z0);
    // Long lines are drawn in pieces: renderers lose those of which an end lies behind the camera.
    const pieces = Math.max(1, Math.ceil((z1 - z0) / step));
    for (let piece = 0; piece < pieces; piece += 1) {
      const [from, to] = [piece / pieces, (piece + 1) / pieces].map((t) => [y0 + (y1 - y0) * t, z0 + (z1 - z0) * t]);
      for (let x = a; x < b + cell / 2; x += cell) (x === a || x > b - cell / 2 ? edges : fine).push(x, ...from, x, ...to);
    }
    if (z1 === z0) return;
    for (const [p, q, base, opacity] of [[y0, y1, lowest, 1], [lowest, lowest, lowest - DEEP * size, 0]]) {
      walls.push(...quad([a, q, z1], [a, p, z0], [a, base, z0], [a, base, z1]));
      walls.push(...quad([b, p, z0], [b, q, z1], [b, base, z1], [b, base, z0]));
      for (let side = 0; side < 2; side += 1) opacities.push(1, 1, opacity, 1, opacity, opacity);
    }
  });
  const strong = [];
  for (let k = Math.ceil((ends[0] + origin.z) / cell); k * cell - origin.z < ends[1]; k += 1) {
    const z = k * cell - origin.z;
    const y = heightAt(profile, z);
    (k % parts ? fine : strong).push(sides[0], y, z, sides[1], y, z);
  }

  const group = new Group();
  const ground = solid(surface);
  const cut = solid(walls, opacities);
  const marks = { fine: lines(fine), strong: lines(strong), edges: lines(edges) };
  group.add(ground, cut, ...Object.values(marks));

  // Beside the strip, where the ground in front of them hides none of the figure.
  const tall = TALL * step;
  const numbers = makeNumbers(group, step, NUMBERS, (texture, at) => {
    const sprite = new Sprite(new SpriteMaterial({ map: texture, depthWrite: false }));
    const z = at - origin.z;
    sprite.scale.set(SHAPE * tall, tall, 1);
    sprite.position.set(0, Math.min(...[-1, 0, 1].map((k) => heightAt(profile, z + k * tall))) - 0.7 * tall, z);
    return sprite;
  });

  const ray = new Raycaster();
  return {
    group,
    climbs: heightAt(profile, farthest) > heightAt(profile, nearest),
    paint(theme) {
      for (const mesh of [ground, cut]) mesh.material.color.set(theme.grid);
      for (const mark of Object.values(marks)) mark.material.color.set(theme.gridStrong);
      marks.fine.material.opacity = 0.5;
      numbers.paint(theme);
    },
    face(camera, target) {
      const x = camera.position.x < target.x ? sides[0] - 1.7 * tall : sides[1] + 1.7 * tall;
      for (const sprite of numbers.near(target.z + origin.z)) sprite.position.x = x;
    },
    // Height of what is drawn at a place; null beside the strip.
    height(x, z) {
      ray.set(new Vector3(x, 1e3 * size, z), DOWN);
      return ray.intersectObject(ground)[0]?.point.y ?? null;
    },
  };
}
