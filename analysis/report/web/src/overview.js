import { el, svg } from './dom.js';
import { focus } from './focus.js';
import { asking } from './live/asking.js';
import { residualsOf } from './live/misfit.js';
import { canFollow } from './live/whatif.js';
import { logTicks, shown } from './number.js';
import { weighed } from './residual_strip.js';
import { fittedBand } from './residuals.js';
import { still, tools } from './tools.js';

const rowHeight = 17;
const top = 4;

/** Largest of a row's residuals at each frequency [sd]. */
function sizesOf(channel) {
  const answer = { gain: channel.gain_modelled, phase: channel.phase_modelled, mean: channel.mean_modelled };
  const residuals = Object.values(residualsOf(channel, answer, channel.error, channel.loudest));
  return channel.frequency_Hz.map((_, i) => {
    const known = residuals.map((list) => list[i]).filter((value) => value != null);
    return known.length ? Math.max(...known.map(Math.abs)) : null;
  });
}

/** From the ground below 2 sd, of which chance makes as much, to full colour at 8. */
const strengthOf = (size) => Math.round(100 * Math.min(1, Math.max(0.06, (size - 1.5) / 6.5)));

/** The cells of a row: {i, f, size, from, to} at each frequency of the band. */
function cellsOf(channel, edge) {
  const sizes = sizesOf(channel);
  const at = channel.frequency_Hz.flatMap((f, i) => (channel.in_band[i] ? [i] : []));
  return at.flatMap((i, k) => {
    const f = channel.frequency_Hz[i];
    const from = k ? Math.sqrt(f * channel.frequency_Hz[at[k - 1]]) : f / edge;
    const to = k + 1 < at.length ? Math.sqrt(f * channel.frequency_Hz[at[k + 1]]) : f * edge;
    return sizes[i] == null ? [] : [{ f, size: sizes[i], from, to }];
  });
}

/** The cells of a map by arrow keys: one stop of the tabulator, Enter leads to the curve. `rows`: of {f, words, lead, mark}. */
function byKeys(picture, rows, said) {
  let [row, column] = [0, 0];
  const nearest = (cells, f) => cells.reduce((best, cell, k) => (Math.abs(Math.log(cell.f / f)) < Math.abs(Math.log(cells[best].f / f)) ? k : best), 0);
  const show = () => {
    const cell = rows[row][column];
    cell.mark();
    said.textContent = cell.words;
  };
  const moves = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0], Home: [0, -Infinity], End: [0, Infinity] };
  picture.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') rows[row][column].lead();
    else if (moves[event.key]) {
      const [down, right] = moves[event.key];
      const f = rows[row][column].f;
      row = Math.min(rows.length - 1, Math.max(0, row + down));
      column = down ? nearest(rows[row], f) : Math.min(rows[row].length - 1, Math.max(0, column + right));
      show();
    } else return;
    event.preventDefault();
  });
  picture.addEventListener('focus', show);
}

/** A row per channel, a cell per frequency of the band, as dark as the model is off there; `worst`: {name, place} or null. */
function mapOf(recording, channels, band, left, width, worst) {
  const [low, high] = band;
  const edge = (high / low) ** 0.01;
  const x = (f) => left + ((width - left) * Math.log(f / (low / edge))) / Math.log((high * edge) / (low / edge));
  const height = top + rowHeight * channels.length + 18;
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, width, height, role: 'application', tabindex: 0, 'aria-label': `residuals of ${recording}: each channel over frequency; arrow keys read the cells, Enter leads to the curve` });
  const cursor = svg('rect', { class: 'cursor', height: rowHeight - 1.5, fill: 'none' });
  const rows = channels.map((channel, row) => {
    const y = top + rowHeight * row;
    picture.append(svg('text', { x: left - 6, y: y + rowHeight / 2, 'text-anchor': 'end', 'dominant-baseline': 'central', 'font-size': 11 }, channel.name));
    return cellsOf(channel, edge).map(({ f, size, from, to }) => {
      const words = `${channel.name} in ${recording}, ${shown(f, 3)} Hz: ${shown(size, 2)} sd`;
      const lead = () => focus({ recording, channel: channel.name, low: f / 1.4, high: f * 1.4 });
      const place = { x: x(from), y, width: Math.max(1, x(to) - x(from) + 0.3) };
      const cell = svg('rect', { ...place, height: rowHeight - 1.5 }, svg('title', {}, words));
      cell.style.fill = `color-mix(in srgb, var(--model) ${strengthOf(size)}%, var(--ground))`;
      cell.style.cursor = 'pointer';
      cell.addEventListener('click', lead);
      picture.append(cell);
      return { f, words, lead, mark: () => Object.entries(place).forEach(([name, value]) => cursor.setAttribute(name, value)) };
    });
  });
  const row = worst?.place?.recording === recording ? channels.findIndex(({ name }) => name === worst.name) : -1;
  if (row >= 0) {
    const [from, to] = worst.place.band_Hz.map((f) => x(f < low * 1.001 ? low / edge : f > high * 0.999 ? high * edge : f));
    picture.append(svg('rect', { class: 'worst', x: from, y: top + rowHeight * row - 0.5, width: to - from, height: rowHeight - 0.5, fill: 'none' }, svg('title', {}, `worst channel, where its misfit is largest: ${shown(worst.place.misfit, 2)} times noise and stated model error`)));
  }
  picture.append(cursor);
  let last = -Infinity;
  for (const f of logTicks(low, high)) {
    if (x(f) - last < 26 || x(f) > width - 8) continue;
    last = x(f);
    picture.append(svg('text', { x: last, y: height - 4, 'font-size': 11, 'text-anchor': 'middle', class: 'dim' }, shown(f, 3)));
  }
  const columns = () => {
    const cells = channels.flatMap((channel) => sizesOf(channel).flatMap((size, i) => (channel.in_band[i] && size != null ? [[channel.name, channel.frequency_Hz[i], size]] : [])));
    return ['channel', 'frequency [Hz]', 'largest residual [sd]'].map((name, k) => ({ name, values: cells.map((cell) => cell[k]) }));
  };
  const box = el('div', { class: 'chart' });
  const said = el('p', { class: 'note said', role: 'status' });
  const readable = rows.filter((cells) => cells.length);
  if (readable.length) byKeys(picture, readable, said);
  box.append(el('h3', { style: { paddingLeft: `${left}px` } }, recording, tools(box, `residuals of ${recording}`, [still(picture, columns)])), picture, said);
  return box;
}

/** Where the model is off, of all recordings at one look. */
export function drawOverview(place, data) {
  // Recordings kept for validation have no fitted frequency.
  const channels = weighed(data.responses ?? [], data.model_error).filter(({ in_band }) => in_band.some(Boolean));
  const band = fittedBand(data.result?.band_Hz, channels);
  if (!band || !channels.some((channel) => channel.error && sizesOf(channel).some((size) => size != null))) return;
  const recordings = [...new Set(channels.map(({ recording }) => recording))];
  const names = 7 * Math.max(...channels.map(({ name }) => name.length)) + 10;
  const room = place.clientWidth || 1000;
  const worst = data.overview?.worst;
  const isNarrow = room < 640;
  const width = isNarrow ? room : Math.min(640, Math.max(280, (room - 16 * (recordings.length - 1)) / recordings.length));
  place.append(...[
    el('p', { class: 'note' }, `Where the model is off: the largest residual at each channel and frequency of the fitted band, faint within 2 standard deviations of noise and stated model error, full colour from 8. A cell leads to its curve.${worst?.place ? ' Framed: where the worst channel is worst.' : ''}`),
    el('div', { class: 'maps' }, ...recordings.map((recording) => mapOf(recording, channels.filter((channel) => channel.recording === recording), band, names, width, worst))),
    canFollow(data) ? el('div', { class: 'controls' }, asking(), el('span', { class: 'note' }, 'a slider for each parameter; curves, misfit, modes, ride and vehicle follow')) : null,
  ].filter((part) => part));
}
