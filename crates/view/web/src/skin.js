// Skin between two ellipsoids of neighbouring links: a loft from the equator of one to that of the other, which bends
// with both. A trunk of three ellipsoids has waists; with skin it is one body.

import { Bone, BufferGeometry, Float32BufferAttribute, Matrix4, Skeleton, SkinnedMesh, Uint16BufferAttribute } from 'three';

const RINGS = 12;
const SECTORS = 40;
const smooth = (t) => t * t * (3 - 2 * t);

// A link that a skin can hang on.
export const makeLink = () => new Bone();

// Points of the loft in the parent's frame, at the joint's zero; and their share of the child.
function loft(a, b) {
  const reach = b.at.map((x, i) => Math.abs(x - a.at[i]));
  const along = reach.indexOf(Math.max(...reach));
  const [u, v] = [(along + 1) % 3, (along + 2) % 3];
  const points = [];
  const weights = [];
  for (let ring = 0; ring <= RINGS; ring += 1) {
    const t = ring / RINGS;
    const share = smooth(t);
    const mix = (from, to) => from + (to - from) * share;
    for (let sector = 0; sector < SECTORS; sector += 1) {
      const angle = (2 * Math.PI * sector) / SECTORS;
      const point = [0, 0, 0];
      point[along] = a.at[along] + (b.at[along] - a.at[along]) * t;
      point[u] = mix(a.at[u], b.at[u]) + mix(a.size[u], b.size[u]) * Math.cos(angle);
      point[v] = mix(a.at[v], b.at[v]) + mix(a.size[v], b.size[v]) * Math.sin(angle);
      points.push(...point);
      weights.push(1 - share, share, 0, 0);
    }
  }
  return { points, weights, forward: b.at[along] > a.at[along] };
}

function indices(forward) {
  const out = [];
  for (let ring = 0; ring < RINGS; ring += 1) {
    for (let sector = 0; sector < SECTORS; sector += 1) {
      const next = (sector + 1) % SECTORS;
      const [p, q] = [ring * SECTORS + sector, ring * SECTORS + next];
      const [r, s] = [p + SECTORS, q + SECTORS];
      // The outside is seen counter-clockwise.
      if (forward) out.push(p, q, r, q, s, r);
      else out.push(p, r, q, q, r, s);
    }
  }
  return out;
}

// `parent` and `child`: the drawn links; `bones`: what moves them; `offset`: the child's joint in the parent's frame.
export function makeSkin(parent, child, bones, offset, material) {
  const a = parent.parts[0];
  const b = { ...child.parts[0], at: child.parts[0].at.map((x, i) => x + offset[i]) };
  const { points, weights, forward } = loft(a, b);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const pairs = new Uint16Array(weights.length).map((_, i) => (i % 4 === 1 ? 1 : 0));
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(pairs, 4));
  geometry.setIndex(indices(forward));
  geometry.computeVertexNormals();
  const mesh = new SkinnedMesh(geometry, material);
  const inverses = [new Matrix4(), new Matrix4().makeTranslation(...offset).invert()];
  mesh.bind(new Skeleton(bones, inverses), new Matrix4());
  mesh.frustumCulled = false;
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}
