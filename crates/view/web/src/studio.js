// The button that hands the motion over to the studio that lies beside the page. The two talk by messages of windows: no network, and no files.

// How long the studio may need to begin (ms).
const PATIENCE = 12_000;
const PAGE = 'studio.html';
const HOW = `No ${PAGE} beside this page has answered. Make one: solaris studio -o ${PAGE} in this folder. Or open a studio and drop this page on it.`;

export function makeStudioButton(json, title) {
  const button = document.getElementById('studio');
  const note = document.getElementById('no-studio');
  // Within another page there is nothing beside it.
  if (!button || window.top !== window) return;
  button.hidden = false;
  note.querySelector('button').addEventListener('click', () => (note.hidden = true));
  button.addEventListener('click', () => {
    note.hidden = true;
    const studio = window.open(new URL(PAGE, location.href), '_blank');
    const say = () => {
      note.hidden = false;
      note.querySelector('p').textContent = HOW;
    };
    if (!studio) {
      say();
      return;
    }
    const waiting = setTimeout(say, PATIENCE);
    window.addEventListener('message', function hear({ source, origin, data }) {
      // Pages from disk have no origin of their own: theirs and ours is "null", or "file://".
      if (source !== studio || (origin !== self.origin && origin !== location.origin) || data?.solaris !== 'studio') return;
      clearTimeout(waiting);
      note.hidden = true;
      window.removeEventListener('message', hear);
      // To that window alone; a page from disk cannot name its origin.
      studio.postMessage({ solaris: 'motion', title, json }, location.protocol === 'file:' ? '*' : location.origin);
    });
  });
}
