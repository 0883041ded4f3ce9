// What is asked of the walker: by keys that are held, by buttons that stay down, by the stick of a gamepad.

// Parts of the full speed to the left and forward, and of a turn to the left; each from −1 to 1.
export interface Wanted {
  left: number;
  forward: number;
  turn: number;
  fast: boolean;
}

export type Way = 'forward' | 'back' | 'turnLeft' | 'turnRight' | 'asideLeft' | 'asideRight';

// By the places of the keys: W A S D is a cross on every keyboard.
const KEYS: Record<string, Way> = {
  ArrowUp: 'forward', KeyW: 'forward', ArrowDown: 'back', KeyS: 'back',
  ArrowLeft: 'turnLeft', KeyA: 'turnLeft', ArrowRight: 'turnRight', KeyD: 'turnRight',
  KeyQ: 'asideLeft', KeyE: 'asideRight',
};
// A stick that is left alone is not quite in its middle.
const DEAD = 0.18;
const FIELD = 'input:not([type="checkbox"]), select, textarea, [contenteditable], [role="tab"]';

export interface Input {
  // Buttons that stay down.
  readonly down: Set<Way>;
  wanted(): Wanted;
  // Lets go of everything.
  release(): void;
}

// `takes`: whether keys that are pressed at an element are ours; `onKey`: something was pressed; `stop`: the space bar was.
export function makeInput(takes: (at: Element | null) => boolean, onKey: () => void, stop: () => void): Input {
  const held = new Set<string>();
  const down = new Set<Way>();
  let shift = false;
  const release = (): void => {
    held.clear();
    down.clear();
  };
  // Before anybody else hears it: the arrows would go through the frames of a motion.
  document.addEventListener(
    'keydown',
    (event) => {
      shift = event.shiftKey;
      const at = event.target instanceof Element ? event.target : null;
      if (event.ctrlKey || event.metaKey || event.altKey || !takes(at)) return;
      const typed = at?.closest(FIELD);
      // In a row of tabs the arrows go from one to the next.
      if (typed && !(typed.matches('[role="tab"]') && event.code.startsWith('Key'))) return;
      const space = event.code === 'Space' && !at?.closest('button, summary, input, a');
      if (!KEYS[event.code] && !space) return;
      event.preventDefault();
      event.stopPropagation();
      if (space) {
        release();
        stop();
      } else {
        if (!event.repeat) onKey();
        held.add(event.code);
      }
    },
    true,
  );
  document.addEventListener('keyup', (event) => {
    shift = event.shiftKey;
    held.delete(event.code);
  });
  // Nobody hears a key come up in another window.
  window.addEventListener('blur', () => held.clear());
  document.addEventListener('visibilitychange', () => held.clear());

  return {
    down,
    release,
    wanted() {
      const ways = new Set([...down, ...[...held].map((code) => KEYS[code])]);
      const both = (one: Way, other: Way): number => Number(ways.has(one)) - Number(ways.has(other));
      const stick = pad();
      const mix = (key: number, axis: number): number => Math.max(-1, Math.min(1, key + axis));
      return {
        left: mix(both('asideLeft', 'asideRight'), stick.left),
        forward: mix(both('forward', 'back'), stick.forward),
        turn: mix(both('turnLeft', 'turnRight'), stick.turn),
        fast: shift || stick.fast,
      };
    },
  };
}

// The left stick goes and turns, the right one goes aside; a trigger is Shift.
function pad(): Wanted {
  const found = navigator.getGamepads?.().find((one) => one?.connected);
  const axis = (i: number): number => {
    const value = found?.axes[i] ?? 0;
    return Math.abs(value) < DEAD ? 0 : -value;
  };
  return { turn: axis(0), forward: axis(1), left: axis(2), fast: Boolean(found?.buttons[7]?.pressed) };
}
