// Words over the picture, beside what they name, so that none covers another and none is cut off.

// Distance of the words from their point, and from each other (px).
const GAP = 8;
const APART = 2;
// Points that are this near to the middle of all are about to pass each other (px).
const PASSING = 3;
// How many rows up or down the words may give way.
const ROWS = 6;

// Left top corners for words of this size at a point: beside it, then row by row further away.
function* places(x, y, width, height) {
  const row = height + APART;
  for (let k = 0; k <= ROWS; k += 1) {
    for (const sign of k === 0 ? [0] : [-1, 1]) {
      const top = y - height + sign * k * row;
      yield [x + GAP, top];
      yield [x - GAP - width, top];
    }
  }
}

const inside = ([left, top], entry, width, height) =>
  left >= APART && top >= APART && left + entry.width <= width - APART && top + entry.height <= height - APART;

const apart = ([left, top], entry, other) =>
  left + entry.width + APART <= other.left ||
  other.left + other.width + APART <= left ||
  top + entry.height + APART <= other.top ||
  other.top + other.height + APART <= top;

// `entries`: { words, x, y }, the most important first; `words` is an element that is positioned by its transform.
// What finds no room is hidden. Of several, those on the left stand to the left of their points; where points are about to
// pass each other the words stay where they were.
export function arrange(entries, width, height) {
  const placed = [];
  const middle = entries.reduce((sum, { x }) => sum + x, 0) / entries.length;
  for (const entry of entries) {
    const { words } = entry;
    words.hidden = false;
    Object.assign(entry, { width: words.offsetWidth, height: words.offsetHeight });
    const all = [...places(entry.x, entry.y, entry.width, entry.height)];
    const passing = words.dataset.place !== undefined && Math.abs(entry.x - middle) < PASSING;
    const first = passing ? Number(words.dataset.place) : Number(entry.x < middle);
    const fits = (spot) => inside(spot, entry, width, height) && placed.every((other) => apart(spot, entry, other));
    const spot = [all[first], ...all].find(fits);
    words.hidden = !spot;
    delete words.dataset.place;
    if (!spot) continue;
    [entry.left, entry.top] = spot;
    words.dataset.place = String(all.indexOf(spot));
    words.style.transform = `translate(${entry.left}px, ${entry.top}px)`;
    placed.push(entry);
  }
}
