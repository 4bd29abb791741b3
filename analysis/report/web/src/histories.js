import uPlot from 'uplot';
import { chart, curve, linearAxis } from './chart.js';
import { choice, el } from './dom.js';
import { legend } from './legend.js';
import { extent, fixed, shown } from './number.js';

/** The channels of a recording: columns "NAME measured" and "NAME modelled". */
export function channelsOf(recording) {
  const columns = new Map(recording.columns.map((column) => [column.name, column.values]));
  const names = recording.columns
    .map((column) => /^(.*) (measured|modelled)$/.exec(column.name)?.[1])
    .filter((name) => name != null);
  return [...new Set(names)].map((name) => ({ name, measured: columns.get(`${name} measured`), modelled: columns.get(`${name} modelled`) }));
}

function card(recording, channel, time, misfit, sync) {
  const reading = el('div', { class: 'reading' });
  const place = el('div');
  const head = misfit?.nmse_percent == null ? '' : `NMSE ${shown(misfit.nmse_percent, 3)} %`;
  const unit = recording.units?.[channel.name];
  const box = el(
    'div',
    { class: 'chart', 'data-channel': channel.name },
    el('h3', {}, el('span', {}, el('code', {}, channel.name), unit ? `, ${unit}` : ''), el('span', {}, head)),
    place,
    reading,
  );
  const none = time.map(() => null);
  const data = [time, channel.measured ?? none, channel.modelled ?? none];
  const draw = () =>
    chart(
      place,
      190,
      () => ({
        scales: { x: { time: false }, y: { range: (u, low, high) => (low < high ? [low - 0.06 * (high - low), high + 0.06 * (high - low)] : [low - 1, low + 1]) } },
        axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis()],
        series: [{}, curve('measured', 'measured', { width: 1.4 }), curve('fit', 'model', { width: 1.2 })],
        cursor: { y: false, sync: { key: sync.key }, drag: { x: true, y: false } },
        hooks: {
          setCursor: [
            (u) => {
              const i = u.cursor.idx;
              reading.textContent = i == null ? '' : `${fixed(time[i], 3)} s: fit ${shown(data[2][i], 4)} for ${shown(data[1][i], 4)}`;
            },
          ],
        },
      }),
      data,
    );
  return { box, draw };
}

/** Measured and modelled time histories of one recording; dragging zooms all of them. */
export function drawHistories(place, data) {
  const recordings = data.histories;
  const charts = el('div', { class: 'charts wide' });
  const note = el('p', { class: 'note' });
  const redraw = (name) => {
    const recording = recordings.find((candidate) => candidate.recording === name);
    const time = recording.columns[0].values;
    const sync = uPlot.sync(`history ${name}`);
    const misfit = (channel) =>
      (data.result.channels ?? []).find((entry) => entry.recording === name && entry.name === channel.name);
    const cards = channelsOf(recording).map((channel) => card(recording, channel, time, misfit(channel), sync));
    charts.replaceChildren(...cards.map(({ box }) => box));
    for (const { draw } of cards) draw();
    const thinned =
      recording.shown_rows < recording.rows
        ? ` ${recording.shown_rows} of ${recording.rows} samples are shown, the extremes of each stretch.`
        : '';
    note.textContent = `Over time in s. Drag to zoom all, double click to go back.${thinned}`;
  };
  const names = recordings.map((recording) => recording.recording);
  if (names.length > 1) place.append(el('div', { class: 'controls' }, choice('recording', names.map((name) => [name, name]), names[0], redraw)));
  place.append(legend(['line', 'measured', 'measured'], ['line', 'model', 'fit']), note, charts);
  redraw(names[0]);
}
