// The embedded data: JSON with base64 arrays, decoded once into plain numbers.
// The layout is described in the documentation of the crate (`solaris_view`), next to the code that writes it.

function bytes(text) {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i += 1) out[i] = raw.charCodeAt(i);
  return out.buffer;
}

// An array is 32-bit floats, bytes, pairs of bytes, or 16-bit integers with `value = offset + scale · integer`.
export function numbers(array) {
  if (array.f32 !== undefined) return new Float32Array(bytes(array.f32));
  if (array.u8 !== undefined) return new Uint8Array(bytes(array.u8));
  if (array.u16 !== undefined) return new Uint16Array(bytes(array.u16));
  const integers = new Int16Array(bytes(array.i16));
  const out = new Float32Array(integers.length);
  for (let i = 0; i < out.length; i += 1) out[i] = array.offset + array.scale * integers[i];
  return out;
}

// A curve, and half the width of the band around it where there is one.
const line = ({ side, values, spread }) => ({ side, values: numbers(values), spread: spread && numbers(spread) });

// A skin: all arrays but the palette.
export const readBody = ({ palette, first, ...arrays }) => ({
  palette,
  first,
  ...Object.fromEntries(Object.entries(arrays).map(([name, array]) => [name, numbers(array)])),
});

// What the rest of the page works with. World: x left, y up, z forward (m), from the data's own origin.
export function readData(text) {
  const raw = JSON.parse(text);
  const quantity = (plot) => plot && { unit: plot.unit, lines: plot.lines.map(line) };
  return {
    ...raw,
    time: numbers(raw.time),
    root: numbers(raw.root),
    positions: numbers(raw.positions),
    turns: numbers(raw.turns),
    camera: { half: raw.camera.half, aim: numbers(raw.camera.aim) },
    com: raw.com && numbers(raw.com),
    body: raw.body && readBody(raw.body),
    bodies: (raw.bodies ?? []).map(readBody),
    feet: raw.feet.map((foot) => ({ ...foot, force: numbers(foot.force), cop: numbers(foot.cop) })),
    joints: raw.joints.map((joint) => ({
      label: joint.label,
      position: quantity(joint.position),
      effort: quantity(joint.effort),
      power: quantity(joint.power),
    })),
    forces: raw.forces.map((plot) => ({ label: plot.label, ...quantity(plot) })),
  };
}
