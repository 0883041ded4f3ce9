// Where the page is narrow or low, its panels are tabs: one is shown at a time. Elsewhere they all stand below each other.

// As in style.css.
const COMPACT = '(max-width: 860px), (max-height: 560px)';

// `bar`: an empty element; its sections follow it. A section that is hidden, or empty, gets no tab.
export function makeTabs(bar) {
  const panels = [...bar.parentElement.querySelectorAll(':scope > .panel')].filter(
    (panel) => !panel.hidden && panel.childElementCount > 0,
  );
  const tabs = panels.map((panel) => {
    const tab = document.createElement('button');
    Object.assign(tab, { type: 'button', id: `tab-${panel.id}`, textContent: panel.dataset.title });
    tab.setAttribute('role', 'tab');
    tab.setAttribute('aria-controls', panel.id);
    tab.addEventListener('click', () => open(panel));
    return tab;
  });
  bar.append(...tabs);
  bar.addEventListener('keydown', (event) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by) return;
    // Between tabs the arrows go from one to the next, not through the frames.
    event.stopPropagation();
    event.preventDefault();
    const next = (tabs.indexOf(document.activeElement) + by + tabs.length) % tabs.length;
    open(panels[next]);
    tabs[next].focus();
  });

  const compact = matchMedia(COMPACT);
  let shown = panels[0];
  function open(panel) {
    shown = panel;
    const several = compact.matches && panels.length > 1;
    bar.hidden = !several;
    panels.forEach((panel, i) => {
      panel.hidden = several && panel !== shown;
      tabs[i].setAttribute('aria-selected', String(panel === shown));
      tabs[i].tabIndex = panel === shown ? 0 : -1;
      if (several) {
        panel.setAttribute('role', 'tabpanel');
        panel.setAttribute('aria-labelledby', tabs[i].id);
      } else {
        panel.removeAttribute('role');
        panel.removeAttribute('aria-labelledby');
      }
    });
  }
  compact.addEventListener('change', () => open(shown));
  open(shown);
}
