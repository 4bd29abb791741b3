import uPlot from 'uplot';
import { chart, curve, frequencyAxis, linearAxis, logAxis } from './chart.js';
import { el } from './dom.js';
import { legend } from './legend.js';
import { onAnswer } from './live/answers.js';
import { extent, shown } from './number.js';
import { valuesOf } from './packed_columns.js';
import { runLine } from './theme.js';
import { tools } from './tools.js';

/** A range with some room, at least this wide: what changes by less is a line in the middle. */
function rangeOf(lines, least, [first, last]) {
  const seen = (i) => i >= first && i <= last;
  const [low, high] = extent(...lines.map(({ values }) => values.filter((_, i) => seen(i)))) ?? [0, 1];
  const room = Math.max(0.06 * (high - low), (least - (high - low)) / 2) || 1;
  return [low - room, high + room];
}

/** Of the largest density what is still drawn. */
const decades = 1e-4;

/** Over decades: those below the largest. */
function decadesOf(lists) {
  const [, largest] = extent(...lists) ?? [0, 1];
  // Nothing but zeros, of a point that does not move this way.
  const top = largest > 0 ? largest : 1;
  return [top * decades, 2 * top];
}

/** Values at other places, on lines through their logarithms; null beyond their ends. */
export function throughLogarithms(x, y, places) {
  let i = 0;
  return Array.from(places, (at) => {
    while (i + 2 < x.length && x[i + 1] < at) ++i;
    if (!(at >= x[0] && at <= x[x.length - 1])) return null;
    const share = Math.log(at / x[i]) / Math.log(x[i + 1] / x[i]);
    const value = y[i] ** (1 - share) * y[i + 1] ** share;
    return Number.isFinite(value) ? value : null;
  });
}

/** `isSameRide`: whether an answer of the sliders is of the ride that the charts show. */
function card({ title, unit, least, lines, logarithmic, ride_point: point }, x, sync, place, isSameRide) {
  const follows = point != null;
  const box = el('div');
  const reading = el('span', { class: 'reading' });
  const head = el('h3', {}, el('span', {}, title, unit ? `, ${unit}` : ''), el('span', {}, ''), reading);
  const frame = el('div', { class: 'chart' }, head, box);
  const read = (i) => (reading.textContent = i == null ? '' : `${shown(x.values[i], 4)} ${x.unit}: ${lines.map(({ values }) => shown(values[i], 4)).join(' / ')}`);
  const none = Array.from(x.values, () => null);
  const draw = () => {
    const state = chart(
      box,
      190,
      () => ({
        scales: {
          x: { time: false, ...(x.logarithmic ? { distr: 3, range: (u, min, max) => [min, max] } : {}) },
          y: logarithmic ? { distr: 3, range: (u) => decadesOf(u.data.slice(1)) } : { range: (u) => rangeOf(lines, least ?? 0, u.series[0].idxs) },
        },
        axes: [x.logarithmic ? frequencyAxis(true) : linearAxis({ scale: 'x', side: 2, size: 24 }), logarithmic ? logAxis('muted') : linearAxis({ size: 54 })],
        series: [{}, ...lines.map(({ label }, i) => curve(label, runLine(i).colour, { dash: lines.length > 1 ? runLine(i).dash : undefined, width: lines.length > 1 ? runLine(i).width : 1.6 })), ...(follows ? [curve('what if', 'whatif', { width: 1.8 })] : [])],
        cursor: { y: false, sync: { key: sync.key }, drag: { x: true, y: false } },
        hooks: { setCursor: [(u) => read(u.cursor.idx)] },
      }),
      [x.values, ...lines.map(({ values }) => values), ...(follows ? [none] : [])],
      { name: title, unit, x: [x.name, x.unit] },
    );
    if (follows)
      onAnswer((answer) => {
        const ride = isSameRide(answer?.ride) ? answer.ride : null;
        if (answer && !answer.ride && !answer.rests) return;
        const { min, max } = state.plot.scales.x;
        state.plot.setData([x.values, ...lines.map(({ values }) => values), ride ? throughLogarithms(ride.frequency_Hz, ride.density[point], x.values) : none], false);
        state.plot.setScale('x', { min, max });
      });
    head.append(tools(frame, `${place} ${title}`, [state]));
  };
  return { frame, draw };
}

const withValues = async (column) => ({ ...column, values: await valuesOf(column) });

/** Charts of a group over one quantity `x`: each {title, unit, least, lines: [{label, values}]}. */
export async function drawCurves(place, data, name) {
  const group = data.curves?.[name];
  if (!group?.charts.length) return;
  const x = await withValues(group.x);
  const charts = await Promise.all(group.charts.map(async (one) => ({ ...one, lines: await Promise.all(one.lines.map(withValues)) })));
  const sync = uPlot.sync(`curves ${name}`);
  const isSameRide = (ride) => ride != null && ride.road === group.road && Math.abs(ride.speed / 3.6 / group.speed - 1) < 1e-5;
  const cards = charts.map((one) => card(one, x, sync, group.title, isSameRide));
  // Lines of one name are alike in all charts where they stand in one place; a legend for each kind of chart.
  const keys = new Map(charts.filter(({ lines }) => lines.length > 1).map((one) => [one.lines.map(({ label }) => label).join(), one]));
  place.append(
    ...[...keys.values()].map(({ lines, ride_point: point }) => legend(...lines.map(({ label }, i) => [runLine(i), runLine(i).colour, label]), ...(point != null && data.live ? [['line', 'whatif', 'what if']] : []))),
    el('p', { class: 'note' }, `Over ${x.name} in ${x.unit}. Drag to zoom all charts, double-click to reset.${group.road ? ' The sliders draw what if on the same road and at the same speed.' : ''}`),
    el('div', { class: 'charts' }, ...cards.map(({ frame }) => frame)),
  );
  for (const { draw } of cards) draw();
}
