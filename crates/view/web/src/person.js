// A person's skin: one mesh that moves with the links, its colours from a strip of them. Its points are moved here and not by the graphics, which
// would do it once for the picture and once more for the shadow: half of a frame's time where a processor draws.

import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DynamicDrawUsage,
  LinearFilter,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  Skeleton,
  Sphere,
  SRGBColorSpace,
  Vector3,
} from 'three';

// Pixels of a colour's part in the strip; one row is for the left, one for the right.
const PIXELS = 64;
const SHOES = 0;
// Cells of the height within which a shadow does not tell one point from another.
const CELLS = 64;

function makeStrip(palette) {
  const width = PIXELS * palette.length;
  const pixels = new Uint8Array(4 * 2 * width);
  const texture = new DataTexture(pixels, width, 2);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  return {
    texture,
    paint(rows) {
      rows.forEach((colours, row) => {
        for (let i = 0; i < width; i += 1) {
          pixels.set([...colours[Math.floor(i / PIXELS)], 255], 4 * (row * width + i));
        }
      });
      texture.needsUpdate = true;
    },
  };
}

// Red, green and blue of `#rrggbb`.
const channels = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));

function makeGeometry(body) {
  const count = body.points.length / 3;
  const geometry = new BufferGeometry();
  // Its points are moved in place, and others may show the same person.
  geometry.setAttribute('position', new BufferAttribute(body.points.slice(), 3));
  const places = new Float32Array(2 * count);
  for (let i = 0; i < count; i += 1) {
    // Left is +x.
    places.set([body.colours[i] / 255, body.points[3 * i] > 0 ? 0.25 : 0.75], 2 * i);
  }
  geometry.setAttribute('uv', new BufferAttribute(places, 2));
  // For whoever asks which link a place of the skin belongs to.
  geometry.setAttribute('skinIndex', new BufferAttribute(body.links, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(body.shares, 4, true));
  geometry.setIndex(new BufferAttribute(body.triangles, 1));
  geometry.computeVertexNormals();
  return geometry;
}

// Triangles between few of the points, for the shadow: one of those of a link that are near each other stands for all.
function rough({ points, links, triangles }) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 1; i < points.length; i += 3) [low, high] = [Math.min(low, points[i]), Math.max(high, points[i])];
  const cell = (high - low) / CELLS;
  const chosen = new Map();
  const all = Uint16Array.from({ length: points.length / 3 }, (_, i) => {
    const key = [links[4 * i], ...[0, 1, 2].map((axis) => Math.round(points[3 * i + axis] / cell))].join();
    if (!chosen.has(key)) chosen.set(key, i);
    return chosen.get(key);
  });
  const kept = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [all[triangles[i]], all[triangles[i + 1]], all[triangles[i + 2]]];
    if (a !== b && b !== c && c !== a) kept.push(a, b, c);
  }
  return Uint16Array.from(kept);
}

// What throws the shadow, with the points of the skin: drawn for the shadow only.
function makeShade(body, points) {
  const geometry = new BufferGeometry().setAttribute('position', points).setIndex(new BufferAttribute(rough(body), 1));
  const shade = new Mesh(geometry, new MeshBasicMaterial());
  shade.castShadow = true;
  shade.frustumCulled = false;
  shade.onBeforeShadow = () => geometry.setDrawRange(0, Infinity);
  shade.onBeforeRender = () => geometry.setDrawRange(0, 0);
  shade.raycast = () => {};
  return shade;
}

// What moves each point, one after the other: `from[i]` to `from[i + 1]` are those of point i. Most points have one or two.
function influences({ links, shares }) {
  const [from, which, part] = [[0], [], []];
  for (let i = 0; i < shares.length; i += 1) {
    if (shares[i] > 0) {
      which.push(links[i]);
      part.push(shares[i] / 255);
    }
    if (i % 4 === 3) from.push(which.length);
  }
  return { from: Uint32Array.from(from), which: Uint16Array.from(which), part: Float32Array.from(part) };
}

// Writes points and normals as the matrices (column-major, sixteen numbers each) of the links move them.
function move({ from, which, part }, matrices, still, moved) {
  for (let i = 0; i + 1 < from.length; i += 1) {
    const [x, y, z] = [3 * i, 3 * i + 1, 3 * i + 2];
    const [px, py, pz] = [still.points[x], still.points[y], still.points[z]];
    const [nx, ny, nz] = [still.normals[x], still.normals[y], still.normals[z]];
    let [a, b, c, d, e, f] = [0, 0, 0, 0, 0, 0];
    for (let k = from[i]; k < from[i + 1]; k += 1) {
      const [m, share] = [16 * which[k], part[k]];
      a += share * (matrices[m] * px + matrices[m + 4] * py + matrices[m + 8] * pz + matrices[m + 12]);
      b += share * (matrices[m + 1] * px + matrices[m + 5] * py + matrices[m + 9] * pz + matrices[m + 13]);
      c += share * (matrices[m + 2] * px + matrices[m + 6] * py + matrices[m + 10] * pz + matrices[m + 14]);
      d += share * (matrices[m] * nx + matrices[m + 4] * ny + matrices[m + 8] * nz);
      e += share * (matrices[m + 1] * nx + matrices[m + 5] * ny + matrices[m + 9] * nz);
      f += share * (matrices[m + 2] * nx + matrices[m + 6] * ny + matrices[m + 10] * nz);
    }
    [moved.points[x], moved.points[y], moved.points[z]] = [a, b, c];
    [moved.normals[x], moved.normals[y], moved.normals[z]] = [d, e, f];
  }
}

// `bones`: what moves the skin, one a link.
export function makePerson(body, bones) {
  const strip = makeStrip(body.palette);
  const material = new MeshLambertMaterial({ map: strip.texture });
  const geometry = makeGeometry(body);
  const mesh = new Mesh(geometry, material);
  const { position, normal } = geometry.attributes;
  [position, normal].forEach((attribute) => attribute.setUsage(DynamicDrawUsage));
  const still = { points: position.array.slice(), normals: normal.array.slice() };
  const moved = { points: position.array, normals: normal.array };
  // Nobody looks for where it ends.
  geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
  const one = new Vector3(1, 1, 1);
  const inverses = bones.map((_, link) => {
    const at = new Vector3().fromArray(body.places, 3 * link);
    const turn = new Quaternion().fromArray(body.turns, 4 * link);
    return new Matrix4().compose(at, turn, one).invert();
  });
  mesh.skeleton = new Skeleton(bones, inverses);
  const acting = influences(body);
  const matrices = new Float32Array(16 * bones.length);
  const matrix = new Matrix4();
  mesh.frustumCulled = false;
  mesh.receiveShadow = true;
  mesh.add(makeShade(body, position));
  return {
    mesh,
    // To where the links are.
    pose() {
      bones.forEach((bone, link) => {
        bone.updateMatrix();
        matrix.multiplyMatrices(bone.matrix, inverses[link]).toArray(matrices, 16 * link);
      });
      move(acting, matrices, still, moved);
      position.needsUpdate = true;
      normal.needsUpdate = true;
    },
    paint(theme) {
      strip.paint(
        ['left', 'right'].map((side) => body.palette.map((colour, i) => (i === SHOES ? channels(theme.body[side]) : colour))),
      );
    },
  };
}
