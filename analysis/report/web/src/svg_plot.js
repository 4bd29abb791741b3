import { svg } from './dom.js';
import { logTicks, multiples, niceStep, shown } from './number.js';

const margin = { left: 58, right: 14, top: 10, bottom: 36 };

/** Places of values along an axis, and its marks. */
function scaleOf({ low, high, logarithmic }, from, to) {
  const share = logarithmic ? (value) => Math.log(value / low) / Math.log(high / low) : (value) => (value - low) / (high - low);
  return { at: (value) => from + share(value) * (to - from), ticks: logarithmic ? logTicks(low, high) : multiples(low, high, niceStep(high - low, Math.max(2, Math.abs(to - from) / 60))) };
}

/** A range around numbers with some room: {low, high, logarithmic}. */
export function rangeAround(values, { logarithmic = false, zero = false } = {}) {
  const known = values.filter((value) => Number.isFinite(value) && (!logarithmic || value > 0));
  let [low, high] = known.length ? [Math.min(...known), Math.max(...known)] : [1, 10];
  if (logarithmic) return { low: low / 1.15, high: high * 1.15, logarithmic };
  if (zero) [low, high] = [Math.min(0, low), Math.max(0, high)];
  const room = 0.06 * (high - low || Math.abs(high) || 1);
  return { low: zero && low === 0 ? 0 : low - room, high: high + room, logarithmic };
}

const styled = (element, style) => Object.assign(element, { style: Object.entries(style).map(([key, value]) => `${key}:${value}`).join(';') });

/** A cross of axes: `x`, `y`: ranges with a `label`. Gives the picture and where values stand in it. */
export function axesOf({ x, y, width, height, name }) {
  const [xs, ys] = [scaleOf(x, margin.left, width - margin.right), scaleOf(y, height - margin.bottom, margin.top)];
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, width, height, role: 'img', 'aria-label': name });
  const line = (x1, y1, x2, y2) => styled(svg('line', { x1, y1, x2, y2, 'stroke-width': 0.6 }), { stroke: 'var(--line)' });
  const text = (at, anchor, words) => svg('text', { x: at[0], y: at[1], 'font-size': 11, 'text-anchor': anchor, class: 'dim' }, words);
  let last = -Infinity;
  for (const value of xs.ticks) {
    const at = xs.at(value);
    picture.append(line(at, margin.top, at, height - margin.bottom));
    if (at - last < 30) continue;
    picture.append(text([at, height - margin.bottom + 14], 'middle', shown(value, 3)));
    last = at;
  }
  last = Infinity;
  for (const value of ys.ticks) {
    const at = ys.at(value);
    picture.append(line(margin.left, at, width - margin.right, at));
    if (last - at < 14) continue;
    picture.append(text([margin.left - 6, at + 4], 'end', shown(value, 3)));
    last = at;
  }
  picture.append(text([(margin.left + width - margin.right) / 2, height - 6], 'middle', x.label), text([margin.left, margin.top - 1], 'end', y.label));
  return { picture, at: (a, b) => [xs.at(a), ys.at(b)] };
}

/** A mark at a place: a dot of what is measured, a ring of what is modelled. */
export function mark([cx, cy], { colour, ring = false, radius = 3, words, onclick }) {
  const circle = styled(svg('circle', { cx, cy, r: radius, 'stroke-width': 1.5 }, words ? svg('title', {}, words) : null), ring ? { fill: 'none', stroke: colour } : { fill: colour });
  if (onclick) {
    circle.addEventListener('click', onclick);
    circle.style.cursor = 'pointer';
  }
  return circle;
}

export function path(points, { colour, width = 1.4, dash }) {
  const d = points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`).join('');
  return styled(svg('path', { d, fill: 'none', 'stroke-width': width, ...(dash ? { 'stroke-dasharray': dash } : {}) }), { stroke: colour });
}
