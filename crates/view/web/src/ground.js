// The floor with a scale in metres: a line each 0.5 m, a stronger one each metre, numbers beside the path.

import {
  BufferGeometry,
  CanvasTexture,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  ShadowMaterial,
  SRGBColorSpace,
} from 'three';

const MARGIN = 3;

// Smallest and greatest x and z of the path, in whole metres, with a margin.
function extent(data) {
  const range = (axis) => {
    let low = Infinity;
    let high = -Infinity;
    for (let i = axis; i < data.root.length; i += 3) {
      low = Math.min(low, data.root[i]);
      high = Math.max(high, data.root[i]);
    }
    return [Math.floor(low) - MARGIN, Math.ceil(high) + MARGIN];
  };
  return { x: range(0), z: range(2) };
}

function lines(x, z, keep) {
  const points = [];
  const halves = ([low, high]) => Array.from({ length: 2 * (high - low) + 1 }, (_, i) => 2 * low + i).filter(keep);
  // In pieces of a metre: renderers lose long lines of which an end lies behind the camera.
  const metres = ([low, high]) => Array.from({ length: high - low }, (_, i) => low + i);
  for (const k of halves(x)) for (const from of metres(z)) points.push(k / 2, 0, from, k / 2, 0, from + 1);
  for (const k of halves(z)) for (const from of metres(x)) points.push(from, 0, k / 2, from + 1, 0, k / 2);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ transparent: true }));
}

function label(text) {
  const canvas = document.createElement('canvas');
  canvas.width = 256;
  canvas.height = 96;
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  const mesh = new Mesh(
    new PlaneGeometry(0.4, 0.15).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ map: texture, transparent: true, depthWrite: false }),
  );
  const paint = (theme) => {
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.font = `600 64px ${theme.font}`;
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillStyle = theme.soft;
    pen.fillText(text, canvas.width / 2, canvas.height / 2);
    texture.needsUpdate = true;
  };
  return { mesh, paint };
}

export function makeGround(data) {
  const group = new Group();
  group.position.y = data.ground.height;
  const { x, z } = extent(data);
  const fine = lines(x, z, (half) => half % 2 !== 0);
  const strong = lines(x, z, (half) => half % 2 === 0);
  fine.position.y = 0.001;
  strong.position.y = 0.002;
  group.add(fine, strong);

  const shadow = new Mesh(new PlaneGeometry(400, 400).rotateX(-Math.PI / 2), new ShadowMaterial({ opacity: 0.28 }));
  shadow.receiveShadow = true;
  // Below the lines, which lie too close to it for the depth to tell.
  shadow.material.depthWrite = false;
  shadow.renderOrder = -1;
  // Without a ground there is a scale, but nothing for a shadow to fall on.
  if (data.ground.solid) group.add(shadow);

  // One number a metre on a short path, fewer on a long one.
  const length = z[1] - z[0];
  const every = [1, 2, 5, 10, 50, 100, 1000].find((step) => length / step <= 60) ?? 10000;
  const labels = [];
  for (let at = Math.ceil(z[0] / every) * every; at <= z[1]; at += every) {
    const { mesh, paint } = label(`${at < 0 ? '−' : ''}${Math.abs(at)} m`);
    mesh.position.set(0, 0.004, at);
    group.add(mesh);
    labels.push({ mesh, paint });
  }
  const middle = (data.root[0] + data.root[data.root.length - 3]) / 2;

  return {
    group,
    paint(theme) {
      fine.material.color.set(theme.grid);
      strong.material.color.set(theme.gridStrong);
      shadow.material.opacity = theme.dark ? 0.55 : 0.26;
      labels.forEach(({ paint }) => paint(theme));
    },
    // The numbers lie on the side of the path that the camera is on, and are turned towards it.
    face(camera, target) {
      const quarter = Math.PI / 2;
      const turn = Math.round(Math.atan2(camera.position.x - target.x, camera.position.z - target.z) / quarter) * quarter;
      for (const { mesh } of labels) {
        mesh.position.x = middle + (camera.position.x < target.x ? -0.6 : 0.6);
        mesh.rotation.y = turn;
      }
    },
  };
}
