// Numbers that stand in the picture beside lines, and the distance of these lines.

import { CanvasTexture, SRGBColorSpace } from 'three';
import { isSlow } from './pace.js';

// Size of a figure that has a strong line each metre (m).
const PERSON = 1.75;

// The distance of strong lines (m), 1, 2 or 5 times a power of ten, that suits a figure of this size (m), and into how many
// parts finer ones divide it.
export function spacing(size) {
  const length = size / PERSON;
  const power = 10 ** Math.floor(Math.log10(length));
  const steps = [
    { below: 1.5, factor: 1, parts: 2 },
    { below: 3.2, factor: 2, parts: 2 },
    { below: 6, factor: 5, parts: 5 },
    { below: Infinity, factor: 10, parts: 2 },
  ];
  const { factor, parts } = steps.find(({ below }) => length / power < below);
  return { strong: factor * power, parts };
}

// A place in words; `step` is the distance of two of them (m).
export function place(at, step) {
  const [unit, scale] = step >= 0.1 ? ['m', 1] : step >= 0.001 ? ['cm', 100] : ['mm', 1000];
  const digits = Math.max(0, Math.ceil(-Math.log10(step * scale) - 1e-9));
  const text = Math.abs(at * scale).toFixed(digits);
  return `${at < 0 && Number(text) !== 0 ? '−' : ''}${text} ${unit}`;
}

// Width of the written text in heights of its texture.
export const SHAPE = 10 / 3;

function written(text) {
  const canvas = document.createElement('canvas');
  canvas.width = 320;
  canvas.height = canvas.width / SHAPE;
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  // Numbers lie on the floor; a processor takes as long for their sharpness as for all lines.
  texture.anisotropy = isSlow() ? 1 : 8;
  const paint = (theme) => {
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.font = `600 64px ${theme.font}`;
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillStyle = theme.soft;
    pen.fillText(text, canvas.width / 2, canvas.height / 2, canvas.width);
    texture.needsUpdate = true;
  };
  return { texture, paint };
}

// Numbers at multiples of `step` along an axis, of which those near a place are shown. `make(texture, at)` gives the object
// that shows one; `beside`: how many to each side of the place.
export function makeNumbers(group, step, beside, make) {
  const entries = new Map();
  let theme = null;
  function entry(k) {
    if (!entries.has(k)) {
      const { texture, paint } = written(place(k * step, step));
      const object = make(texture, k * step);
      if (theme) paint(theme);
      entries.set(k, { texture, paint, object });
      group.add(object);
    }
    return entries.get(k).object;
  }
  return {
    paint(next) {
      theme = next;
      entries.forEach(({ paint }) => paint(theme));
    },
    // The objects that are shown around the place `at`.
    near(at) {
      const middle = Math.round(at / step);
      for (const [k, { texture, object }] of entries) {
        object.visible = Math.abs(k - middle) <= beside;
        // A long path does not keep all its numbers.
        if (Math.abs(k - middle) <= 3 * beside) continue;
        group.remove(object);
        texture.dispose();
        object.material.dispose();
        entries.delete(k);
      }
      return Array.from({ length: 2 * beside + 1 }, (_, i) => {
        const object = entry(middle - beside + i);
        object.visible = true;
        return object;
      });
    },
  };
}
