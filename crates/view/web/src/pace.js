// How sharply the picture is drawn: as the screen can show it while nothing moves, and less sharply while something does where drawing is slow.

// Parts of the sharpness that are tried, one after the other.
const PARTS = [1, 0.75, 0.5];
// Pictures of which the mean time is taken; one that takes longer (ms) is slow, and one that takes longer than the second was not drawn at once after the last.
const COUNT = 20;
const [SLOW, APART] = [22, 250];
// What a less sharp picture must take of the time of the sharper one: a screen that shows thirty a second is not helped. Where none is, this many
// times COUNT pictures are drawn before it is tried anew, and twice as many the next time: it may have been another program's doing.
const GAIN = 0.88;
const WAIT = 15;
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
  let [part, rests, sum, count, last] = [0, 0, 0, 0, 0];
  // The part that less sharp ones are compared with, and its time while one of them is tried; how long to wait, and the next time.
  let [base, before, wait, longer] = [0, 0, 0, WAIT];
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
    if (before > 0 && mean > GAIN * before) {
      // A screen shows every picture or every other one: a little less may not help where less still does.
      if (part < PARTS.length - 1) part += 1;
      else [part, before, wait, longer] = [base, 0, longer, 2 * longer];
      return;
    }
    before = 0;
    if (wait > 0) wait -= 1;
    else if (mean > SLOW && part < PARTS.length - 1) [base, part, before] = [part, part + 1, mean];
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
      // Begins to measure anew.
      [last, sum, count] = [-Infinity, 0, 0];
      if (before > 0) part = base;
      [before, wait, longer] = [0, 0, WAIT];
      if (rests !== RESTS || renderer.getPixelRatio() === still) return false;
      set(still);
      return true;
    },
  };
}
