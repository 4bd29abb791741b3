import { el } from './dom.js';

/** What a cell says, in one line. */
const textOf = (cell) => cell.innerText.replaceAll(/\s*\n\s*/g, ' ').trim();

/** The number that a text begins with, in the signs that reports write: minus, thin spaces, powers of ten; or none. */
export function numberOf(text) {
  const plain = text.replaceAll(/[\u2009\u202f\s]/g, '').replaceAll('\u2212', '-');
  const [, mantissa, raised] = /^[<>\u2264\u2265\u00b1]?(-?\d[\d.]*(?:e[-+]?\d+)?)(?:\u00b710([\u2070\u00b9\u00b2\u00b3\u2074-\u2079\u207b]+))?/.exec(plain) ?? [];
  if (mantissa == null) return null;
  const digits = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';
  const exponent = raised ? Number([...raised].map((sign) => (sign === '\u207b' ? '-' : digits.indexOf(sign))).join('')) : 0;
  return Number(mantissa) * 10 ** exponent;
}

/** By numbers where there are some, then by words; what is empty comes last either way. */
export function compareCells(a, b, up) {
  if (!a || !b) return a ? -1 : b ? 1 : 0;
  const [x, y] = [numberOf(a), numberOf(b)];
  const order = x != null && y != null ? x - y : x != null ? -1 : y != null ? 1 : a.localeCompare(b);
  return up ? order : -order;
}

/** Rows in the order of a column; at the third time as they were. */
function sortBy(table, heads, column, before) {
  const next = { none: 'ascending', ascending: 'descending', descending: 'none' };
  const order = next[heads[column].getAttribute('aria-sort') ?? 'none'];
  heads.forEach((head, k) => {
    if (head.matches('th')) head.setAttribute('aria-sort', k === column ? order : 'none');
  });
  const rows = order === 'none' ? before : [...before].sort((a, b) => compareCells(textOf(a.cells[column]), textOf(b.cells[column]), order === 'ascending'));
  table.tBodies[0].append(...rows);
}

/** Its rows as spreadsheets paste them. */
export const pasted = (table) =>
  [...table.rows].map((row) => [...row.cells].map(textOf).join('\t')).join('\n');

async function copy(table, button) {
  let done = true;
  await navigator.clipboard?.writeText(pasted(table)).catch(() => (done = false));
  button.textContent = done && navigator.clipboard ? 'copied' : 'not allowed here';
  setTimeout(() => (button.textContent = 'copy'), 1500);
}

/** A head that sorts: its words in a button. */
function sortable(table) {
  const body = table.tBodies[0];
  const heads = [...(table.tHead?.rows[0]?.cells ?? [])];
  const before = [...(body?.rows ?? [])];
  if (before.length < 2 || before.some((row) => row.cells.length !== heads.length)) return;
  heads.forEach((head, k) => {
    if (!textOf(head) || head.querySelector('button')) return;
    const words = el('button', { type: 'button', class: 'sort' }, ...head.childNodes);
    words.addEventListener('click', () => sortBy(table, heads, k, before));
    head.setAttribute('aria-sort', 'none');
    head.append(words);
  });
}

/** The tables of the page sort by their heads and can be copied; those that scroll are reached by keys. */
export function readTables() {
  const titles = new Map();
  for (const frame of document.querySelectorAll('.table')) {
    const table = frame.querySelector('table');
    if (!table?.tHead || table.matches('.heats')) continue;
    const section = frame.closest('section')?.querySelector('h2')?.textContent ?? 'page';
    titles.set(section, (titles.get(section) ?? 0) + 1);
    const title = `${section}, table ${titles.get(section)}`;
    Object.assign(frame, { tabIndex: 0 });
    frame.setAttribute('role', 'region');
    frame.setAttribute('aria-label', title);
    sortable(table);
    const button = el('button', { type: 'button', class: 'copytable', title: 'copy as text for a spreadsheet' }, 'copy');
    button.addEventListener('click', () => copy(table, button));
    frame.after(button);
  }
}
