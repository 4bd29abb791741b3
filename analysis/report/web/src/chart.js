import uPlot from 'uplot';
import { colours, onTheme } from './theme.js';
import { decimalsOf, fixed, logTicks, multiples, niceStep, shown } from './number.js';

const font = '11px system-ui, -apple-system, "Segoe UI", Roboto, "Liberation Sans", Arial, sans-serif';
const axisWidth = 46;

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
    splits: (u) => logTicks(u.scales.x.min, u.scales.x.max),
    filter: (u, splits) => splits,
    values: (u, splits) => (labelled ? thinned(u, splits, 'x', 26) : splits.map(() => '')),
  });
}

/** Labels at least so many pixels apart. */
function thinned(u, splits, scale, room) {
  const at = splits.map((value) => u.valToPos(value, scale));
  const digits = splits.length > 1 ? Math.max(3, 1 + Math.floor(Math.log10(splits[0]) - Math.log10(splits[1] - splits[0]) + 1)) : 3;
  let last = Infinity;
  return splits.map((value, i) => {
    if (Math.abs(at[i] - last) < room) return '';
    last = at[i];
    return shown(value, digits);
  });
}

/** A linear axis with a grid at the first of `steps` that leaves room, or at 1, 2, 5 times a power of ten. */
export function linearAxis({ scale = 'y', side = 3, steps = [], size = axisWidth, grid = true, colour } = {}) {
  return axis({
    scale,
    side,
    size,
    ...(colour ? { stroke: colours()[colour] } : {}),
    ...(grid ? {} : { grid: { show: false } }),
    splits: (u) => {
      const { min, max } = u.scales[scale];
      const room = side % 2 ? u.height : u.width;
      const count = Math.max(2, room / (side % 2 ? 30 : 80));
      const step = steps.find((candidate) => (max - min) / candidate <= count) ?? niceStep(max - min, count);
      return multiples(min, max, step);
    },
    values: (u, splits) => {
      const decimals = decimalsOf(splits.length > 1 ? splits[1] - splits[0] : 1);
      return splits.map((value) => (decimals > 6 ? shown(value, 3) : fixed(value, decimals)));
    },
  });
}

/** A quantity over decades, upwards. */
export function logAxis(colour) {
  return axis({
    size: axisWidth + 18,
    stroke: colours()[colour],
    splits: (u) => logTicks(u.scales.y.min, u.scales.y.max),
    filter: (u, splits) => splits,
    values: (u, splits) => thinned(u, splits, 'y', 15),
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

/** An area between low and high over x, behind the curves. */
export function area(low, high, colour, alpha) {
  return {
    hooks: {
      drawClear: (u) => {
        const { ctx, bbox } = u;
        ctx.save();
        ctx.beginPath();
        ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
        ctx.clip();
        ctx.fillStyle = colours()[colour];
        ctx.globalAlpha = alpha;
        const at = u.data[0].flatMap((x, i) => (low[i] == null || high[i] == null ? [] : [i]));
        ctx.beginPath();
        for (const i of at) ctx.lineTo(u.valToPos(u.data[0][i], 'x', true), u.valToPos(high[i], 'y', true));
        for (const i of at.reverse()) ctx.lineTo(u.valToPos(u.data[0][i], 'x', true), u.valToPos(low[i], 'y', true));
        ctx.fill();
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

/** Where the chart is now: it may have been scrolled since the last event, which reports that later. */
const mouseMove = (u, target, move) => (event) => {
  if (event.target !== target) return;
  u.syncRect(true);
  move(event);
};

/**
 * A chart as wide as its place. `options`: of uPlot, made anew by a function, for axes take the page's colours.
 * Redrawn when the theme changes.
 */
export function chart(place, height, options, data) {
  const width = () => Math.max(160, Math.floor(place.clientWidth));
  const make = () => {
    const { cursor, ...rest } = options();
    const all = { width: width(), height, legend: { show: false }, padding: [6, 10, 0, 0], cursor: { ...cursor, bind: { mousemove: mouseMove } }, ...rest };
    return new uPlot(all, data, place);
  };
  const state = { plot: make() };
  onTheme(() => {
    const { min, max } = state.plot.scales.x;
    state.plot.destroy();
    state.plot = make();
    // As far zoomed as it was.
    if (state.plot.mode === 1) state.plot.setScale('x', { min, max });
  });
  new ResizeObserver(() => {
    if (state.plot.width !== width()) state.plot.setSize({ width: width(), height });
  }).observe(place);
  return state;
}
