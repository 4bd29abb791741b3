import uPlot from 'uplot';
import { colours, isPrinting, onTheme } from './theme.js';
import { vectorOf } from './vector.js';
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
export function linearAxis({ scale = 'y', side = 3, steps = [], size = axisWidth, grid = true, colour, room: least = 30 } = {}) {
  return axis({
    scale,
    side,
    size,
    ...(colour ? { stroke: colours()[colour] } : {}),
    ...(grid ? {} : { grid: { show: false } }),
    splits: (u) => {
      const { min, max } = u.scales[scale];
      const room = side % 2 ? u.height : u.width;
      const count = Math.max(2, room / (side % 2 ? least : 80));
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

/** A band from low to high over all of x, with a line in its middle. */
export function band(low, high) {
  return {
    hooks: {
      drawClear: (u) => {
        const { left, width } = u.bbox;
        const [top, bottom, middle] = [high, low, (low + high) / 2].map((value) => u.valToPos(value, 'y', true));
        u.ctx.save();
        u.ctx.fillStyle = colours().measured;
        u.ctx.globalAlpha = 0.16;
        u.ctx.fillRect(left, top, width, bottom - top);
        u.ctx.globalAlpha = 0.6;
        u.ctx.fillRect(left, middle - 0.5, width, 1);
        u.ctx.restore();
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
  isDots: true,
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

/** Of each series that has a name what it is at a place of x. */
function saidOf(u, i) {
  return u.series
    .slice(1)
    .map(({ label, show }, k) => (show && label ? `${label} ${shown(u.data[k + 1][i], 4)}` : ''))
    .filter((part) => part)
    .join(', ');
}

/** Arrows lead the cursor over x, and what stands there is said. */
function readByKeys(u, name) {
  const { over } = u;
  const last = u.data[0].length - 1;
  const go = (i) => {
    u.setCursor({ left: u.valToPos(u.data[0][i], 'x'), top: 0 });
    over.setAttribute('aria-valuenow', u.data[0][i]);
    over.setAttribute('aria-valuetext', `${shown(u.data[0][i], 4)}: ${saidOf(u, i)}`);
  };
  const [least, greatest] = [u.data[0][0] ?? 0, u.data[0][last] ?? 0];
  for (const [key, value] of Object.entries({ role: 'slider', 'aria-label': name, 'aria-valuemin': least, 'aria-valuemax': greatest, 'aria-valuenow': least, 'aria-valuetext': 'arrow keys read the chart' })) over.setAttribute(key, value);
  over.tabIndex = 0;
  over.addEventListener('keydown', (event) => {
    const { key, shiftKey } = event;
    const step = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 }[key];
    const at = u.cursor.idx ?? -1;
    const to = key === 'Home' ? 0 : key === 'End' ? last : step ? at + step * (shiftKey ? 10 : 1) : null;
    if (to == null) return;
    event.preventDefault();
    go(Math.min(last, Math.max(0, to)));
  });
}

/** A chart that has no cursor is a picture with a name. */
function nameOnly({ over }, name) {
  over.setAttribute('role', 'img');
  over.setAttribute('aria-label', name);
}

const stateOf = new WeakMap();

/** What is drawn in a place or below it. */
export const chartsIn = (place) => [place, ...place.querySelectorAll('div')].map((one) => stateOf.get(one)).filter((state) => state);

/**
 * A chart as wide as its place. `options`: of uPlot, made anew by a function, for axes take the page's colours.
 * `about`: {name, unit, x: [name, unit]}, what its ordinate is, and its abscissa. Redrawn when the theme changes; on paper drawn as vectors.
 */
export function chart(place, height, options, data, about) {
  const width = () => Math.max(160, Math.floor(place.clientWidth));
  const make = (parent) => {
    const { cursor, ...rest } = options();
    const all = { width: width(), height: state.height, legend: { show: false }, padding: [6, 10, 0, 0], cursor: { ...cursor, bind: { mousemove: mouseMove } }, ...rest };
    return new uPlot(all, state.plot?.data ?? data, parent);
  };
  const state = {
    height,
    about,
    plot: null,
    /** As SVG, as far zoomed as it is. */
    vector: () => {
      const { min, max } = state.plot.scales.x;
      return vectorOf(() => {
        const plot = make(document.createElement('div'));
        if (plot.mode === 1 && min != null) plot.setScale('x', { min, max });
        return plot;
      });
    },
    resize: (to) => {
      state.height = to;
      state.plot.setSize({ width: width(), height: to });
    },
  };
  const begin = () => {
    state.plot = make(place);
    if (about) (state.plot.mode === 1 && state.plot.cursor.show !== false ? readByKeys : nameOnly)(state.plot, about.name);
  };
  const onPaper = () => {
    if (!isPrinting()) return;
    const drawn = state.vector();
    drawn.setAttribute('class', 'vector');
    state.plot.root.style.display = 'none';
    place.append(drawn);
  };
  begin();
  onPaper();
  stateOf.set(place, state);
  onTheme(() => {
    if (!place.isConnected) return;
    const { min, max } = state.plot.scales.x;
    state.plot.destroy();
    place.querySelector('.vector')?.remove();
    begin();
    // As far zoomed as it was.
    if (state.plot.mode === 1) state.plot.setScale('x', { min, max });
    onPaper();
  });
  new ResizeObserver(() => {
    if (state.plot.width !== width()) state.plot.setSize({ width: width(), height: state.height });
  }).observe(place);
  return state;
}
