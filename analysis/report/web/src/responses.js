import uPlot from 'uplot';
import { chart, curve, dots, errorBars, frequencyAxis, linearAxis, outside } from './chart.js';
import { choice, el, tick } from './dom.js';
import { legend } from './legend.js';
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
    modelled: channel.gain_modelled.map(decibel),
    start: orNone(channel.gain_start, channel.gain_measured).map(decibel),
  };
  const sd = orNone(channel.gain_sd, channel.gain_measured);
  gain.low = channel.gain_measured.map((value, i) => (sd[i] ? decibel(Math.max(value - reach * sd[i], value / 100)) : null));
  gain.high = channel.gain_measured.map((value, i) => (sd[i] ? decibel(value + reach * sd[i]) : null));
  const measured = unwrapped(orNone(channel.phase_measured, channel.gain_measured));
  const angle = orNone(channel.phase_sd, channel.gain_measured);
  const phase = {
    measured,
    modelled: near(orNone(channel.phase_modelled, measured), measured),
    start: near(orNone(channel.phase_start, measured), measured),
    low: measured.map((value, i) => (angle[i] ? value - reach * angle[i] : null)),
    high: measured.map((value, i) => (angle[i] ? value + reach * angle[i] : null)),
  };
  return { x: channel.frequency_Hz, gain, phase, mean: meanOf(channel) };
}

/** The mean offset, of lengths in mm; null where none was measured. */
function meanOf(channel) {
  if (!channel.mean_measured) return null;
  const factor = channel.unit === 'm' ? 1000 : 1;
  const scaled = (list) => list.map((value) => (value == null ? null : factor * value));
  const none = channel.mean_measured.map(() => null);
  return { measured: scaled(channel.mean_measured), modelled: scaled(channel.mean_modelled), low: none, high: none, unit: factor === 1 ? channel.unit : 'mm' };
}

/** A range around the values, at least this wide. */
function rangeOf(part, least, withStart) {
  const [low, high] = extent(part.measured, part.modelled, withStart ? part.start : []) ?? [0, 1];
  const margin = Math.max(0.06 * (high - low), (least - (high - low)) / 2);
  return [low - margin, high + margin];
}

function panel(place, height, series, part, { steps, least, labelled, band, sync, withStart, read }) {
  const [low, high] = extent(series.x);
  const edge = (high / low) ** 0.025;
  return chart(
    place,
    height,
    () => ({
      scales: {
        x: { time: false, distr: 3, range: (u, min, max) => (min === low && max === high ? [low / edge, high * edge] : [min, max]) },
        y: { range: () => rangeOf(part, least, withStart) },
      },
      axes: [frequencyAxis(labelled), linearAxis({ steps })],
      series: [
        {},
        dots('measured'),
        ...(withStart ? [curve('start', 'start', { dash: [4, 3], width: 1.2 })] : []),
        curve('fit', 'model'),
      ],
      cursor: {
        y: false,
        sync: { key: sync.key },
        points: { size: 6 },
        drag: { x: true, y: false },
      },
      plugins: [outside(...band), errorBars(part.low, part.high)],
      hooks: { setCursor: [(u) => read(u.cursor.idx)] },
    }),
    [series.x, part.measured, ...(withStart ? [part.start] : []), part.modelled],
  );
}

/** Root mean square of what fit and measurement differ by, where they were fitted. */
function misfitOf({ gain, phase }, inBand) {
  const rms = (part) => {
    const errors = part.measured.map((value, i) => (inBand[i] && value != null && part.modelled[i] != null ? part.modelled[i] - value : null)).filter((error) => error != null);
    return errors.length ? Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length) : null;
  };
  const [dB, deg] = [rms(gain), rms(phase)];
  if (dB == null) return '';
  return `${fixed(dB, 2)} dB${deg == null ? '' : `, ${fixed(deg, 1)}\u00b0`} rms`;
}

function card(channel, band, sync, withStart) {
  const series = seriesOf(channel);
  const gain = el('div');
  const phase = el('div');
  const mean = el('div');
  const head = misfitOf(series, channel.in_band);
  const reading = el('span', { class: 'reading' }, head);
  const box = el('div', { class: 'chart', 'data-channel': channel.name }, el('h3', {}, el('code', {}, channel.name), reading), gain, phase, mean);
  const read = (i) => {
    if (i == null) reading.textContent = head;
    else {
      const pair = (part, unit, decimals) =>
        `${fixed(part.modelled[i], decimals)} for ${fixed(part.measured[i], decimals)}${unit}`;
      reading.textContent = `${shown(series.x[i], 3)} Hz: ${pair(series.gain, ' dB', 1)}, ${pair(series.phase, '\u00b0', 0)}${series.mean ? `, ${pair(series.mean, ` ${series.mean.unit}`, 1)}` : ''}`;
    }
  };
  const draw = () => {
    const panels = [[gain, 128, series.gain, { steps: [5, 10, 20, 40], least: 6 }]];
    if (series.phase.measured.some((value) => value != null)) panels.push([phase, 96, series.phase, { steps: [45, 90, 180, 360], least: 60 }]);
    if (series.mean) panels.push([mean, 84, series.mean, { least: 1 }]);
    panels.forEach(([place, height, part, options], i) => {
      const labelled = i === panels.length - 1;
      panel(place, height + (labelled ? 16 : 0), series, part, { steps: [], labelled, band, sync, withStart: withStart && part.start, read, ...options });
    });
  };
  return { box, draw };
}

/** Bode charts of every channel of one recording, with one cursor for all. */
export function drawResponses(place, data) {
  const recordings = [...new Set(data.responses.map((channel) => channel.recording))];
  const hasStart = data.responses.some((channel) => channel.gain_start?.some((value) => value != null));
  const hasBars = data.responses.some((channel) => channel.gain_sd?.some((value) => value != null));
  const band = data.result.band_Hz ?? [0, Infinity];
  const state = { recording: recordings[0], start: hasStart };
  const charts = el('div', { class: 'charts' });

  const redraw = () => {
    const sync = uPlot.sync(`responses ${state.recording}`);
    const cards = data.responses
      .filter((channel) => channel.recording === state.recording)
      .map((channel) => card(channel, band, sync, state.start));
    charts.replaceChildren(...cards.map(({ box }) => box));
    for (const { draw } of cards) draw();
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
  place.append(
    controls,
    legend(
      ['dot', 'measured', hasBars ? 'measured, bars: 95 %' : 'measured'],
      ['line', 'model', 'fit'],
      ...(hasStart ? [['dash', 'start', 'start']] : []),
      ['patch', 'line', 'not fitted'],
    ),
    el('p', { class: 'note' }, 'Gain in dB, phase in degrees and, where it was measured, mean offset in mm, over frequency in Hz. The cursor reads fit for measured. Drag to zoom all, double click to go back.'),
    charts,
  );
  redraw();
}
