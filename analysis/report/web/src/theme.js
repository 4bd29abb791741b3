const listeners = [];
const runs = ['run0', 'run1', 'run2', 'run3', 'run4', 'run5'];
const names = ['ground', 'raised', 'line', 'faint', 'text', 'muted', 'measured', 'model', 'whatif', 'start', 'band', 'good', 'poor', ...runs];

const dashes = [undefined, [7, 5], [2, 4], [10, 4, 2, 4], [4, 4], [12, 6]];

/** The line of a run among others: the first is broad, those over it are broken, so that it shows where they agree. */
export const runLine = (i) => ({
  colour: runs[i % runs.length],
  dash: dashes[(i + Math.floor(i / runs.length)) % dashes.length],
  width: i === 0 ? 3.4 : 1.8,
});

/** Asked for with every stroke of a chart, so read once a theme. */
let current = null;

/** The colours of the page as it is now. */
export function colours() {
  if (current) return current;
  const style = getComputedStyle(document.documentElement);
  current = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  return current;
}

export function isDark() {
  return document.documentElement.dataset.theme === 'dark';
}

/** Whether the page is drawn for paper. */
export const isPrinting = () => document.documentElement.classList.contains('printing');

/** Calls back whenever the colours change. */
export function onTheme(listener) {
  listeners.push(listener);
}

const papers = [];

/** Calls back with true before the page is printed, with false after that. */
export function onPaper(listener) {
  papers.push(listener);
}

function set(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  current = null;
  const button = document.getElementById('theme');
  if (button) button.textContent = dark ? 'light' : 'dark';
  for (const listener of listeners) listener();
}

/** The system's theme until the reader chooses another; paper is white. */
export function startTheme() {
  const system = matchMedia('(prefers-color-scheme: dark)');
  let chosen = null;
  const wanted = () => chosen ?? system.matches;
  set(wanted());
  system.addEventListener('change', () => set(wanted()));
  const button = document.getElementById('theme');
  if (button) {
    button.hidden = false;
    button.addEventListener('click', () => {
      chosen = !isDark();
      set(chosen);
    });
  }
  // Charts are drawn anew with the theme, as wide as the page is then.
  addEventListener('beforeprint', () => {
    document.documentElement.classList.add('printing');
    set(false);
    for (const listener of papers) listener(true);
  });
  addEventListener('afterprint', () => {
    document.documentElement.classList.remove('printing');
    for (const listener of papers) listener(false);
    set(wanted());
  });
}
