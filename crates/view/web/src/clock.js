// The time that is shown, and whether it runs.

// `times`: the frames' times (s), ascending, at least one.
export function makeClock(times) {
  const listeners = [];
  let [first, last, now] = [0, 0, 0];
  const clock = {
    // Other frames, from their beginning.
    load(others) {
      times = others;
      [first, last] = [times[0], times[times.length - 1]];
      Object.assign(clock, { first, last });
      clock.seek(first);
    },
    playing: false,
    speed: 1,
    loop: true,
    time: () => now,
    // Gives what takes the listener away again.
    onChange(listener) {
      listeners.push(listener);
      return () => listeners.splice(listeners.indexOf(listener), 1);
    },
    play() {
      if (now >= last) now = first;
      clock.playing = last > first;
      changed();
    },
    pause() {
      clock.playing = false;
      changed();
    },
    toggle: () => (clock.playing ? clock.pause() : clock.play()),
    seek(time) {
      if (Number.isFinite(time)) now = Math.min(last, Math.max(first, time));
      changed();
    },
    // To the next frame (+1) or the one before (−1), and stop there.
    step(by) {
      clock.playing = false;
      const { index, fraction } = clock.frame();
      const from = by < 0 && fraction > 0 ? index + 1 : index;
      clock.seek(times[Math.min(times.length - 1, Math.max(0, from + by))]);
    },
    // Moves on by `elapsed` seconds of the wall.
    tick(elapsed) {
      if (!clock.playing) return;
      now += elapsed * clock.speed;
      if (now > last) {
        now = clock.loop ? first : last;
        clock.playing = clock.loop;
      }
      changed();
    },
    // The frame at or before now, and how far now is on its way to the next (0 to 1).
    frame() {
      let low = 0;
      let high = times.length - 1;
      while (low < high) {
        const middle = (low + high + 1) >> 1;
        if (times[middle] <= now) low = middle;
        else high = middle - 1;
      }
      const next = Math.min(low + 1, times.length - 1);
      const fraction = next > low ? (now - times[low]) / (times[next] - times[low]) : 0;
      return { index: low, next, fraction };
    },
  };
  function changed() {
    listeners.forEach((listener) => listener());
  }
  clock.load(times);
  return clock;
}
