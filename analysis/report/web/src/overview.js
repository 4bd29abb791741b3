import { el, svg } from './dom.js';
import { focus } from './focus.js';
import { residualsOf } from './live/misfit.js';
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

/** A row per channel, a cell per frequency of the band, as dark as the model is off there. */
function mapOf(recording, channels, band, left, width) {
  const [low, high] = band;
  const edge = (high / low) ** 0.01;
  const x = (f) => left + ((width - left) * Math.log(f / (low / edge))) / Math.log((high * edge) / (low / edge));
  const height = top + rowHeight * channels.length + 18;
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, width, height, role: 'img', 'aria-label': `residuals of ${recording}: each channel over frequency` });
  channels.forEach((channel, row) => {
    const y = top + rowHeight * row;
    picture.append(svg('text', { x: left - 6, y: y + rowHeight / 2, 'text-anchor': 'end', 'dominant-baseline': 'central', 'font-size': 11 }, channel.name));
    const sizes = sizesOf(channel);
    const at = channel.frequency_Hz.flatMap((f, i) => (channel.in_band[i] ? [i] : []));
    at.forEach((i, k) => {
      if (sizes[i] == null) return;
      const f = channel.frequency_Hz[i];
      const from = k ? Math.sqrt(f * channel.frequency_Hz[at[k - 1]]) : f / edge;
      const to = k + 1 < at.length ? Math.sqrt(f * channel.frequency_Hz[at[k + 1]]) : f * edge;
      const cell = svg('rect', { x: x(from), y, width: Math.max(1, x(to) - x(from) + 0.3), height: rowHeight - 1.5 }, svg('title', {}, `${channel.name} in ${recording}, ${shown(f, 3)} Hz: ${shown(sizes[i], 2)} sd`));
      cell.style.fill = `color-mix(in srgb, var(--model) ${strengthOf(sizes[i])}%, var(--ground))`;
      cell.style.cursor = 'pointer';
      cell.addEventListener('click', () => focus({ recording, channel: channel.name, low: f / 1.4, high: f * 1.4 }));
      picture.append(cell);
    });
  });
  let last = -Infinity;
  for (const f of logTicks(low, high)) {
    if (x(f) - last < 26 || x(f) > width - 8) continue;
    last = x(f);
    picture.append(svg('text', { x: last, y: height - 4, 'font-size': 11, 'text-anchor': 'middle', class: 'dim' }, shown(f, 3)));
  }
  const columns = () => {
    const rows = channels.flatMap((channel) => sizesOf(channel).flatMap((size, i) => (channel.in_band[i] && size != null ? [[channel.name, channel.frequency_Hz[i], size]] : [])));
    return ['channel', 'frequency [Hz]', 'largest residual [sd]'].map((name, k) => ({ name, values: rows.map((row) => row[k]) }));
  };
  const box = el('div', { class: 'chart' });
  box.append(el('h3', { style: { paddingLeft: `${left}px` } }, recording, tools(box, `residuals of ${recording}`, [still(picture, columns)])), picture);
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
  const isNarrow = room < 640;
  const width = isNarrow ? room : Math.min(640, Math.max(280, (room - 16 * (recordings.length - 1)) / recordings.length));
  place.append(
    el('p', { class: 'note' }, 'Where the model is off: the largest residual of each channel and frequency of the fitted band, faint within 2 standard deviations of noise and stated model error, full colour from 8. A cell leads to its curve.'),
    el('div', { class: 'maps' }, ...recordings.map((recording) => mapOf(recording, channels.filter((channel) => channel.recording === recording), band, names, width))),
  );
}
