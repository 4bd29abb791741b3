import { band, chart, curve, frequencyAxis, linearAxis, outside } from './chart.js';
import { fit } from './line_name.js';
import { loudestOf, residualsOf } from './live/misfit.js';

/** What the band reaches to, in standard deviations: 95 % of a normal distribution, rounded. */
const reach = 2;

const parts = [
  ['along', 'gain', {}],
  ['across', 'phase', { dash: [4, 3] }],
  ['mean', 'mean offset', { dash: [1.5, 3] }],
];

const answerOf = (line) => ({ gain: line.gain ?? [], phase: line.phase ?? [], mean: line.mean });

/** Residuals of the lines of a channel that has them: fit, and what the sliders make of it. */
function linesOf(channel) {
  const has = (key) => key !== 'mean' || channel.mean_measured;
  return channel.lines
    .filter(({ label }) => label === fit || label === 'what if')
    .flatMap((line) => {
      const residuals = residualsOf(channel, answerOf(line), channel.error, channel.loudest);
      return parts.filter(([key]) => has(key)).map(([key, name, options]) => ({ key, of: line.label, label: `${line.label}, ${name}`, colour: line.colour, options, values: residuals[key] }));
    });
}

/** Each channel with what its residuals are weighed by, `error` and `loudest`; as it is where nothing weighs them. */
export function weighed(channels, error) {
  if (!error) return channels;
  const loudest = new Map();
  for (const { recording } of channels)
    if (!loudest.has(recording)) loudest.set(recording, loudestOf(channels.filter((channel) => channel.recording === recording)));
  return channels.map((channel) => ({ ...channel, error, loudest: loudest.get(channel.recording).get(channel.unit) }));
}

/** Whether residuals of a channel have a size: noise or a model error is known. */
export const isWeighed = (channel) =>
  channel.error != null && residualsOf(channel, answerOf(channel.lines[channel.lines.findIndex(({ label }) => label === fit)] ?? {}), channel.error, channel.loudest).along.some((value) => value != null);

/** As far as the rows in view go that count, and twice the band at least. */
function rangeOf(counts, lines, [first, last]) {
  let most = 2 * reach;
  for (let i = first; i <= last; ++i) if (counts?.[i] ?? true) for (const { values } of lines) most = Math.max(most, 1.08 * Math.abs(values[i] ?? 0));
  return [-most, most];
}

/** A strip of residuals over frequency, with a band in which 95 % of them lie where the model explains the data. */
export function residualStrip(place, channel, { height, xRange, bands, sync, read, counts }) {
  const lines = linesOf(channel);
  const data = () => [channel.frequency_Hz, ...lines.map(({ values }) => values)];
  const state = chart(
    place,
    height,
    () => ({
      scales: {
        x: { time: false, distr: 3, range: xRange },
        y: { range: (u) => rangeOf(counts, lines, u.series[0].idxs) },
      },
      axes: [frequencyAxis(true), linearAxis({ steps: [2, 4, 10, 20, 50, 100], room: 20 })],
      series: [{}, ...lines.map(({ label, colour, options }) => curve(label, colour, { width: 1.3, ...options }))],
      cursor: { y: false, sync: { key: sync.key }, points: { size: 5 }, drag: { x: true, y: false } },
      plugins: [...bands.map((one) => outside(...one)), band(-reach, reach)],
      hooks: { setCursor: [(u) => read(u.cursor.idx)] },
    }),
    data(),
    { name: `residuals of ${channel.name} over frequency`, unit: 'standard deviations', x: ['frequency', 'Hz'] },
  );
  return {
    state,
    data,
    /** Of another answer of the sliders' car, or none. */
    follow: (answer) => {
      const residuals = answer ? residualsOf(channel, answer, channel.error, channel.loudest) : null;
      for (const line of lines) if (line.of === 'what if') line.values = residuals?.[line.key] ?? channel.frequency_Hz.map(() => null);
    },
  };
}
