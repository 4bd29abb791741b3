import { area, band, chart, curve, linearAxis } from './chart.js';
import { extent } from './number.js';

/** Of a band of 95 %, in standard deviations. */
const reach = 1.96;

/** Root mean square of what model and measurement differ by in view, in the unit of the chart. */
function rangeOf(values, half, [first, last]) {
  const seen = values.slice(first, last + 1);
  const [low, high] = extent(seen, half ? half.slice(first, last + 1) : []) ?? [0, 1];
  const most = 1.08 * Math.max(Math.abs(low), Math.abs(high), 1e-12);
  return [-most, most];
}

/**
 * Model less measurement over time. `half`: half widths of the band of 95 % about each modelled value, where they are
 * known; `sd`: one standard deviation for all. The band is drawn to two standard deviations.
 */
export function timeStrip(place, { name, unit, time, measured, line, half, sd }, { cursor, size, xScale = { time: false }, plugins = [], hooks = {} }) {
  if (!line.values || !measured) return null;
  const values = Array.from(time, (_, i) => (line.values[i] == null || measured[i] == null ? null : line.values[i] - measured[i]));
  const wide = half?.some((value) => value > 0) ? Array.from(half, (value) => (value == null ? null : (2 / reach) * value)) : null;
  const bands = wide ? [area(wide.map((value) => (value == null ? null : -value)), wide, 'measured', 0.2)] : sd > 0 ? [band(-2 * sd, 2 * sd)] : [];
  return chart(
    place,
    88,
    () => ({
      scales: { x: xScale, y: { range: (u) => rangeOf(values, wide ?? (sd > 0 ? [2 * sd] : null), u.series[0].idxs) } },
      axes: [linearAxis({ scale: 'x', side: 2, size: 24 }), linearAxis({ ...(size ? { size } : {}) })],
      series: [{}, curve(`${line.label} less measured`, line.colour, { width: 1 })],
      cursor,
      plugins: [...bands, ...plugins],
      hooks,
    }),
    [time, values],
    { name: `residual of ${name} over time`, unit, x: ['time', 's'] },
  );
}
