// A scale of heights beside a figure that the camera follows up or down, where nothing else would show how fast it goes.

import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Sprite, SpriteMaterial, Vector3 } from 'three';
import { SHAPE, makeNumbers, spacing } from './numbers.js';

// Marks to each side of the middle.
const MARKS = 5;
// The camera follows up or down where its aim does so by more than this, in sizes of the figure.
const FOLLOWED = 0.5;
const ACROSS = new Vector3(1, 0, 0);

// An upright line with a mark at each part of a step, longer ones at whole steps.
function ladder(step, parts, width) {
  const points = [0, -MARKS * step, 0, 0, MARKS * step, 0];
  for (let k = -MARKS * parts; k <= MARKS * parts; k += 1) {
    points.push(0, (k / parts) * step, 0, k % parts === 0 ? width : width / 2, (k / parts) * step, 0);
  }
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial());
}

export function makeHeights(data) {
  const group = new Group();
  const { aim, half } = data.camera;
  let [low, high] = [Infinity, -Infinity];
  for (let i = 1; i < aim.length; i += 3) [low, high] = [Math.min(low, aim[i]), Math.max(high, aim[i])];
  if (data.ground.relief || high - low <= FOLLOWED * data.size) return { group, paint() {}, face() {} };

  const { strong: step, parts } = spacing(data.size);
  const width = 0.07 * data.size;
  const lines = ladder(step, parts, width);
  group.add(lines);
  const origin = data.origin[1];
  const tall = 0.09 * data.size;
  const numbers = makeNumbers(group, step, MARKS, (texture, at) => {
    const sprite = new Sprite(new SpriteMaterial({ map: texture, depthWrite: false }));
    sprite.scale.set(SHAPE * tall, tall, 1);
    sprite.position.y = at - origin;
    return sprite;
  });
  const right = new Vector3();
  const beside = 1.1 * Math.hypot(half[0], half[2]);
  const room = width + 1.1 * SHAPE * tall;

  return {
    group,
    paint(theme) {
      lines.material.color.set(theme.gridStrong);
      numbers.paint(theme);
    },
    // Stands to the right of the figure, or where the picture ends.
    face(camera, target) {
      const edge = camera.position.distanceTo(target) * Math.tan((camera.fov * Math.PI) / 360) * camera.aspect;
      const away = Math.max(0, Math.min(beside, edge - room));
      right.setFromMatrixColumn(camera.matrixWorld, 0);
      right.y = 0;
      right.normalize();
      lines.position.copy(target).addScaledVector(right, away);
      lines.position.y = Math.round((target.y + origin) / step) * step - origin;
      lines.quaternion.setFromUnitVectors(ACROSS, right);
      for (const sprite of numbers.near(target.y + origin)) {
        const { y } = sprite.position;
        sprite.position.copy(lines.position).addScaledVector(right, width + (SHAPE * tall) / 2.4);
        sprite.position.y = y;
      }
    },
  };
}
