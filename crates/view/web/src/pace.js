// How sharply the picture is drawn: as the screen can show it while nothing moves, and less sharply while something does where drawing is slow.

// Parts of the sharpness that are tried, one after the other.
const PARTS = [1, 0.75, 0.5];
// Pictures of which the mean time is taken; one that takes longer (ms) is slow, and one that takes longer than the second was not drawn at once after the last.
const COUNT = 20;
const [SLOW, APART] = [22, 250];
// What a less sharp picture must take of the time of the sharper one: a screen that shows thirty a second is not helped.
const GAIN = 0.88;
// How many times nothing is to be drawn until nothing moves.
const RESTS = 8;
const PROCESSOR = /swiftshader|llvmpipe|softpipe|software|basic render/i;

// Whether a processor draws: smoothing edges costs it as much as all the rest.
let slow = null;
export const isSlow = () => (slow ??= drawsByProcessor());
function drawsByProcessor() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = gl?.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER) ?? '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return PROCESSOR.test(name);
}

// `slow`: edges are not smoothed, and a picture that rests is drawn twice as large instead.
export function makePace(renderer, slow) {
  const screen = Math.min(2, devicePixelRatio);
  const [still, moves] = slow ? [2, Math.min(1, screen)] : [screen, screen];
  let [part, least, rests, sum, count, before, last] = [0, PARTS.length - 1, 0, 0, 0, 0, 0];
  const set = (ratio) => {
    if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
  };
  set(still);

  function measure(now) {
    const took = now - last;
    last = now;
    if (took > APART) return;
    sum += took;
    count += 1;
    if (count < COUNT) return;
    const mean = sum / count;
    [sum, count] = [0, 0];
    if (before > 0 && mean > GAIN * before) [part, least] = [part - 1, part - 1];
    before = 0;
    if (mean > SLOW && part < least) [part, before] = [part + 1, mean];
  }

  return {
    // Something has moved and is about to be drawn.
    move(now) {
      measure(now);
      rests = 0;
      set(moves * PARTS[part]);
    },
    // Nothing has moved; says whether it is to be drawn once more, sharply.
    rest() {
      rests += 1;
      // Begins to measure anew: what did not help may have been another program's doing.
      [last, sum, count, before, least] = [-Infinity, 0, 0, 0, PARTS.length - 1];
      if (rests !== RESTS || renderer.getPixelRatio() === still) return false;
      set(still);
      return true;
    },
  };
}
