import uPlot from 'uplot';
import { chart, curve, linearAxis } from './chart.js';
import { choice, el } from './dom.js';
import { drawEquivalents } from './damper_map.js';
import { legend } from './legend.js';
import { fit } from './line_name.js';
import { extent, listOf, shown } from './number.js';
import { unpackedRecordings } from './packed_columns.js';
import { inAddress, putInAddress } from './address.js';
import { timeStrip } from './time_strip.js';
import { colours } from './theme.js';
import { tools } from './tools.js';

const column = (recording, name) => recording.columns.find((candidate) => candidate.name === name)?.values;

/** The largest and least force of each cycle of the displacement, with the speed there: {x, y}. */
export function peaksOf(displacement, across, force) {
  const [x, y] = [[], []];
  let from = null;
  const add = (to) => {
    let [low, high] = [from, from];
    for (let i = from; i < to; ++i) {
      if (force[i] < force[low]) low = i;
      if (force[i] > force[high]) high = i;
    }
    for (const i of [low, high]) {
      x.push(across[i]);
      y.push(force[i]);
    }
  };
  const middle = displacement.reduce((sum, value) => sum + (value ?? 0), 0) / displacement.length;
  for (let i = 1; i < displacement.length; ++i) {
    // A cycle begins where the displacement passes its middle upwards.
    if (!(displacement[i - 1] < middle && displacement[i] >= middle)) continue;
    if (from != null && i - from > 3) add(i);
    from = i;
  }
  return { x, y };
}

/** A chart of force over another column, displacement or velocity, times a factor. */
export function xy(place, title, recordings, across, factor, label) {
  const parts = recordings.map((recording) => ({
    x: column(recording, across)?.map((value) => (value == null ? null : factor * value)),
    measured: column(recording, 'measured_N'),
    lines: recording.lines ?? [{ colour: 'model', values: column(recording, 'modelled_N') }].filter((line) => line.values),
    ink: recording.ink,
    name: recording.recording,
    displacement: column(recording, 'displacement_m'),
  })).filter((part) => part.x && part.measured);
  if (!parts.length) return null;
  const box = el('div');
  const head = el('h3', {}, title, el('span', {}, `N over ${label}`));
  const card = el('div', { class: 'chart' }, head, box);
  const series = parts.flatMap((part) => [
    { label: parts.length > 1 ? `measured ${part.name}` : 'measured', points: [part.x, part.measured], colour: part.ink ?? 'measured', width: part.ink ? 4 : 1.4 },
    ...part.lines.map(({ label, colour, dash, width, values }) => ({ label: `${label ?? fit}${parts.length > 1 ? ` ${part.name}` : ''}`, points: [part.x, values], colour, dash, width: width ?? 1.2 })),
  ]);
  // Over speed the peaks of the cycles are what damper sheets list.
  const peaks = across === 'speed_mps' ? parts.filter((part) => part.displacement && !part.ink).map((part) => peaksOf(part.displacement, part.x, part.measured)) : [];
  const peakMarks = {
    hooks: {
      draw: (u) => {
        const { ctx } = u;
        ctx.fillStyle = colours().measured;
        for (const { x, y } of peaks)
          x.forEach((at, i) => {
            ctx.beginPath();
            ctx.arc(u.valToPos(at, 'x', true), u.valToPos(y[i], 'y', true), 3 * devicePixelRatio, 0, 2 * Math.PI);
            ctx.fill();
          });
      },
    },
  };
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
    draw: () => {
      const state = chart(
        box,
        280,
        () => ({
          mode: 2,
          scales: {
            x: { time: false, range: () => margin(extent(...parts.map((part) => part.x))) },
            y: { range: () => margin(extent(...parts.map((part) => part.measured), ...parts.flatMap((part) => part.lines.map((line) => line.values)))) },
          },
          axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis({ size: 54 })],
          plugins: [peakMarks],
          series: [null, ...series.map(({ label, colour, dash }) => ({ label, stroke: () => colours()[colour], dash, paths: loop, facets: [{ scale: 'x', auto: true }, { scale: 'y', auto: true }] }))],
          cursor: { show: false },
        }),
        [null, ...series.map((one) => one.points)],
        { name: `force over ${across === 'speed_mps' ? 'speed' : 'displacement'}`, unit: 'N', x: [across === 'speed_mps' ? 'speed' : 'displacement', label] },
      );
      head.append(tools(card, `${title} ${parts.map(({ name }) => name).join(' ')}`.slice(0, 80), [state]));
    },
  };
}

/** Force over the time of one recording. */
export function overTime(place, recording) {
  const [time, measured] = ['time_s', 'measured_N'].map((name) => column(recording, name));
  const lines = recording.lines ?? [{ label: fit, colour: 'model', values: column(recording, 'modelled_N') ?? time?.map(() => null) }];
  if (!time || !measured) return null;
  const [box, below] = [el('div'), el('div')];
  const head = el('h3', {}, 'Force over time', el('span', {}, 'N over s'));
  const card = el('div', { class: 'chart whole' }, head, box, below);
  const draw = () => {
    const sync = uPlot.sync(`force ${recording.recording}`);
    const cursor = { y: false, sync: { key: sync.key }, drag: { x: true, y: false } };
    const state = chart(
      box,
      220,
      () => ({
        scales: { x: { time: false } },
        axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis({ size: 54 })],
        series: [{}, curve('measured', recording.ink ?? 'measured', { width: recording.ink ? 4 : 2.2 }), ...lines.map(({ label, colour, dash, width }) => curve(label, colour, { dash, width: width ?? 1 }))],
        cursor,
      }),
      [time, measured, ...lines.map((line) => line.values)],
      { name: `force of ${recording.recording} over time`, unit: 'N', x: ['time', 's'] },
    );
    const strip = lines.length === 1 ? timeStrip(below, { name: 'force', unit: 'N', time, measured, line: lines[0], half: column(recording, 'half_95_measured_N') }, { cursor, size: 54 }) : null;
    head.append(tools(card, `force ${recording.recording}`, [state, strip].filter((one) => one)));
  };
  return { card, draw };
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
export async function drawBench(place, data) {
  const charts = el('div', { class: 'charts wide' });
  const cycles = el('div');
  const misfit = el('output');
  const bench = await unpackedRecordings(data.bench);
  const redraw = (name) => {
    misfit.textContent = misfitOf(data.result, name);
    const chosen = bench.filter((recording) => name === '' || recording.recording === name);
    const parts = [
      xy(charts, 'Work diagram', chosen, 'displacement_m', 1000, 'mm'),
      xy(charts, 'Characteristic', chosen, 'speed_mps', 1, 'm/s'),
      chosen.length === 1 ? overTime(charts, chosen[0]) : null,
    ].filter((part) => part);
    charts.replaceChildren(...parts.map(({ card }) => card));
    for (const { draw } of parts) draw();
    drawEquivalents(cycles, data.equivalents, name, choose);
  };
  const names = bench.map((recording) => recording.recording);
  const select = el('select', { 'aria-label': 'recording', onchange: () => choose(select.value) }, ...names.map((name) => el('option', { value: name }, name)), el('option', { value: '' }, 'all recordings'));
  function choose(name) {
    select.value = name;
    putInAddress('bench', name || 'all');
    redraw(name);
  }
  // Of some, all at once say most; many hide each other.
  const wanted = inAddress('bench');
  const first = names.includes(wanted) ? wanted : wanted === 'all' ? '' : names.length > 3 || names.length === 1 ? liveliest(bench) : '';
  if (names.length > 1) {
    select.value = first;
    place.append(el('div', { class: 'controls' }, el('label', {}, 'recording', select), misfit));
  }
  place.append(legend(['line', 'measured', 'measured'], ['dot', 'measured', 'peaks of a cycle'], ['line', 'model', fit]), charts, cycles);
  redraw(first);
  const rows = bench.reduce((sum, recording) => sum + recording.rows, 0);
  const shownRows = bench.reduce((sum, recording) => sum + recording.shown_rows, 0);
  if (shownRows < rows) place.append(el('p', { class: 'note' }, `${shown(shownRows, 7)} of ${shown(rows, 7)} samples are shown.`));
}
