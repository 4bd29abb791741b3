import uPlot from 'uplot';
import { colours, onTheme } from './theme.js';
import { fixed, multiples, niceStep, shown } from './number.js';

const font = '11px system-ui, -apple-system, "Segoe UI", Roboto, "Liberation Sans", Arial, sans-serif';
const axisWidth = 46;

/** 0.5, 1, 2, 5, 10 ... within a range. */
export function decades(low, high) {
  const list = [];
  for (let exponent = Math.floor(Math.log10(low)); exponent <= Math.ceil(Math.log10(high)); ++exponent)
    for (const factor of [1, 2, 5]) {
      const value = factor * 10 ** exponent;
      if (value >= low * 0.999 && value <= high * 1.001) list.push(value);
    }
  return list;
}

function axis(options) {
  const { line, muted } = colours();
  return {
    stroke: muted,
    font,
    grid: { stroke: line, width: 0.6 },
    ticks: { show: false },
    gap: 4,
    ...options,
  };
}

/** Frequency, logarithmic. `labelled`: whether numbers stand below it. */
export function frequencyAxis(labelled) {
  return axis({
    size: labelled ? 22 : 6,
    splits: (u) => decades(u.scales.x.min, u.scales.x.max),
    filter: (u, splits) => splits,
    values: (u, splits) => (labelled ? thinned(u, splits) : splits.map(() => '')),
  });
}

/** Labels with room between them; the last one names the unit. */
function thinned(u, splits) {
  const at = splits.map((value) => u.valToPos(value, 'x'));
  let last = -Infinity;
  return splits.map((value, i) => {
    if (at[i] - last < 26) return '';
    last = at[i];
    return shown(value, 3);
  });
}

/** A linear axis with a grid at the first of `steps` that leaves room, or at 1, 2, 5 times a power of ten. */
export function linearAxis({ scale = 'y', side = 3, steps = [], size = axisWidth, grid = true } = {}) {
  return axis({
    scale,
    side,
    size,
    ...(grid ? {} : { grid: { show: false } }),
    splits: (u) => {
      const { min, max } = u.scales[scale];
      const room = side % 2 ? u.height : u.width;
      const count = Math.max(2, room / (side % 2 ? 30 : 80));
      const step = steps.find((candidate) => (max - min) / candidate <= count) ?? niceStep(max - min, count);
      return multiples(min, max, step);
    },
    values: (u, splits) => {
      const gap = splits.length > 1 ? splits[1] - splits[0] : 1;
      const decimals = Math.max(0, -Math.floor(Math.log10(gap) + 1e-9));
      return splits.map((value) => (decimals > 6 ? shown(value, 3) : fixed(value, decimals)));
    },
  });
}

/** Powers of ten and, where they are few, 2 and 5 times them. */
export function logAxis() {
  return axis({
    size: axisWidth + 12,
    splits: (u) => {
      const { min, max } = u.scales.y;
      const all = decades(min, max);
      return max / min > 1e3 ? all.filter((value) => Math.abs(Math.log10(value) % 1) < 1e-9) : all;
    },
    filter: (u, splits) => splits,
    values: (u, splits) => splits.map((value) => shown(value, 3)),
  });
}

/** Shades what lies outside [low, high] of x. */
export function outside(low, high) {
  return {
    hooks: {
      drawClear: (u) => {
        const { left, top, width, height } = u.bbox;
        const from = Math.max(left, u.valToPos(low, 'x', true));
        const to = Math.min(left + width, u.valToPos(high, 'x', true));
        u.ctx.fillStyle = colours().band;
        u.ctx.fillRect(left, top, Math.max(0, from - left), height);
        u.ctx.fillRect(to, top, Math.max(0, left + width - to), height);
      },
    },
  };
}

/** Bars from low to high at each x, in the colour of the measured dots. */
export function errorBars(low, high, colour = 'measured') {
  return {
    hooks: {
      draw: (u) => {
        const { ctx, bbox } = u;
        ctx.save();
        ctx.beginPath();
        ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
        ctx.clip();
        ctx.strokeStyle = colours()[colour];
        ctx.lineWidth = devicePixelRatio;
        ctx.globalAlpha = 0.6;
        ctx.beginPath();
        u.data[0].forEach((x, i) => {
          if (low[i] == null || high[i] == null) return;
          const at = u.valToPos(x, 'x', true);
          ctx.moveTo(at, u.valToPos(low[i], 'y', true));
          ctx.lineTo(at, u.valToPos(high[i], 'y', true));
        });
        ctx.stroke();
        ctx.restore();
      },
    },
  };
}

export const dots = (label, colour = 'measured') => ({
  label,
  stroke: () => colours()[colour],
  paths: () => null,
  points: { show: true, size: 4.5, width: 0, fill: () => colours()[colour], stroke: () => colours()[colour] },
});

export const curve = (label, colour, options = {}) => ({
  label,
  stroke: () => colours()[colour],
  width: 1.6,
  points: { show: false },
  ...options,
});

/**
 * A chart as wide as its place. `options`: of uPlot, made anew by a function, for axes take the page's colours.
 * Redrawn when the theme changes.
 */
export function chart(place, height, options, data) {
  const width = () => Math.max(160, Math.floor(place.clientWidth));
  const make = () =>
    new uPlot({ width: width(), height, legend: { show: false }, padding: [6, 10, 0, 0], ...options() }, data, place);
  const state = { plot: make() };
  onTheme(() => {
    state.plot.destroy();
    state.plot = make();
  });
  new ResizeObserver(() => {
    if (state.plot.width !== width()) state.plot.setSize({ width: width(), height });
  }).observe(place);
  return state;
}
