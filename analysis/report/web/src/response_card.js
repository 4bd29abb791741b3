import { area, chart, curve, dots, errorBars, frequencyAxis, linearAxis, outside } from './chart.js';
import { el } from './dom.js';
import { fit } from './line_name.js';
import { decibel, extent, fixed, shown } from './number.js';
import { isWeighed, residualStrip } from './residual_strip.js';
import { tools } from './tools.js';

/** What the bars reach to, in standard deviations: 95 % of a normal distribution. */
const reach = 1.96;

/** Phases [deg] without jumps of a turn; nulls stay. */
export function unwrapped(phases) {
  let turns = 0;
  let last = null;
  return phases.map((phase) => {
    if (phase == null) return null;
    if (last != null) turns -= 360 * Math.round((phase + turns - last) / 360);
    last = phase + turns;
    return last;
  });
}

/** Each phase moved by whole turns to be nearest to its neighbour of `reference`. */
export function near(phases, reference) {
  return phases.map((phase, i) =>
    phase == null || reference[i] == null ? phase : phase - 360 * Math.round((phase - reference[i]) / 360),
  );
}

const orNone = (list, like) => (list && list.length ? list : like.map(() => null));

/** The series of a channel as they are drawn. */
function seriesOf(channel) {
  const gain = {
    measured: channel.gain_measured.map(decibel),
    lines: channel.lines.map((line) => ({ ...line, values: orNone(line.gain, channel.gain_measured).map(decibel) })),
  };
  const sd = orNone(channel.gain_sd, channel.gain_measured);
  gain.low = channel.gain_measured.map((value, i) => (sd[i] ? decibel(Math.max(value - reach * sd[i], value / 100)) : null));
  gain.high = channel.gain_measured.map((value, i) => (sd[i] ? decibel(value + reach * sd[i]) : null));
  const measured = unwrapped(orNone(channel.phase_measured, channel.gain_measured));
  // Of a car that was not measured its own phases lead.
  const leads = measured.some((value) => value != null) ? measured : unwrapped(orNone(channel.lines.find((line) => line.phase)?.phase, measured));
  const angle = orNone(channel.phase_sd, channel.gain_measured);
  const phase = {
    measured,
    lines: channel.lines.map((line) => ({ ...line, values: near(orNone(line.phase, measured), leads) })),
    leads,
    low: measured.map((value, i) => (angle[i] ? value - reach * angle[i] : null)),
    high: measured.map((value, i) => (angle[i] ? value + reach * angle[i] : null)),
  };
  const [modelled, turned] = [channel.gain_modelled, phase.lines.find(({ label }) => label === fit)?.values];
  gain.areas = (channel.gain_bands ?? []).map((half) => [
    modelled.map((value, i) => (half[i] == null ? null : decibel(Math.max(value - half[i], value / 100)))),
    modelled.map((value, i) => (half[i] == null ? null : decibel(value + half[i]))),
  ]);
  phase.areas = (channel.phase_bands ?? []).map((half) => [
    turned.map((value, i) => (half[i] == null || value == null ? null : value - half[i])),
    turned.map((value, i) => (half[i] == null || value == null ? null : value + half[i])),
  ]);
  return { x: channel.frequency_Hz, gain, phase, mean: meanOf(channel), ink: channel.ink };
}

/** The mean offset, of lengths in mm; null where none was measured. */
function meanOf(channel) {
  if (!channel.mean_measured) return null;
  const factor = channel.unit === 'm' ? 1000 : 1;
  const scaled = (list) => list.map((value) => (value == null ? null : factor * value));
  const none = channel.mean_measured.map(() => null);
  const lines = channel.lines.filter((line) => line.mean).map((line) => ({ ...line, values: scaled(line.mean) }));
  return { measured: scaled(channel.mean_measured), lines, low: none, high: none, factor, unit: factor === 1 ? channel.unit : 'mm' };
}

/** A range around what is measured and modelled in view, of the fitted rows where there are some, at least this wide. */
function rangeOf(part, least, fitted, [first, last]) {
  const lists = [part.measured, ...part.lines.filter(({ counts }) => counts !== false).map((line) => line.values)];
  const of = (isIn) => extent(...lists.map((list) => list.filter((_, i) => isIn(i))));
  const isSeen = (i) => i >= first && i <= last;
  const [low, high] = of((i) => isSeen(i) && fitted?.[i]) ?? of(isSeen) ?? of(() => true) ?? [0, 1];
  const margin = Math.max(0.06 * (high - low), (least - (high - low)) / 2);
  return [low - margin, high + margin];
}

/** Of frequency: whole, or the fitted band alone where that is wanted; what a reader zooms to is as it is. */
function xRangeOf(x, band) {
  const [low, high] = extent(x);
  const [from, to] = band ?? [low, high];
  const edge = (to / from) ** 0.025;
  return (u, min, max) => (min === low && max === high ? [from / edge, to * edge] : [min, max]);
}

function panel(place, height, series, part, { name, unit, steps, least, labelled, bands, sync, read, xRange }) {
  return chart(
    place,
    height,
    () => ({
      scales: {
        x: { time: false, distr: 3, range: xRange },
        y: { range: (u) => rangeOf(part, least, series.fitted, u.series[0].idxs) },
      },
      axes: [frequencyAxis(labelled), linearAxis({ steps })],
      series: [
        {},
        dots('measured', series.ink),
        ...part.lines.map(({ label, colour, dash, width }) => curve(label, colour, { dash, width: width ?? 1.6 })),
      ],
      cursor: {
        y: false,
        sync: { key: sync.key },
        points: { size: 6 },
        drag: { x: true, y: false },
      },
      plugins: [...bands.map((band) => outside(...band)), ...(part.areas ?? []).map(([from, to], i) => area(from, to, 'model', i ? 0.3 : 0.13)), errorBars(part.low, part.high, series.ink)],
      hooks: { setCursor: [(u) => read(u.cursor.idx)] },
    }),
    [series.x, part.measured, ...part.lines.map((line) => line.values)],
    { name, unit, x: ['frequency', 'Hz'] },
  );
}

/** Root mean square of what a line and measurement differ by, where they were fitted. */
function misfitOf({ gain, phase }, fitted, line) {
  // Of a recording kept for validation all counts.
  const inBand = fitted.some(Boolean) ? fitted : fitted.map(() => true);
  const rms = ({ measured, lines }) => {
    const modelled = lines[line].values;
    const errors = measured.map((value, i) => (inBand[i] && value != null && modelled[i] != null ? modelled[i] - value : null)).filter((error) => error != null);
    return errors.length ? Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length) : null;
  };
  const [dB, deg] = [rms(gain), rms(phase)];
  if (dB == null) return '';
  return `${fixed(dB, 2)} dB${deg == null ? '' : `, ${fixed(deg, 1)}\u00b0`} rms`;
}

/** The panels of a channel from top to bottom: their heights, series and axes. */
function panelsOf(channel, series) {
  const panels = [[128, series.gain, { of: 'gain', unit: 'dB', steps: [5, 10, 20, 40], least: 3 }]];
  if (series.phase.leads.some((value) => value != null)) panels.push([96, series.phase, { of: 'phase', unit: 'deg', steps: [10, 20, 45, 90, 180, 360], least: 20 }]);
  if (series.mean) panels.push([84, series.mean, { of: 'mean offset', unit: series.mean.unit, least: 1 }]);
  return panels;
}

/**
 * Charts of a channel with `lines`: label, colour, gain, phase and mean of each; without `read` the cursor passes it,
 * without `counts` so do the axes. `bands` [Hz]: what lies outside of each is shaded. `axes`: the band [Hz] that the
 * axes show, or null for all. With what weighs its residuals it has a strip of these.
 */
export function card(channel, bands, sync, axes = null) {
  // What axes go by: of all frequencies everything counts.
  const counts = axes ? channel.in_band : null;
  const series = { ...seriesOf(channel), fitted: counts };
  const place = el('div');
  const whatIf = channel.lines.findIndex(({ label }) => label === 'what if');
  const heading = el('span', {}, channel.in_band ? misfitOf(series, channel.in_band, channel.lines.findIndex(({ label }) => label === fit)) : '');
  const drawn = [];
  const isMeasured = channel.gain_measured.some((value) => value != null);
  const reading = el('span', { class: 'reading' });
  const title = el('h3', {}, el('code', {}, channel.name), heading, reading);
  const box = el('div', { class: 'chart', 'data-channel': channel.name }, title, place);
  const read = (i) => {
    if (i == null) reading.textContent = '';
    else {
      const parts = [[series.gain, ' dB', 1], [series.phase, '\u00b0', 0]];
      if (series.mean) parts.push([series.mean, ` ${series.mean.unit}`, 1]);
      // Short, since there is one line of room; the note says which is which.
      const pairs = parts.map(([part, unit, decimals]) => {
        const modelled = part.lines.filter((line) => line.read !== false).map((line) => fixed(line.values[i], decimals));
        const measured = isMeasured ? `/${fixed(part.measured[i], decimals)}` : '';
        return `${modelled.join(', ')}${measured}${unit}`;
      });
      reading.textContent = `${shown(series.x[i], 3)} Hz: ${pairs.join(', ')}`;
    }
  };
  const draw = () => {
    const panels = panelsOf(channel, series);
    const hasStrip = isWeighed(channel);
    const xRange = xRangeOf(series.x, axes);
    const add = () => place.appendChild(el('div'));
    panels.forEach(([height, part, { of, ...options }], i) => {
      const labelled = !hasStrip && i === panels.length - 1;
      const name = `${of} of ${channel.name} over frequency`;
      const state = panel(add(), height + (labelled ? 16 : 0), series, part, { steps: [], labelled, bands, sync, read, xRange, name, ...options });
      drawn.push({ state, data: () => [series.x, part.measured, ...part.lines.map((line) => line.values)] });
    });
    if (hasStrip) drawn.push(residualStrip(add(), channel, { height: 84, xRange, bands, sync, read, counts }));
    title.append(tools(box, channel.recording ? `${channel.recording} ${channel.name}` : channel.name, drawn.map(({ state }) => state)));
  };
  const show = (low, high) => drawn.forEach(({ state: { plot } }) => plot.setScale('x', { min: low, max: high }));
  return { box, draw, show, follow: whatIf < 0 ? null : follower(box, series, drawn, heading, (line) => misfitOf(series, channel.in_band, line), whatIf) };
}

/**
 * Draws {gain, phase, mean} as line number `at`, or nothing for null; what is out of view waits until it comes into it.
 * `rests`: scales follow too, which under a moving hand would only confuse.
 */
function follower(box, series, drawn, heading, misfit, at) {
  let inView = true;
  let waits = false;
  const put = (part, values) => {
    part.lines.find(({ label }) => label === 'what if').values = values ?? part.measured.map(() => null);
  };
  const redraw = (rests) => {
    waits = false;
    for (const { state: { plot }, data } of drawn) {
      const { min, max } = plot.scales.x;
      const isNew = min == null;
      plot.setData(data(), isNew);
      // Its range anew, as far zoomed as it is.
      if (!isNew && rests) plot.setScale('x', { min, max });
      else if (!isNew) plot.redraw(true, false);
    }
  };
  new IntersectionObserver(([entry]) => {
    inView = entry.isIntersecting;
    if (inView && waits) redraw(true);
  }).observe(box);
  return (answer, rests) => {
    put(series.gain, answer?.gain.map(decibel));
    put(series.phase, answer && near(answer.phase, series.phase.leads));
    if (series.mean) put(series.mean, answer?.mean.map((value) => (value == null ? null : series.mean.factor * value)));
    drawn.forEach((one) => one.follow?.(answer));
    const [fit, now] = [misfit(at - 1), answer ? misfit(at) : ''];
    heading.textContent = now ? `${fit.replace(' rms', '')} \u2192 ${now}` : fit;
    if (inView) redraw(rests);
    else waits = true;
  };
}
