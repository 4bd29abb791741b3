import { el, svg } from './dom.js';
import { shown } from './number.js';
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

/** Columns of a chart: {name, values}. Charts of curves have x and y of each. */
function columnsOf({ plot, about }) {
  const named = (label) => `${label}${about?.unit ? ` [${about.unit}]` : ''}`;
  const name = about?.name.split(' of ')[0] ?? '';
  if (plot.mode === 2)
    return plot.data.slice(1).flatMap(([x, y], k) => [
      { name: `x of ${plot.series[k + 1].label ?? k + 1}`, values: x },
      { name: named(plot.series[k + 1].label ?? `${k + 1}`), values: y },
    ]);
  return [{ name: 'x', values: plot.data[0] }, ...plot.series.slice(1).map(({ label }, k) => ({ name: named(`${name}: ${label}`), values: plot.data[k + 1] }))];
}

/** Columns of charts one beside the other, those that all have alike once; empty ones left out. */
export function tableOf(states) {
  const columns = states.flatMap((state, i) => columnsOf(state).filter((column, k) => !(i && k === 0 && column.name === 'x')));
  return columns.filter(({ values }) => values.some((value) => value != null));
}

export function csvOf(states) {
  const columns = tableOf(states);
  const rows = Math.max(...columns.map(({ values }) => values.length));
  const lines = [columns.map(({ name }) => csvCell(name)), ...Array.from({ length: rows }, (_, i) => columns.map(({ values }) => csvCell(values[i])))];
  return `${lines.map((line) => line.join(',')).join('\n')}\n`;
}

/** Charts one below the other as one picture, with a title and what colours stand for. */
export function pictureOf(title, states) {
  const { ground, text, muted } = colours();
  const font = 'system-ui, "Liberation Sans", Arial, sans-serif';
  const parts = states.map((state) => state.vector());
  const width = Math.max(...parts.map((part) => Number(part.getAttribute('width'))));
  let top = 26;
  const placed = parts.map((part, i) => {
    const about = states[i].about;
    const words = svg('text', { x: width - 10, y: top + 4, 'text-anchor': 'end', 'font-size': 10, fill: muted }, about ? `${about.name.split(' of ')[0]}, ${about.unit}` : '');
    part.setAttribute('y', top);
    top += Number(part.getAttribute('height')) + 6;
    return svg('g', {}, part, words);
  });
  const marks = [...new Map(states.flatMap(({ plot }) => plot.series.slice(1)).map((series) => [series?.label, series])).values()].filter((series) => series?.label);
  let [x, y] = [10, top + 14];
  const legend = marks.map(({ label, stroke, dash }) => {
    const length = 34 + 6.2 * label.length;
    if (x + length > width) [x, y] = [10, y + 16];
    const colour = typeof stroke === 'function' ? stroke() : stroke;
    const mark = svg('g', {}, svg('path', { d: `M${x} ${y - 4}h18`, stroke: colour ?? muted, 'stroke-width': 2, ...(dash?.length ? { 'stroke-dasharray': dash.join(' ') } : {}) }), svg('text', { x: x + 24, y, 'font-size': 11, fill: text }, label));
    x += length;
    return mark;
  });
  const height = y + 12;
  return svg(
    'svg',
    { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height, 'font-family': font },
    svg('rect', { width, height, fill: ground }),
    svg('text', { x: 10, y: 17, 'font-size': 13, 'font-weight': 600, fill: text }, title),
    ...placed,
    ...legend,
  );
}

const textOf = (picture) => new XMLSerializer().serializeToString(picture);

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

function numberTable(title, states) {
  const columns = tableOf(states);
  const rows = Math.max(...columns.map(({ values }) => values.length));
  const body = Array.from({ length: Math.min(rows, mostRows) }, (_, i) => el('tr', {}, ...columns.map(({ values }) => el('td', { class: 'n' }, values[i] == null ? '' : shown(values[i], 5)))));
  return el(
    'div',
    { class: 'table numbers', tabIndex: 0, role: 'region', 'aria-label': `numbers of ${title}` },
    el('table', {}, el('caption', {}, rows > mostRows ? `${title}: the first ${mostRows} of ${rows} rows; CSV has all` : title), el('thead', {}, el('tr', {}, ...columns.map(({ name }) => el('th', { class: 'n', scope: 'col' }, name)))), el('tbody', {}, ...body)),
  );
}

/** What can be done with the charts of a card: enlarge, save, read as numbers. */
export function tools(box, title, states) {
  let numbers = null;
  const heights = states.map(({ height }) => height);
  const enlarge = (on) => {
    box.classList.toggle('large', on);
    states.forEach((state, i) => state.resize(on ? Math.round(2.2 * heights[i]) : heights[i]));
    larger.setAttribute('aria-expanded', on);
    if (on) box.scrollIntoView({ block: 'nearest' });
  };
  const larger = el('button', { type: 'button', title: 'enlarge', 'aria-label': `enlarge ${title}`, 'aria-expanded': false, onclick: () => enlarge(!box.classList.contains('large')) }, '\u2922');
  const act = (label, run) => el('button', { type: 'button', 'aria-label': `${label} of ${title}`, onclick: () => { menu.open = false; run(); } }, label);
  const menu = el(
    'details',
    { class: 'menu' },
    el('summary', { 'aria-label': `save ${title}`, title: 'save' }, '\u2913'),
    el(
      'span',
      {},
      act('PNG', async () => save(`${fileName(title)}.png`, 'image/png', await pngOf(pictureOf(title, states)))),
      act('SVG', () => save(`${fileName(title)}.svg`, 'image/svg+xml', textOf(pictureOf(title, states)))),
      act('CSV', () => save(`${fileName(title)}.csv`, 'text/csv', csvOf(states))),
      act('numbers', () => {
        if (numbers) numbers.remove();
        numbers = numbers ? null : numberTable(title, states);
        if (numbers) box.append(numbers);
      }),
    ),
  );
  box.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape' && box.classList.contains('large')) enlarge(false);
  });
  return el('span', { class: 'tools' }, larger, menu);
}
