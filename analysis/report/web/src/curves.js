import uPlot from 'uplot';
import { chart, curve, linearAxis } from './chart.js';
import { el } from './dom.js';
import { legend } from './legend.js';
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

function card({ title, unit, least, lines }, x, sync, place) {
  const box = el('div');
  const reading = el('span', { class: 'reading' });
  const head = el('h3', {}, el('span', {}, title, unit ? `, ${unit}` : ''), el('span', {}, ''), reading);
  const frame = el('div', { class: 'chart' }, head, box);
  const read = (i) => (reading.textContent = i == null ? '' : `${shown(x.values[i], 4)} ${x.unit}: ${lines.map(({ values }) => shown(values[i], 4)).join(' / ')}`);
  const draw = () => {
    const state = chart(
      box,
      190,
      () => ({
        scales: { x: { time: false }, y: { range: (u) => rangeOf(lines, least ?? 0, u.series[0].idxs) } },
        axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis({ size: 54 })],
        series: [{}, ...lines.map(({ label }, i) => curve(label, runLine(i).colour, { dash: lines.length > 1 ? runLine(i).dash : undefined, width: lines.length > 1 ? runLine(i).width : 1.6 }))],
        cursor: { y: false, sync: { key: sync.key }, drag: { x: true, y: false } },
        hooks: { setCursor: [(u) => read(u.cursor.idx)] },
      }),
      [x.values, ...lines.map(({ values }) => values)],
      { name: title, unit, x: [x.name, x.unit] },
    );
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
  const cards = charts.map((one) => card(one, x, sync, group.title));
  // Lines of one name are alike in all charts where they stand in one place; a legend for each kind of chart.
  const keys = new Map(charts.filter(({ lines }) => lines.length > 1).map(({ lines }) => [lines.map(({ label }) => label).join(), lines]));
  place.append(
    ...[...keys.values()].map((lines) => legend(...lines.map(({ label }, i) => [runLine(i), runLine(i).colour, label]))),
    el('p', { class: 'note' }, `Over ${x.name} in ${x.unit}. Drag to zoom all charts, double-click to reset.`),
    el('div', { class: 'charts' }, ...cards.map(({ frame }) => frame)),
  );
  for (const { draw } of cards) draw();
}
