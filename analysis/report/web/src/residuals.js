import { choice, el } from './dom.js';
import { focus } from './focus.js';
import { residualsOf } from './live/misfit.js';
import { extent, fixed, listOf, shown } from './number.js';
import { weighed } from './residual_strip.js';

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

/** Frequencies around each mode, up to half way to its neighbours on a logarithmic axis: as bandsOf(). */
export function modeBands(modes, channels, band) {
  const known = modes.filter(({ frequency_Hz }) => frequency_Hz > 0).sort((a, b) => a.frequency_Hz - b.frequency_Hz);
  const widest = 2 ** 0.5;
  const between = (a, b) => Math.sqrt(a.frequency_Hz * b.frequency_Hz);
  return known
    .map((mode, i) => ({
      name: mode.name,
      low: Math.max(mode.frequency_Hz / widest, i ? between(known[i - 1], mode) : 0),
      high: Math.min(mode.frequency_Hz * widest, i + 1 < known.length ? between(mode, known[i + 1]) : Infinity),
    }))
    .map((part) => ({ ...part, fitted: band != null && channels.some((channel) => rowsOf(channel, { ...part, fitted: true }, band).length > 0) }))
    .filter((part) => channels.some((channel) => rowsOf(channel, part, band).length));
}

const rms = (list) => (list.length ? Math.sqrt(list.reduce((sum, value) => sum + value * value, 0) / list.length) : null);
const numbers = (list) => list.filter((value) => value != null);

/** Relative error of a channel over a part of the band; null where there is none. */
export function errorOver(channel, part, band, model) {
  return rms(numbers(rowsOf(channel, part, band).map((i) => relativeError(channel, i, model))));
}

/** Root mean square of the residuals [sd] of gain and phase of a weighed channel over a part of the band, as the program has them in its misfits of channels; null where there is none. */
export function residualOver(channel, part, band, model) {
  const answer = { gain: channel[`gain_${model}`] ?? [], phase: channel[`phase_${model}`] ?? [], mean: channel[`mean_${model}`] };
  const { along, across } = residualsOf(channel, answer, channel.error, channel.loudest);
  return rms(numbers(rowsOf(channel, part, band).flatMap((i) => [along[i], across[i]])));
}

/** Whether a channel moves so little there, beside others of its unit, that it is next to a node. */
export function isNearNode(channel, part, band) {
  const small = 0.1;
  const rows = rowsOf(channel, part, band);
  return rows.length > 0 && channel.loudest != null && rows.every((i) => !(channel.gain_measured[i] > small * channel.loudest[i]));
}

/** What is shown of a cell: a number, the strength of its colour, and words. */
const measures = {
  sd: { of: residualOver, strength: (value) => Math.min(1, Math.max(0, (value - 1) / 6)), text: (value) => fixed(value, value < 9.95 ? 1 : 0), unit: ' sd' },
  percent: { of: errorOver, strength: (value) => Math.min(1, Math.sqrt(value / 1.5)), text: (value) => fixed(100 * value, value < 0.0995 ? 1 : 0), unit: ' %' },
};

/** Leads to the curve. */
function cell(channel, part, band, { measure, model }) {
  const { of, strength, text, unit } = measures[measure];
  const value = of(channel, part, band, model);
  const node = isNearNode(channel, part, band);
  const share = value == null ? 0 : (part.fitted ? 1 : 0.4) * strength(value);
  const target = { recording: channel.recording, channel: channel.name, low: part.low, high: part.high };
  const words = value == null ? '' : `${channel.name} in ${channel.recording}, ${shown(part.low, 3)} to ${shown(part.high, 3)} Hz: ${text(value)}${unit}${node ? ', next to a node: it moves less than a tenth of the others of its unit' : ''}`;
  return el(
    'td',
    { class: `n heat${part.fitted ? '' : ' unfitted'}`, style: { background: `color-mix(in srgb, var(--model) ${fixed(70 * share, 0)}%, transparent)` } },
    value == null ? '' : el('button', { type: 'button', title: words, 'aria-label': words, onclick: () => focus(target) }, text(value), node ? el('sup', {}, '\u25cb') : null),
  );
}

function table(recording, channels, parts, band, state) {
  const range = ({ low, high }) => `${shown(low, 3)}\u2013${shown(high, 3)}`;
  const head = parts.map((part) => el('th', { class: `n${part.fitted ? '' : ' unfitted'}`, scope: 'col' }, part.name ? [el('span', {}, part.name), el('br'), el('small', {}, range(part))] : range(part)));
  const rows = channels.map((channel) => el('tr', {}, el('th', { scope: 'row' }, el('code', {}, channel.name)), ...parts.map((part) => cell(channel, part, band, state))));
  return el(
    'div',
    { class: 'table' },
    el('table', { class: 'heats' }, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, `${recording}, Hz`), ...head)), el('tbody', {}, ...rows)),
  );
}

/** The summary's worst channel leads to where the program found it worst. */
function linkWorst({ overview }) {
  const link = document.querySelector('[data-worst]');
  const place = overview?.worst?.place;
  if (!link || !place) return;
  link.addEventListener('click', (event) => {
    event.preventDefault();
    focus({ recording: place.recording, channel: overview.worst.name, low: place.band_Hz[0], high: place.band_Hz[1] });
  });
}

const notes = {
  sd: 'Root mean square of the residuals of gain and phase in standard deviations, of noise and stated model error: about 1 where the model explains the data. A channel\u2019s misfit in the summary is that of its whole row, over all recordings.',
  percent: 'Root mean square of |model / measurement \u2212 1| in percent, gain and phase together.',
};
const divisions = { octave: 'By octave, split at the limits of the fitted band.', mode: 'By mode, up to half way to its neighbours and half an octave at most.' };

/** Errors of each channel by octave or by mode, a table per recording. */
export function drawResiduals(place, data) {
  const band = fittedBand(data.result.band_Hz, data.responses);
  const channels = weighed(data.responses, data.model_error);
  const octaves = bandsOf(channels, band);
  const modes = modeBands(listOf(data.scene?.modes), channels, band);
  const recordings = [...new Set(channels.map((channel) => channel.recording))];
  const hasStart = channels.some((channel) => channel.gain_start?.some((value) => value != null));
  const hasSd = channels.some((channel) => channel.error && octaves.some((part) => residualOver(channel, part, band, 'modelled') != null));
  const state = { measure: hasSd ? 'sd' : 'percent', model: 'modelled', by: 'octave' };
  const tables = el('div', { class: 'tables' });
  const note = el('p', { class: 'note' });
  const redraw = () => {
    const parts = state.by === 'mode' ? modes : octaves;
    note.textContent = `${notes[state.measure]} ${divisions[state.by]} Grey: not fitted; \u25cb: next to a node, where a channel moves less than a tenth of the others of its unit. A cell leads to its curve.`;
    tables.replaceChildren(...recordings.map((name) => table(name, channels.filter((channel) => channel.recording === name), parts, band, state)));
  };
  const control = (label, key, options) =>
    choice(label, options, state[key], (value) => {
      state[key] = value;
      redraw();
    });
  place.append(
    note,
    el(
      'div',
      { class: 'controls' },
      hasSd ? control('measure', 'measure', [['sd', 'sd'], ['percent', '%']]) : null,
      modes.length ? control('divided', 'by', [['octave', 'by octave'], ['mode', 'by mode']]) : null,
      hasStart ? control('model', 'model', [['modelled', 'fit'], ['start', 'start']]) : null,
    ),
    tables,
  );
  redraw();
  linkWorst(data);
}
