import uPlot from 'uplot';
import { chart, curve, linearAxis } from './chart.js';
import { choice, el } from './dom.js';
import { legend } from './legend.js';
import { extent, listOf, shown } from './number.js';
import { colours } from './theme.js';

const column = (recording, name) => recording.columns.find((candidate) => candidate.name === name)?.values;

/** A chart of force over another column, displacement or velocity, times a factor. */
export function xy(place, title, recordings, across, factor, label) {
  const parts = recordings.map((recording) => ({
    x: column(recording, across)?.map((value) => (value == null ? null : factor * value)),
    measured: column(recording, 'measured_N'),
    lines: recording.lines ?? [{ colour: 'model', values: column(recording, 'modelled_N') }].filter((line) => line.values),
    ink: recording.ink,
  })).filter((part) => part.x && part.measured);
  if (!parts.length) return null;
  const box = el('div');
  const card = el('div', { class: 'chart' }, el('h3', {}, title, el('span', {}, `N over ${label}`)), box);
  const series = parts.flatMap((part) => [
    { points: [part.x, part.measured], colour: part.ink ?? 'measured', width: part.ink ? 4 : 1.4 },
    ...part.lines.map(({ colour, dash, width, values }) => ({ points: [part.x, values], colour, dash, width: width ?? 1.2 })),
  ]);
  const margin = (range) => { const [low, high] = range ?? [0, 1]; const m = 0.06 * (high - low || 1); return [low - m, high + m]; };
  const loop = (u, index) =>
    uPlot.orient(u, index, (s, xs, ys, scaleX, scaleY, toX, toY, left, top, width, height) => {
      const [x, y] = u.data[index];
      const { ctx } = u;
      ctx.save();
      ctx.beginPath();
      ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
      ctx.clip();
      ctx.beginPath();
      for (let i = 0; i < x.length; ++i) {
        if (x[i] == null || y[i] == null) continue;
        ctx.lineTo(toX(x[i], scaleX, width, left), toY(y[i], scaleY, height, top));
      }
      ctx.strokeStyle = colours()[series[index - 1].colour];
      ctx.lineWidth = series[index - 1].width * devicePixelRatio;
      ctx.lineJoin = 'round';
      ctx.setLineDash((series[index - 1].dash ?? []).map((length) => length * devicePixelRatio));
      ctx.stroke();
      ctx.restore();
      return null;
    });
  return {
    card,
    draw: () =>
      chart(
        box,
        280,
        () => ({
          mode: 2,
          scales: {
            x: { time: false, range: () => margin(extent(...parts.map((part) => part.x))) },
            y: { range: () => margin(extent(...parts.map((part) => part.measured), ...parts.flatMap((part) => part.lines.map((line) => line.values)))) },
          },
          axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis({ size: 54 })],
          series: [null, ...series.map(() => ({ paths: loop, facets: [{ scale: 'x', auto: true }, { scale: 'y', auto: true }] }))],
          cursor: { show: false },
        }),
        [null, ...series.map((one) => one.points)],
      ),
  };
}

/** Force over the time of one recording. */
export function overTime(place, recording) {
  const [time, measured] = ['time_s', 'measured_N'].map((name) => column(recording, name));
  const lines = recording.lines ?? [{ label: 'fit', colour: 'model', values: column(recording, 'modelled_N') ?? time?.map(() => null) }];
  if (!time || !measured) return null;
  const box = el('div');
  return {
    card: el('div', { class: 'chart whole' }, el('h3', {}, 'Force over time', el('span', {}, 'N over s')), box),
    draw: () =>
      chart(
        box,
        220,
        () => ({
          scales: { x: { time: false } },
          axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis({ size: 54 })],
          series: [{}, curve('measured', recording.ink ?? 'measured', { width: recording.ink ? 4 : 2.2 }), ...lines.map(({ label, colour, dash, width }) => curve(label, colour, { dash, width: width ?? 1 }))],
          cursor: { y: false },
        }),
        [time, measured, ...lines.map((line) => line.values)],
      ),
  };
}

/** How far the fit is off in a recording, and whether it has seen it. */
function misfitOf(result, name) {
  const find = (key) => listOf(result[key]).find((entry) => entry?.recording === name && entry.nmse_percent != null);
  const entry = find('channels') ?? find('validation');
  return entry ? `NMSE ${shown(entry.nmse_percent, 3)} %, ${find('channels') ? 'fitted' : 'not fitted'}` : '';
}

/** The recording of the largest force among the shorter half: the cycles of a sweep hide each other. */
export function liveliest(recordings) {
  const rows = recordings.map((recording) => recording.rows).sort((a, b) => a - b);
  const short = recordings.filter((recording) => recording.rows <= rows[rows.length >> 1]);
  const size = (recording) => Math.max(...(extent(column(recording, 'measured_N') ?? [0]) ?? [0]).map(Math.abs));
  return short.reduce((best, recording) => (size(recording) > size(best) ? recording : best)).recording;
}

/** Work diagrams (force over displacement) and characteristics (force over velocity) of one recording or all. */
export function drawBench(place, data) {
  const charts = el('div', { class: 'charts wide' });
  const misfit = el('output');
  const redraw = (name) => {
    misfit.textContent = misfitOf(data.result, name);
    const chosen = data.bench.filter((recording) => name === '' || recording.recording === name);
    const parts = [
      xy(charts, 'Work diagram', chosen, 'displacement_m', 1000, 'mm'),
      xy(charts, 'Characteristic', chosen, 'speed_mps', 1, 'm/s'),
      chosen.length === 1 ? overTime(charts, chosen[0]) : null,
    ].filter((part) => part);
    charts.replaceChildren(...parts.map(({ card }) => card));
    for (const { draw } of parts) draw();
  };
  const names = data.bench.map((recording) => recording.recording);
  // Of some, all at once say most; many hide each other.
  const first = names.length > 3 || names.length === 1 ? liveliest(data.bench) : '';
  if (names.length > 1) {
    const select = el('select', { 'aria-label': 'recording', onchange: () => redraw(select.value) }, ...names.map((name) => el('option', { value: name }, name)), el('option', { value: '' }, 'all recordings'));
    select.value = first;
    place.append(el('div', { class: 'controls' }, el('label', {}, 'recording', select), misfit));
  }
  place.append(legend(['line', 'measured', 'measured'], ['line', 'model', 'fit']), charts);
  redraw(first);
  const rows = data.bench.reduce((sum, recording) => sum + recording.rows, 0);
  const shownRows = data.bench.reduce((sum, recording) => sum + recording.shown_rows, 0);
  if (shownRows < rows) place.append(el('p', { class: 'note' }, `${shown(shownRows, 7)} of ${shown(rows, 7)} samples are shown.`));
}
