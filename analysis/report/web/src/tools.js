import { el, svg } from './dom.js';
import { shown } from './number.js';
import { copied, font, ofImage, plain, textOf } from './standing.js';
import { colours } from './theme.js';

/** Hands a file to the reader. */
export function save(name, type, text) {
  const blob = text instanceof Blob ? text : new Blob([text], { type });
  const link = el('a', { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

const fileName = (title) => title.replaceAll(/[^\w.-]+/g, '_');

/** Of CSV: quoted where it must be. */
const csvCell = (value) => (typeof value === 'string' && /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : (value ?? ''));

/**
 * A picture of the page that is no chart of curves, as a part of tools(). `columns()`: its numbers, {name, values}.
 */
export const still = (picture, columns) => ({ vector: () => copied(picture), columns });

const withUnit = (name, unit) => `${name}${unit ? ` [${unit}]` : ''}`;

/** Columns of a chart: {name, values}. Charts of curves have x and y of each. */
function columnsOf({ plot, about, columns }) {
  if (columns) return columns();
  const named = (label) => withUnit(label, about?.unit);
  const name = about?.name.split(' of ')[0] ?? '';
  if (plot.mode === 2)
    return plot.data.slice(1).flatMap(([x, y], k) => [
      { name: `x of ${plot.series[k + 1].label ?? k + 1}`, values: x },
      { name: named(plot.series[k + 1].label ?? `${k + 1}`), values: y },
    ]);
  return [{ name: about?.x ? withUnit(...about.x) : 'x', values: plot.data[0] }, ...plot.series.slice(1).map(({ label }, k) => ({ name: named(`${name}: ${label}`), values: plot.data[k + 1] }))];
}

/** Columns of charts one beside the other, those that all have alike once; empty ones left out. */
export function tableOf(states) {
  const columns = states.flatMap((state, i) => columnsOf(state).filter((column, k) => !(i && k === 0 && column.name === columnsOf(states[0])[0].name)));
  return columns.filter(({ values }) => values.some((value) => value != null));
}

export function csvOf(states) {
  const columns = tableOf(states);
  const rows = Math.max(...columns.map(({ values }) => values.length));
  const lines = [columns.map(({ name }) => csvCell(name)), ...Array.from({ length: rows }, (_, i) => columns.map(({ values }) => csvCell(values[i])))];
  return `${lines.map((line) => line.join(',')).join('\n')}\n`;
}

/** What a chart shows over what: "gain, dB, over Hz". */
const axesOf = ({ name, unit, x: [over, of] = [] }) => [name.split(' of ')[0].replace(/ over .*/, ''), unit, over ? `over ${of || over}` : ''].filter((part) => part).join(', ');

/** What a series looks like. */
function markOf({ isDots, stroke, dash }, x, y, muted) {
  const colour = (typeof stroke === 'function' ? stroke() : stroke) ?? muted;
  if (isDots) return svg('circle', { cx: x + 9, cy: y - 4, r: 3, fill: colour });
  return svg('path', { d: `M${x} ${y - 4}h18`, stroke: colour, 'stroke-width': 2, ...(dash?.length ? { 'stroke-dasharray': dash.join(' ') } : {}) });
}

/** Charts one below the other as one picture that stands alone, with a title and what colours stand for. */
export function pictureOf(title, states) {
  const { ground, text, muted } = colours();
  const parts = states.map((state) => state.vector());
  const width = Math.max(...parts.map((part) => Number(part.getAttribute('width'))));
  let top = 26;
  const placed = parts.map((part, i) => {
    const about = states[i].about;
    const words = about ? svg('text', { x: width - 10, y: top + 4, 'text-anchor': 'end', 'font-size': 10, fill: muted }, axesOf(about)) : null;
    part.setAttribute('y', top);
    top += Number(part.getAttribute('height')) + 6;
    return svg('g', {}, part, words);
  });
  const drawn = states.flatMap(({ plot }) => plot?.series.slice(1).filter((_, k) => plot.data[k + 1]?.some((value) => value != null)) ?? []);
  const marks = [...new Map(drawn.map((series) => [series?.label, series])).values()].filter((series) => series?.label);
  let [x, y] = [10, top + 14];
  const legend = marks.map((series) => {
    const length = 34 + 6.2 * series.label.length;
    if (x + length > width) [x, y] = [10, y + 16];
    const mark = svg('g', {}, markOf(series, x, y, muted), svg('text', { x: x + 24, y, 'font-size': 11, fill: text }, series.label));
    x += length;
    return mark;
  });
  const height = marks.length ? y + 12 : top;
  const picture = svg(
    'svg',
    { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height },
    svg('title', {}, title),
    svg('rect', { width, height, fill: ground }),
    svg('text', { x: 10, y: 17, 'font-size': 13, 'font-weight': 600, fill: text }, title),
    ...placed,
    ...legend,
  );
  plain(picture).setAttribute('font-family', font);
  return picture;
}

/** A picture of points, twice as fine. */
async function pngOf(picture) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(textOf(picture))}`;
  await image.decode();
  const canvas = el('canvas', { width: 2 * picture.getAttribute('width'), height: 2 * picture.getAttribute('height') });
  canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, 'image/png'));
}

/** Most rows of a table of a chart's numbers: beyond these a file is better. */
const mostRows = 1000;

const numberCell = (value) => (typeof value === 'string' ? el('td', {}, value) : el('td', { class: 'n' }, value == null ? '' : shown(value, 5)));

function numberTable(title, states) {
  const columns = tableOf(states);
  const rows = Math.max(...columns.map(({ values }) => values.length));
  const body = Array.from({ length: Math.min(rows, mostRows) }, (_, i) => el('tr', {}, ...columns.map(({ values }) => numberCell(values[i]))));
  return el(
    'div',
    { class: 'table numbers', tabIndex: 0, role: 'region', 'aria-label': `numbers of ${title}` },
    el('table', {}, el('caption', {}, rows > mostRows ? `${title}: the first ${mostRows} of ${rows} rows; CSV has all` : title), el('thead', {}, el('tr', {}, ...columns.map(({ name }) => el('th', { class: 'n', scope: 'col' }, name)))), el('tbody', {}, ...body)),
  );
}

/** Ways to save a picture that is made when it is asked for, and further ones. */
function saving(title, picture, ...further) {
  const act = (label, run) => el('button', { type: 'button', 'aria-label': `${label} of ${title}`, onclick: () => { menu.open = false; run(); } }, label);
  const menu = el(
    'details',
    { class: 'menu' },
    el('summary', { 'aria-label': `save ${title}`, title: 'save' }, '\u2913'),
    el(
      'span',
      {},
      act('PNG', async () => save(`${fileName(title)}.png`, 'image/png', await pngOf(picture()))),
      act('SVG', () => save(`${fileName(title)}.svg`, 'image/svg+xml', textOf(picture()))),
      ...further.map(([label, run]) => act(label, run)),
    ),
  );
  return menu;
}

/** What can be done with the charts of a card: enlarge those of curves, save, read as numbers. */
export function tools(box, title, states) {
  let numbers = null;
  const heights = states.map(({ height }) => height);
  const enlarge = (on) => {
    box.classList.toggle('large', on);
    states.forEach((state, i) => state.resize(on ? Math.round(2.2 * heights[i]) : heights[i]));
    larger.setAttribute('aria-expanded', on);
    if (on) box.scrollIntoView({ block: 'nearest' });
  };
  const larger = states.every(({ resize }) => resize) ? el('button', { type: 'button', title: 'enlarge', 'aria-label': `enlarge ${title}`, 'aria-expanded': false, onclick: () => enlarge(!box.classList.contains('large')) }, '\u2922') : null;
  const menu = saving(
    title,
    () => pictureOf(title, states),
    ['CSV', () => save(`${fileName(title)}.csv`, 'text/csv', csvOf(states))],
    ['numbers', () => {
      if (numbers) numbers.remove();
      numbers = numbers ? null : numberTable(title, states);
      if (numbers) box.append(numbers);
    }],
  );
  box.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape' && box.classList.contains('large')) enlarge(false);
  });
  return el('span', { class: 'tools' }, ...[larger, menu].filter((one) => one));
}

/** A picture in its frame, below a line with its name and ways to save it. `columns()`: its numbers. */
export function framed(title, picture, columns) {
  const box = el('div', { class: 'chart' });
  box.append(el('h3', {}, title, tools(box, title, [still(picture, columns)])), el('div', { class: 'picture' }, picture));
  return box;
}

/** Colours of the program's pictures as the page has them. */
const themed = { '#fff': 'ground', '#ffffff': 'ground', '#222': 'text', '#222222': 'text', '#666': 'muted', '#666666': 'muted', '#999999': 'start', '#0072b2': 'measured', '#d55e00': 'model', '#ddd': 'line', '#dddddd': 'line', '#ccc': 'line', '#cccccc': 'line', '#d4d4d4': 'line', '#e5e5e5': 'line', '#eee': 'faint' };

let pictures = 0;

/** A picture of the program in the colours and letters of the page, which follow its theme. */
function inTheme(image) {
  const picture = ofImage(image);
  picture.querySelector('title')?.remove();
  for (const element of [picture, ...picture.querySelectorAll('*')]) {
    element.removeAttribute('font-family');
    for (const name of ['fill', 'stroke']) {
      const colour = themed[(element.getAttribute(name) ?? '').toLowerCase()];
      if (colour) element.style[name] = `var(--${colour})`;
    }
  }
  // Names of parts are those of one picture alone.
  const own = `still${++pictures}`;
  for (const element of picture.querySelectorAll('[id]')) element.id = `${own}-${element.id}`;
  for (const element of picture.querySelectorAll('[clip-path]')) element.setAttribute('clip-path', element.getAttribute('clip-path').replace('url(#', `url(#${own}-`));
  picture.setAttribute('role', 'img');
  picture.setAttribute('aria-label', image.alt);
  return picture;
}

/** Pictures that the program has drawn take the page's theme and can be saved too. */
export function saveStills() {
  for (const image of document.querySelectorAll('img.still')) {
    const box = el('div', { class: 'chart' });
    image.replaceWith(box);
    box.append(el('h3', {}, image.alt, el('span', { class: 'tools' }, saving(image.alt, () => ofImage(image)))), el('div', { class: 'picture' }, inTheme(image)));
  }
}
