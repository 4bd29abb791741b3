import uPlot from 'uplot';
import { chart, curve, linearAxis } from './chart.js';
import { choice, el } from './dom.js';
import { legend } from './legend.js';
import { fit } from './line_name.js';
import { extent, fixed, listOf, shown } from './number.js';
import { inAddress, putInAddress } from './address.js';
import { unpackedRecordings } from './packed_columns.js';
import { spectrumCard } from './spectrum_card.js';
import { onPlayhead, playheadLine, put } from './playhead.js';
import { timeStrip } from './time_strip.js';
import { tools } from './tools.js';

/** Units as a chassis engineer reads them: [factor, unit]. */
const shownUnits = { m: [1000, 'mm'], 'm/s': [1000, 'mm/s'] };

/** Factor and name of a unit as it is shown. */
export const readable = (unit) => shownUnits[unit] ?? [1, unit.replace('^2', '\u00b2').replaceAll('*', '\u00b7')];

/** The channels of a recording: columns NAME_measured and NAME_modelled. */
export function channelsOf(recording) {
  const channels = new Map();
  for (const column of recording.columns) {
    const [, name, kind] = /^(.*)_(measured|modelled)$/.exec(column.name) ?? [];
    if (name == null) continue;
    const [factor, unit] = readable(column.unit);
    if (!channels.has(name)) channels.set(name, { name, unit });
    channels.get(name)[kind] = column.values.map((value) => (value == null ? null : factor * value));
  }
  return [...channels.values()].map(({ modelled, ...channel }) => ({ ...channel, lines: [{ label: fit, colour: 'model', values: modelled }] }));
}

/** A chart of a channel: `measured` and `lines` (label, colour, values) over time; of one line its residual below. */
export function card(recording, channel, time, misfit, sync) {
  const [place, below] = [el('div'), el('div')];
  const head = misfit?.nmse_percent == null ? '' : `NMSE ${shown(misfit.nmse_percent, 3)} %`;
  const reading = el('span', { class: 'reading' });
  const title = el('h3', {}, el('span', {}, el('code', {}, channel.name), channel.unit && channel.unit !== '1' ? `, ${channel.unit}` : ''), el('span', {}, head), reading);
  const box = el('div', { class: 'chart', 'data-channel': channel.name }, title, place, below);
  const none = Array.from(time, () => null);
  const data = [time, channel.measured ?? none, ...channel.lines.map((line) => line.values ?? none)];
  const cursor = { y: false, sync: { key: sync.key }, drag: { x: true, y: false } };
  const hooks = {
    setCursor: [
      (u) => {
        const i = u.cursor.idx;
        reading.textContent = i == null ? '' : `${fixed(time[i], 3)} s: model ${data.slice(2).map((values) => shown(values[i], 4)).join(' / ')}${channel.measured ? `; measured ${shown(data[1][i], 4)}` : ''}`;
      },
    ],
  };
  const draw = () => {
    const hasStrip = channel.lines.length === 1 && channel.measured && channel.lines[0].values;
    const state = chart(
      place,
      hasStrip ? 166 : 190,
      () => ({
        scales: { x: { time: false }, y: { range: (u, low, high) => (low < high ? [low - 0.06 * (high - low), high + 0.06 * (high - low)] : [low - 1, low + 1]) } },
        axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis()],
        series: [{}, curve('measured', channel.ink ?? 'measured', { width: channel.ink ? 4 : 2.2 }), ...channel.lines.map(({ label, colour, dash, width }) => curve(label, colour, { dash, width: width ?? 1 }))],
        cursor,
        plugins: [playheadLine(recording)],
        hooks,
      }),
      data,
      { name: `${channel.name} of ${recording} over time`, unit: channel.unit, x: ['time', 's'] },
    );
    const strip = hasStrip ? timeStrip(below, { ...channel, time, line: channel.lines[0] }, { cursor, hooks }) : null;
    const states = [state, strip].filter((one) => one);
    title.append(tools(box, `${recording} ${channel.name}`, states));
    return states;
  };
  return { box, draw };
}

/** The stretch of time, an eighth or at most 2 s, about the largest measured, or else modelled, value over its own rms. */
export function busiest(time, channels) {
  let best = [0, 0];
  for (const { measured, lines } of channels) {
    const values = measured ?? lines?.[0].values;
    if (!values) continue;
    const rms = Math.sqrt(values.reduce((sum, value) => sum + (value ?? 0) ** 2, 0) / values.length) || 1;
    values.forEach((value, i) => {
      if (Math.abs(value ?? 0) / rms > best[0]) best = [Math.abs(value) / rms, i];
    });
  }
  const [from, to] = extent(time);
  const span = Math.min(2, (to - from) / 8);
  const begin = Math.min(Math.max(from, time[best[1]] - span / 2), to - span);
  return [begin, begin + span];
}

/** Measured and modelled time histories of one recording; dragging zooms all of them. */
export async function drawHistories(place, data) {
  const unseen = listOf(data.validation);
  const recordings = [...data.histories, ...unseen];
  const isMeasured = recordings.some(({ columns }) => columns.some(({ name }) => name.endsWith('_measured')));
  const charts = el('div', { class: 'charts wide' });
  const note = el('p', { class: 'note' });
  const known = ['all', 'close', 'spectra'];
  let part = known.includes(inAddress('stretch')) ? inAddress('stretch') : 'all';
  let shownName = null;
  let show = () => {};
  let follow = () => {};
  const redraw = async (name) => {
    shownName = name;
    const packed = recordings.find((candidate) => candidate.recording === name);
    const [recording] = await unpackedRecordings([packed]);
    const time = recording.columns.find((column) => column.name === 'time').values;
    const sync = uPlot.sync(`history ${name}`);
    const misfit = (channel) =>
      listOf(unseen.includes(packed) ? data.result.validation : data.result.channels).find((entry) => entry?.recording === name && entry.name === channel.name);
    const channels = channelsOf(recording);
    // Of samples that are left out there is no spectrum.
    const isSpectra = part === 'spectra' && recording.shown_rows === recording.rows;
    const highest = 0.4 / ((time[time.length - 1] - time[0]) / (time.length - 1));
    const cards = channels.map((channel) => (isSpectra ? spectrumCard(name, channel, time, uPlot.sync(`spectra ${name}`), highest) : card(name, channel, time, misfit(channel), sync)));
    charts.replaceChildren(...cards.map(({ box }) => box));
    const states = cards.map(({ draw }) => draw());
    follow = () => !isSpectra && states.forEach(([{ plot }]) => put(plot, name));
    show = () => {
      if (isSpectra) return;
      const [min, max] = part === 'all' ? extent(time) : busiest(time, channels);
      for (const { plot } of states.flat()) plot.setScale('x', { min, max });
    };
    show();
    const { rows, shown_rows: drawn } = recording;
    const thinned = drawn < rows ? `${drawn} of ${rows} samples are shown, the extremes of each interval.` : `All ${rows} samples.`;
    const use = !isMeasured ? 'simulated' : unseen.includes(packed) ? 'validation, not fitted' : 'fitted';
    const spectra = `Power spectra over Hz, by windows that overlap by half${isMeasured ? ', dashed that of the difference; below them the coherence of model and measurement' : ''}`;
    const history = `Over time in s${isMeasured ? '; below each chart what the model differs by' : ''}`;
    note.textContent = `${recording.recording}: ${use}. ${isSpectra ? spectra : history}. Drag to zoom all charts, double-click to reset. ${thinned}${part === 'spectra' && !isSpectra ? ' There are no spectra of a part.' : ''}`;
  };
  const names = recordings.map((recording) => recording.recording);
  const first = names.includes(inAddress('history')) ? inAddress('history') : names[0];
  place.append(
    el(
      'div',
      { class: 'controls' },
      names.length > 1
        ? choice('recording', recordings.map((one) => [one.recording, unseen.includes(one) ? `${one.recording}, not fitted` : one.recording]), first, (name) => {
            putInAddress('history', name === names[0] ? null : name);
            redraw(name);
          })
        : null,
      choice('stretch', [['all', 'all'], ['close', 'busiest'], ['spectra', 'spectra']], part, (chosen) => {
        const isOther = (chosen === 'spectra') !== (part === 'spectra');
        part = chosen;
        putInAddress('stretch', chosen === 'all' ? null : chosen);
        if (isOther) redraw(shownName);
        else show();
      }),
    ),
  );
  place.append(legend(...(isMeasured ? [['line', 'measured', 'measured']] : []), ['line', 'model', unseen.length ? 'model' : fit]), note, charts);
  onPlayhead(() => follow());
  await redraw(first);
}
