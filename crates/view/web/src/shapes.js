// Geometry of the shapes that a link can have. Lengths in m; every shape is centred on its own origin, along y.

import { BoxGeometry, CylinderGeometry, LatheGeometry, SphereGeometry, Vector2 } from 'three';

// A round limb: two spheres and the cone that touches both. `near` is the radius at −y, `far` the one at +y.
function limb(near, far, length) {
  // The cone touches the spheres where the normal has this slope along y.
  const slope = Math.max(-0.99, Math.min(0.99, (near - far) / length));
  const meet = Math.asin(slope);
  const points = [];
  const arc = (radius, centre, from, to) => {
    for (let i = 0; i <= 12; i += 1) {
      const angle = from + ((to - from) * i) / 12;
      points.push(new Vector2(Math.max(0, radius * Math.cos(angle)), centre + radius * Math.sin(angle)));
    }
  };
  arc(near, -length / 2, -Math.PI / 2, meet);
  arc(far, length / 2, meet, Math.PI / 2);
  return new LatheGeometry(points, 32);
}

const makers = {
  box: ([x, y, z]) => new BoxGeometry(x, y, z),
  cylinder: ([radius, length]) => new CylinderGeometry(radius, radius, length, 32),
  ellipsoid: ([x, y, z]) => new SphereGeometry(1, 40, 28).scale(x, y, z),
  capsule: ([near, far, length]) => limb(near, far, length),
  sphere: ([radius]) => new SphereGeometry(radius, 32, 20),
};

export const geometry = ({ kind, size }) => makers[kind](size);
