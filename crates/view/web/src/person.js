// A person's skin: one mesh that moves with the links, its colours from a strip of them.

import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  LinearFilter,
  Matrix4,
  MeshStandardMaterial,
  Quaternion,
  Skeleton,
  SkinnedMesh,
  SRGBColorSpace,
  Vector3,
} from 'three';

// Pixels of a colour's part in the strip; one row is for the left, one for the right.
const PIXELS = 64;
const SHOES = 0;

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
  geometry.setAttribute('position', new BufferAttribute(body.points, 3));
  const places = new Float32Array(2 * count);
  for (let i = 0; i < count; i += 1) {
    // Left is +x.
    places.set([body.colours[i] / 255, body.points[3 * i] > 0 ? 0.25 : 0.75], 2 * i);
  }
  geometry.setAttribute('uv', new BufferAttribute(places, 2));
  geometry.setAttribute('skinIndex', new BufferAttribute(body.links, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(body.shares, 4, true));
  geometry.setIndex(new BufferAttribute(body.triangles, 1));
  geometry.computeVertexNormals();
  return geometry;
}

// `bones`: what moves the skin, one a link.
export function makePerson(body, bones) {
  const strip = makeStrip(body.palette);
  const material = new MeshStandardMaterial({ map: strip.texture, roughness: 0.75, metalness: 0 });
  const mesh = new SkinnedMesh(makeGeometry(body), material);
  const one = new Vector3(1, 1, 1);
  const inverses = bones.map((_, link) => {
    const at = new Vector3().fromArray(body.places, 3 * link);
    const turn = new Quaternion().fromArray(body.turns, 4 * link);
    return new Matrix4().compose(at, turn, one).invert();
  });
  mesh.bind(new Skeleton(bones, inverses), new Matrix4());
  mesh.frustumCulled = false;
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return {
    mesh,
    paint(theme) {
      strip.paint(
        ['left', 'right'].map((side) => body.palette.map((colour, i) => (i === SHOES ? channels(theme.body[side]) : colour))),
      );
    },
  };
}
