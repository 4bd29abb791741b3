import { choice, el } from './dom.js';
import { extent, fixed, listOf, shown } from './number.js';

/** Frequencies that differ by less are the same: files have six digits. */
const near = 1e-6;

/** Relative error of the phasor, |model / measurement - 1|. */
function relativeError(channel, i, model) {
  const ratio = channel[`gain_${model}`]?.[i] / channel.gain_measured[i];
  const turn = ((channel[`phase_${model}`]?.[i] - channel.phase_measured?.[i]) * Math.PI) / 180;
  const error = Math.sqrt(Math.max(0, 1 + ratio * ratio - 2 * ratio * Math.cos(turn)));
  return Number.isFinite(error) && channel[`gain_${model}`][i] != null ? error : null;
}

/** The band [Hz] of the fit; of an older result, what its rows in the band span. Null: nothing was fitted. */
export function fittedBand(told, channels) {
  if (listOf(told).length === 2 && told.every((f) => Number.isFinite(f))) return told;
  return extent(channels.flatMap((channel) => channel.frequency_Hz.filter((f, i) => channel.in_band[i])));
}

/** Octaves that hold frequencies, parted at the edges of the band: {low, high, fitted} [Hz], each with rows in it. */
export function bandsOf(channels, band) {
  const octaves = [...new Set(channels.flatMap((channel) => channel.frequency_Hz.map((f) => Math.floor(Math.log2(f) + 1e-9))))].sort((a, b) => a - b);
  const parts = octaves.flatMap((k) => {
    const inside = (band ?? []).filter((edge) => edge > 2 ** k * (1 + near) && edge < 2 ** (k + 1) * (1 - near));
    const edges = [2 ** k, ...inside, 2 ** (k + 1)];
    return edges.slice(1).map((high, i) => ({ low: edges[i], high, fitted: band != null && edges[i] > band[0] * (1 - near) && high < band[1] * (1 + near) }));
  });
  return parts.filter((part) => channels.some((channel) => rowsOf(channel, part, band).length));
}

/** Rows of a channel: of a fitted part those that the fit has seen, of another one the others. */
function rowsOf(channel, { low, high, fitted }, band) {
  // The band has its last frequency, an octave has not.
  const last = fitted && high > band[1] * (1 - near) ? high * (1 + near) : high * (1 - near);
  return [...channel.frequency_Hz.keys()].filter((i) => {
    const f = channel.frequency_Hz[i];
    return channel.in_band[i] === fitted && f >= low * (1 - near) && f < last;
  });
}

/** Relative error of a channel over a part of the band; null where there is none. */
export function errorOver(channel, part, band, model) {
  const errors = rowsOf(channel, part, band).map((i) => relativeError(channel, i, model)).filter((error) => error != null);
  return errors.length ? Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length) : null;
}

function cell(value, fitted) {
  const strength = value == null ? 0 : (fitted ? 1 : 0.4) * Math.min(1, Math.sqrt(value / 1.5));
  return el(
    'td',
    {
      class: `n heat${fitted ? '' : ' unfitted'}`,
      style: { background: `color-mix(in srgb, var(--model) ${fixed(70 * strength, 0)}%, transparent)` },
    },
    value == null ? '' : fixed(100 * value, value < 0.0995 ? 1 : 0),
  );
}

function table(recording, channels, parts, band, model) {
  const head = parts.map(({ low, high, fitted }) => el('th', { class: `n${fitted ? '' : ' unfitted'}` }, `${shown(low, 3)}\u2013${shown(high, 3)}`));
  const rows = channels.map((channel) =>
    el(
      'tr',
      {},
      el('td', {}, el('code', {}, channel.name)),
      ...parts.map((part) => cell(errorOver(channel, part, band, model), part.fitted)),
    ),
  );
  return el(
    'div',
    { class: 'table' },
    el('table', { class: 'heats' }, el('thead', {}, el('tr', {}, el('th', {}, `${recording}, Hz`), ...head)), el('tbody', {}, ...rows)),
  );
}

/** Adds to the summary's worst channel where it is worst; its link leads to that recording's chart. */
function markWorst(channels, parts, band) {
  const link = document.querySelector('[data-worst]');
  const cells = channels
    .filter(({ name }) => name === link?.dataset.worst)
    .flatMap((channel) => parts.filter(({ fitted }) => fitted).map((part) => ({ channel, part, error: errorOver(channel, part, band, 'modelled') ?? 0 })));
  if (!cells.length) return;
  const { channel, part } = cells.reduce((worst, cell) => (cell.error > worst.error ? cell : worst));
  link.closest('.tile').lastElementChild.append(`, worst at ${shown(part.low, 3)}\u2013${shown(part.high, 3)} Hz in ${channel.recording}`);
  link.addEventListener('click', (event) => {
    event.preventDefault();
    for (const button of document.querySelectorAll('#responses .controls button')) if (button.textContent === channel.recording) button.click();
    document.querySelector(`#responses .chart[data-channel="${CSS.escape(channel.name)}"]`)?.scrollIntoView({ block: 'center' });
  });
}

/** Relative error by octave and band, a table per recording. */
export function drawResiduals(place, data) {
  const band = fittedBand(data.result.band_Hz, data.responses);
  const parts = bandsOf(data.responses, band);
  const recordings = [...new Set(data.responses.map((channel) => channel.recording))];
  const hasStart = data.responses.some((channel) => channel.gain_start?.some((value) => value != null));
  const tables = el('div', { class: 'tables' });
  const redraw = (model) =>
    tables.replaceChildren(
      ...recordings.map((name) =>
        table(name, data.responses.filter((channel) => channel.recording === name), parts, band, model),
      ),
    );
  place.append(
    el('p', { class: 'note' }, 'Root mean square of |model / measurement \u2212 1| in percent, gain and phase together, by octave and split at the limits of the fitted band. Grey: not fitted.'),
  );
  if (hasStart) place.append(el('div', { class: 'controls' }, choice('model', [['modelled', 'fit'], ['start', 'start']], 'modelled', redraw)));
  place.append(tables);
  redraw('modelled');
  markWorst(data.responses, parts, band);
}
