// The page's colours live in style.css; the canvas and the plots read them from there.

export function readTheme() {
  const style = getComputedStyle(document.documentElement);
  const get = (name) => style.getPropertyValue(`--${name}`).trim();
  return {
    sky: get('sky'),
    ink: get('ink'),
    soft: get('soft'),
    grid: get('grid'),
    gridStrong: get('grid-strong'),
    font: get('font'),
    // Of the body, and of lines and arrows.
    body: { left: get('body-left'), right: get('body-right'), middle: get('body-middle') },
    line: { left: get('left'), right: get('right'), middle: get('middle') },
    dark: get('dark') === '1',
  };
}

// Calls `listener` when the reader's system turns light or dark.
export function onThemeChange(listener) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', listener);
}
