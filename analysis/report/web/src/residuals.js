import { choice, el } from './dom.js';
import { fixed, shown } from './number.js';

/** Relative error of the phasor, |model / measurement - 1|. */
function relativeError(channel, i, model) {
  const ratio = channel[`gain_${model}`]?.[i] / channel.gain_measured[i];
  const turn = ((channel[`phase_${model}`]?.[i] - channel.phase_measured?.[i]) * Math.PI) / 180;
  const error = Math.sqrt(Math.max(0, 1 + ratio * ratio - 2 * ratio * Math.cos(turn)));
  return Number.isFinite(error) && channel[`gain_${model}`][i] != null ? error : null;
}

/** Octaves that hold frequencies: [lower, upper]. */
function octaves(channels) {
  const all = new Set(channels.flatMap((channel) => channel.frequency_Hz.map((f) => Math.floor(Math.log2(f) + 1e-9))));
  return [...all].sort((a, b) => a - b).map((k) => [2 ** k, 2 ** (k + 1)]);
}

function rms(channel, [low, high], model) {
  let sum = 0;
  let count = 0;
  channel.frequency_Hz.forEach((f, i) => {
    const error = f >= low * 0.999999 && f < high * 0.999999 ? relativeError(channel, i, model) : null;
    if (error == null) return;
    sum += error * error;
    ++count;
  });
  return count ? Math.sqrt(sum / count) : null;
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

function table(recording, channels, bands, fitBand, model) {
  const isFitted = ([low, high]) => high > fitBand[0] * 1.001 && low < fitBand[1] * 0.999;
  const head = bands.map((band) => el('th', { class: `n${isFitted(band) ? '' : ' unfitted'}` }, `${shown(band[0], 2)}\u2013${shown(band[1], 2)}`));
  const rows = channels.map((channel) =>
    el(
      'tr',
      {},
      el('td', {}, el('code', {}, channel.name)),
      ...bands.map((band) => cell(rms(channel, band, model), isFitted(band))),
    ),
  );
  return el(
    'div',
    { class: 'table' },
    el('table', { class: 'heats' }, el('thead', {}, el('tr', {}, el('th', {}, `${recording}, Hz`), ...head)), el('tbody', {}, ...rows)),
  );
}

/** Relative error by octave, a table per recording. */
export function drawResiduals(place, data) {
  const bands = octaves(data.responses);
  const fitBand = data.result.band_Hz ?? [0, Infinity];
  const recordings = [...new Set(data.responses.map((channel) => channel.recording))];
  const hasStart = data.responses.some((channel) => channel.gain_start?.some((value) => value != null));
  const tables = el('div', { class: 'tables' });
  const redraw = (model) =>
    tables.replaceChildren(
      ...recordings.map((name) =>
        table(name, data.responses.filter((channel) => channel.recording === name), bands, fitBand, model),
      ),
    );
  place.append(
    el('p', { class: 'note' }, 'Root mean square of |model / measurement \u2212 1| in percent, gain and phase together, by octave. Grey: not fitted.'),
  );
  if (hasStart) place.append(el('div', { class: 'controls' }, choice('model', [['modelled', 'fit'], ['start', 'start']], 'modelled', redraw)));
  place.append(tables);
  redraw('modelled');
}
