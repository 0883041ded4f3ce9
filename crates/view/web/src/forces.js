// The ground's forces: an arrow from the centre of pressure, a dot at it, and the arrow's size in words.

import { CircleGeometry, ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { arrange } from './labels.js';

// Length of the arrow of one body weight, and of the longest arrow, in sizes of the figure.
const BODY_WEIGHT = 0.46;
const LONGEST = 0.7;
// Forces below this share of the weight count as none; without a weight, of the greatest force.
const LEAST = 0.0014;
// Size of a figure whose arrows have the thickness below (m).
const PERSON = 1.75;
const UP = new Vector3(0, 1, 0);
const HEAD = 0.09;

function makeArrow(material) {
  const arrow = new Group();
  const shaft = new Mesh(new CylinderGeometry(0.011, 0.011, 1, 16).translate(0, 0.5, 0), material);
  const head = new Mesh(new ConeGeometry(0.032, HEAD, 24).translate(0, HEAD / 2, 0), material);
  const dot = new Mesh(
    new CircleGeometry(0.03, 32).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ color: 0x111111, depthTest: false, transparent: true, opacity: 0.85 }),
  );
  dot.renderOrder = 2;
  arrow.add(shaft, head);
  return { arrow, shaft, head, dot };
}

// The greatest force at any time (N), at least one that can be divided by.
function greatest(feet) {
  const sizes = feet.map(({ force }) => force.reduce((most, _, i) => (i % 3 ? most : Math.max(most, Math.hypot(...force.subarray(i, i + 3)))), 0));
  return Math.max(1e-9, ...sizes);
}

export function makeForces(data, overlay) {
  const group = new Group();
  const peak = greatest(data.feet);
  const unit = data.size * Math.min(data.weight ? BODY_WEIGHT / data.weight : Infinity, LONGEST / peak);
  const least = ({ weight }) => (LEAST * (weight ?? data.weight ?? peak)) ** 2;
  const thickness = data.size / PERSON;
  const feet = data.feet.map((foot) => {
    // Seen through the leg: an arrow that starts under a foot would otherwise hide in it.
    const material = new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.92 });
    const parts = makeArrow(material);
    parts.arrow.traverse((mesh) => (mesh.renderOrder = 3));
    group.add(parts.arrow, parts.dot);
    const words = document.createElement('span');
    words.className = `force ${foot.side}`;
    overlay.append(words);
    return { foot, material, words, ...parts, tip: new Vector3() };
  });

  const force = new Vector3();
  const cop = new Vector3();
  const point = new Vector3();

  // Force and centre of pressure between two frames; a centre of pressure counts only where there is a force.
  function contact(foot, { index, next, fraction }) {
    const a = point.fromArray(foot.force, 3 * index);
    const loadedA = a.lengthSq() > least(foot);
    force.copy(a).multiplyScalar(1 - fraction);
    const b = point.fromArray(foot.force, 3 * next);
    const loadedB = b.lengthSq() > least(foot);
    force.addScaledVector(b, fraction);
    if (!loadedA && !loadedB) return false;
    const share = loadedA && loadedB ? fraction : loadedA ? 0 : 1;
    cop.fromArray(foot.cop, 3 * index).multiplyScalar(1 - share);
    cop.addScaledVector(point.fromArray(foot.cop, 3 * next), share);
    return force.length() * unit > 0.01 * data.size;
  }

  return {
    group,
    clear: () => feet.forEach(({ words }) => words.remove()),
    paint(theme) {
      feet.forEach(({ foot, material }) => material.color.set(theme.line[foot.side]));
      feet.forEach(({ dot }) => dot.material.color.set(theme.ink));
    },
    pose(frame) {
      for (const entry of feet) {
        const shown = contact(entry.foot, frame);
        entry.arrow.visible = shown;
        entry.dot.visible = shown;
        if (!shown) continue;
        const length = force.length() * unit;
        const head = Math.min(HEAD * thickness, length);
        entry.arrow.position.copy(cop);
        entry.arrow.quaternion.setFromUnitVectors(UP, point.copy(force).normalize());
        entry.shaft.scale.set(thickness, Math.max(1e-4, length - head), thickness);
        entry.head.position.y = length - head;
        entry.head.scale.setScalar(head / HEAD);
        entry.dot.position.copy(cop);
        entry.dot.position.y += 0.003 * data.size;
        entry.dot.scale.setScalar(thickness);
        entry.tip.copy(cop).addScaledVector(force, unit * 1.05);
        const size = force.length();
        entry.size = size;
        const weight = entry.foot.weight ?? data.weight;
        entry.words.textContent = weight ? `${Math.round((100 * size) / weight)} % BW` : `${size.toFixed(0)} N`;
      }
    },
    // Puts the words at the arrows' heads, the greatest force's first; after the camera has moved.
    label(camera, width, height) {
      const seen = [];
      for (const entry of feet) {
        point.copy(entry.tip).project(camera);
        entry.words.hidden = true;
        const shown = group.visible && entry.arrow.visible && point.z < 1 && Math.abs(point.x) < 1 && Math.abs(point.y) < 1.2;
        if (!shown) {
          delete entry.words.dataset.place;
          continue;
        }
        // An arrow that leaves the picture upwards is named where it does.
        const y = Math.max(30, ((1 - point.y) / 2) * height);
        seen.push({ words: entry.words, size: entry.size, x: ((point.x + 1) / 2) * width, y });
      }
      seen.sort((a, b) => b.size - a.size);
      arrange(seen, width, height);
    },
  };
}
