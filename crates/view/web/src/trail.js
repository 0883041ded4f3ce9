// The path of the centre of mass: a dot a frame up to now, so that their distance shows the speed.

import { Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import { rootAt } from './body.js';

export function makeTrail(data) {
  const group = new Group();
  if (!data.com) return { group, paint() {}, pose() {} };
  const frames = data.time.length;
  const material = new MeshBasicMaterial();
  const dots = new InstancedMesh(new SphereGeometry(0.003 * data.size, 10, 8), material, frames);
  dots.frustumCulled = false;
  const at = new Vector3();
  const matrix = new Matrix4();
  const position = (index, after, fraction) => {
    rootAt(data, index, after, fraction, at);
    for (let i = 0; i < 3; i += 1) {
      const a = data.com[3 * index + i];
      at.setComponent(i, at.getComponent(i) + a + (data.com[3 * after + i] - a) * fraction);
    }
    return at;
  };
  for (let frame = 0; frame < frames; frame += 1) {
    dots.setMatrixAt(frame, matrix.setPosition(position(frame, frame, 0)));
  }
  // The centre of mass itself lies inside of the body: it is drawn over it.
  const now = new Mesh(
    new SphereGeometry(0.014 * data.size, 24, 16),
    new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.9 }),
  );
  now.renderOrder = 4;
  group.add(dots, now);
  return {
    group,
    paint(theme) {
      material.color.set(theme.ink);
      now.material.color.set(theme.ink);
    },
    pose({ index, next, fraction }) {
      dots.count = index + 1;
      now.position.copy(position(index, next, fraction));
    },
  };
}
