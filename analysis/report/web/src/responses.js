import uPlot from 'uplot';
import { area, chart, curve, dots, errorBars, frequencyAxis, linearAxis, outside } from './chart.js';
import { choice, el, tick } from './dom.js';
import { readable } from './histories.js';
import { legend } from './legend.js';
import { onAnswer } from './live/answers.js';
import { canFollow, openWhatIf } from './live/whatif.js';
import { fittedBand } from './residuals.js';
import { decibel, extent, fixed, shown } from './number.js';

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
  const angle = orNone(channel.phase_sd, channel.gain_measured);
  const phase = {
    measured,
    lines: channel.lines.map((line) => ({ ...line, values: near(orNone(line.phase, measured), measured) })),
    low: measured.map((value, i) => (angle[i] ? value - reach * angle[i] : null)),
    high: measured.map((value, i) => (angle[i] ? value + reach * angle[i] : null)),
  };
  const [modelled, turned] = [channel.gain_modelled, phase.lines.find(({ label }) => label === 'fit')?.values];
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

/** A range around least and greatest of what is in view, or of all where nothing is, at least this wide. */
function rangeOf(part, least, inView) {
  const [low, high] = inView.every(Number.isFinite) ? inView : extent(part.measured, ...part.lines.map((line) => line.values)) ?? [0, 1];
  const margin = Math.max(0.06 * (high - low), (least - (high - low)) / 2);
  return [low - margin, high + margin];
}

function panel(place, height, series, part, { steps, least, labelled, bands, sync, read }) {
  const [low, high] = extent(series.x);
  const edge = (high / low) ** 0.025;
  return chart(
    place,
    height,
    () => ({
      scales: {
        x: { time: false, distr: 3, range: (u, min, max) => (min === low && max === high ? [low / edge, high * edge] : [min, max]) },
        y: { range: (u, ...inView) => rangeOf(part, least, inView.slice(0, 2)) },
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
  );
}

/** Root mean square of what a line, or the last, and measurement differ by, where they were fitted. */
function misfitOf({ gain, phase }, inBand, line = gain.lines.length - 1) {
  const rms = ({ measured, lines }) => {
    const modelled = lines[line].values;
    const errors = measured.map((value, i) => (inBand[i] && value != null && modelled[i] != null ? modelled[i] - value : null)).filter((error) => error != null);
    return errors.length ? Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length) : null;
  };
  const [dB, deg] = [rms(gain), rms(phase)];
  if (dB == null) return '';
  return `${fixed(dB, 2)} dB${deg == null ? '' : `, ${fixed(deg, 1)}\u00b0`} rms`;
}

/**
 * Charts of a channel with `lines`: label, colour, gain, phase and mean of each; without `read` the cursor passes it.
 * `bands` [Hz]: what lies outside of each is shaded.
 */
export function card(channel, bands, sync) {
  const series = seriesOf(channel);
  const gain = el('div');
  const phase = el('div');
  const mean = el('div');
  const whatIf = channel.lines.findIndex(({ label }) => label === 'what if');
  const heading = el('span', {}, channel.in_band ? misfitOf(series, channel.in_band, whatIf < 0 ? undefined : whatIf - 1) : '');
  const drawn = [];
  const reading = el('span', { class: 'reading' });
  const box = el('div', { class: 'chart', 'data-channel': channel.name }, el('h3', {}, el('code', {}, channel.name), heading, reading), gain, phase, mean);
  const read = (i) => {
    if (i == null) reading.textContent = '';
    else {
      const parts = [[series.gain, ' dB', 1], [series.phase, '\u00b0', 0]];
      if (series.mean) parts.push([series.mean, ` ${series.mean.unit}`, 1]);
      // Short, since there is one line of room; the note says which is which.
      const pairs = parts.map(([part, unit, decimals]) => {
        const modelled = part.lines.filter((line) => line.read !== false).map((line) => fixed(line.values[i], decimals));
        return `${modelled.join(', ')}/${fixed(part.measured[i], decimals)}${unit}`;
      });
      reading.textContent = `${shown(series.x[i], 3)} Hz: ${pairs.join(', ')}`;
    }
  };
  const draw = () => {
    const panels = [[gain, 128, series.gain, { steps: [5, 10, 20, 40], least: 6 }]];
    if (series.phase.measured.some((value) => value != null)) panels.push([phase, 96, series.phase, { steps: [45, 90, 180, 360], least: 60 }]);
    if (series.mean) panels.push([mean, 84, series.mean, { least: 1 }]);
    panels.forEach(([place, height, part, options], i) => {
      const labelled = i === panels.length - 1;
      drawn.push([panel(place, height + (labelled ? 16 : 0), series, part, { steps: [], labelled, bands, sync, read, ...options }), part]);
    });
  };
  return { box, draw, follow: whatIf < 0 ? null : follower(box, series, drawn, heading, (line) => misfitOf(series, channel.in_band, line), whatIf) };
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
    for (const [{ plot }, part] of drawn) {
      const { min, max } = plot.scales.x;
      const isNew = min == null;
      plot.setData([series.x, part.measured, ...part.lines.map((line) => line.values)], isNew);
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
    put(series.phase, answer && near(answer.phase, series.phase.measured));
    if (series.mean) put(series.mean, answer?.mean.map((value) => (value == null ? null : series.mean.factor * value)));
    const [fit, now] = [misfit(at - 1), answer ? misfit(at) : ''];
    heading.textContent = now ? `${fit.replace(' rms', '')} \u2192 ${now}` : fit;
    if (inView) redraw(rests);
    else waits = true;
  };
}

/** Start, where it is wanted, fit, and the place of what a car of other values would do. */
function linesOf(channel, withStart, withWhatIf) {
  const start = { label: 'start', colour: 'start', dash: [4, 3], width: 1.2, gain: channel.gain_start, phase: channel.phase_start, read: false };
  const fit = { label: 'fit', colour: 'model', gain: channel.gain_modelled, phase: channel.phase_modelled, mean: channel.mean_modelled };
  const none = channel.gain_measured.map(() => null);
  const whatIf = { label: 'what if', colour: 'whatif', width: 1.8, gain: none, phase: none, mean: none };
  return [...(withStart ? [start] : []), fit, ...(withWhatIf ? [whatIf] : [])];
}

/** What 0 dB stands for, by the units of the channels: accelerations are relative to that of the post, all else to its motion. */
export function zeroDecibel(units) {
  const known = { 'm/s^2': 'acceleration equal to that of the post', m: 'displacement equal to its motion', N: 'force of 1 N per m of its motion' };
  return `0 dB: ${[...new Set(units)].map((unit) => known[unit] ?? `1 ${readable(unit)[1]} per m of its motion`).join(', ')}.`;
}

/** Bode charts of every channel of one recording, with one cursor for all. */
export function drawResponses(place, data) {
  const recordings = [...new Set(data.responses.map((channel) => channel.recording))];
  const hasStart = data.responses.some((channel) => channel.gain_start?.some((value) => value != null));
  const hasBars = data.responses.some((channel) => channel.gain_sd?.some((value) => value != null));
  const hasAreas = data.responses.some((channel) => channel.gain_bands);
  const band = fittedBand(data.result.band_Hz, data.responses) ?? [0, 0];
  const state = { recording: recordings[0], start: hasStart, whatIf: false, answer: null };
  const charts = el('div', { class: 'charts' });
  const pair = el('div', {}, charts);
  let cards = [];

  const redraw = () => {
    const sync = uPlot.sync(`responses ${state.recording}`);
    cards = data.responses
      .filter((channel) => channel.recording === state.recording)
      .map((channel) => card({ ...channel, lines: linesOf(channel, state.start, state.whatIf) }, [band], sync));
    charts.replaceChildren(...cards.map(({ box }) => box));
    for (const { draw } of cards) draw();
    if (state.answer) follow(state.answer);
  };
  const follow = (answer) => {
    state.answer = answer;
    const found = answer?.responses?.get(state.recording);
    if (state.whatIf) cards.forEach(({ follow: show }, i) => show(found?.answers[i] ?? null, answer?.rests ?? true));
  };
  const controls = el('div', { class: 'controls' });
  if (recordings.length > 1)
    controls.append(
      choice('recording', recordings.map((name) => [name, name]), state.recording, (name) => {
        state.recording = name;
        redraw();
      }),
    );
  if (hasStart)
    controls.append(
      tick('start', state.start, (on) => {
        state.start = on;
        redraw();
      }),
    );
  const marks = (withWhatIf) =>
    legend(
      ['dot', 'measured', hasBars ? 'measured, bars: 95 %' : 'measured'],
      ['line', 'model', 'fit'],
      ...(withWhatIf ? [['line', 'whatif', 'what if']] : []),
      ...(hasStart ? [['dash', 'start', 'start']] : []),
      ...(hasAreas ? [['patch', 'model', 'bands of 95 %: inner, of the parameters; outer, of new measured points']] : []),
      ['patch', 'line', 'not fitted'],
    );
  const key = el('div', {}, marks(false));
  const show = (on) => {
    state.whatIf = on;
    state.answer = null;
    key.replaceChildren(marks(on));
    pair.classList.toggle('beside', on);
    redraw();
  };
  if (canFollow(data)) {
    const opener = el('button', { type: 'button', class: 'opener' }, 'what if \u2026');
    opener.addEventListener('click', async () => {
      opener.disabled = true;
      try {
        const { panel: sliders, answer } = await openWhatIf(data, () => state.recording, () => {
          opener.disabled = false;
          show(false);
          opener.focus();
        });
        pair.prepend(sliders);
        show(true);
        answer();
      } catch (error) {
        // The page stays what it is without.
        opener.replaceWith(el('span', { class: 'note' }, `This browser does not follow other values: ${error.message}`));
      }
    });
    controls.append(opener);
    onAnswer((answer) => {
      if (answer) follow(answer);
    });
  }
  place.append(
    controls,
    key,
    el('p', { class: 'note' }, `Gain in dB, phase in degrees and, where it was measured, mean offset in mm, over frequency in Hz. ${zeroDecibel(data.responses.map(({ unit }) => unit))} The cursor shows model/measured. Drag to zoom all charts, double-click to reset.`),
    pair,
  );
  redraw();
}
