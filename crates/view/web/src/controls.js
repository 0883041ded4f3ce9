// The bar under the picture, and the keyboard.

const byId = (id) => document.getElementById(id);

export function makeControls(clock, picture, data) {
  const [play, scrub, now] = [byId('play'), byId('scrub'), byId('now')];
  scrub.step = 'any';

  play.addEventListener('click', clock.toggle);
  byId('back').addEventListener('click', () => clock.step(-1));
  byId('forth').addEventListener('click', () => clock.step(1));
  scrub.addEventListener('input', () => clock.seek(Number(scrub.value)));
  byId('speed').addEventListener('change', (event) => (clock.speed = Number(event.target.value)));
  byId('loop').addEventListener('change', (event) => (clock.loop = event.target.checked));

  const onlyWithPicture = (id, act) => {
    if (picture) byId(id).addEventListener('change', act);
    else byId(id).disabled = true;
  };
  onlyWithPicture('view', (event) => picture.view(event.target.value));
  picture?.onTurn(() => (byId('view').value = ''));
  onlyWithPicture('follow', (event) => picture.setFollow(event.target.checked));
  onlyWithPicture('arrows', (event) => picture.show('forces', event.target.checked));
  onlyWithPicture('trail', (event) => picture.show('trail', event.target.checked));
  const load = (next) => {
    byId('arrows').closest('label').hidden = next.feet.length === 0;
    byId('trail').closest('label').hidden = !next.com;
  };
  load(data);

  const update = () => {
    [scrub.min, scrub.max] = [String(clock.first), String(clock.last)];
    play.dataset.playing = String(clock.playing);
    play.setAttribute('aria-label', clock.playing ? 'Pause' : 'Play');
    scrub.value = String(clock.time());
    now.textContent = `${clock.time().toFixed(2)} / ${clock.last.toFixed(2)} s`;
    scrub.setAttribute('aria-valuetext', `${clock.time().toFixed(2)} s`);
  };
  clock.onChange(update);
  update();
  keys(clock);
  document.querySelectorAll('details.menu').forEach(closes);
  // Another motion is shown: `load(data)`.
  return { load };
}

// A menu closes on Escape and by a click beside it.
function closes(menu) {
  document.addEventListener('click', (event) => menu.contains(event.target) || (menu.open = false));
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !menu.open) return;
    menu.open = false;
    menu.querySelector('summary').focus();
  });
}

function keys(clock) {
  // A button that was clicked would take the next press of the space bar for itself.
  document.addEventListener('click', (event) => {
    const button = event.target.closest?.('button');
    if (button && event.detail > 0) button.blur();
  });
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const own = event.target.closest?.('button, select, summary, input[type=checkbox]');
    const acts = {
      ' ': () => clock.toggle(),
      ArrowLeft: () => clock.step(event.shiftKey ? -10 : -1),
      ArrowRight: () => clock.step(event.shiftKey ? 10 : 1),
      Home: () => clock.seek(clock.first),
      End: () => clock.seek(clock.last),
    };
    const act = acts[event.key];
    if (!act || (own && (event.key === ' ' || own.matches('select')))) return;
    event.preventDefault();
    act();
  });
}
