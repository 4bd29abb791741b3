import { chart, curve, frequencyAxis, linearAxis, logAxis } from './chart.js';
import { el } from './dom.js';
import { extent } from './number.js';
import { spectraOf } from './spectra.js';
import { tools } from './tools.js';

/** Of the largest density what is still drawn: rigs have no more than six decades. */
const decades = 1e-6;

/** Spectra of a channel, measured, modelled and of their difference, over the frequency up to that of the filter. */
export function spectrumCard(recording, channel, time, sync, highest) {
  const [place, below] = [el('div'), el('div')];
  const title = el('h3', {}, el('span', {}, el('code', {}, channel.name), channel.unit && channel.unit !== '1' ? `, (${channel.unit})\u00b2/Hz` : ''));
  const box = el('div', { class: 'chart', 'data-channel': channel.name }, title, place, below);
  const [line] = channel.lines;
  const rate_Hz = (time.length - 1) / (time[time.length - 1] - time[0]);
  const draw = () => {
    if (!line?.values) return [];
    const spectra = spectraOf(channel.measured ?? line.values, line.values, rate_Hz);
    if (!spectra) return [];
    const difference = channel.measured ? spectraOf(Array.from(time, (_, i) => (line.values[i] ?? 0) - (channel.measured[i] ?? 0)), channel.measured, rate_Hz).first : [];
    const count = spectra.frequency.findIndex((f) => f > highest);
    const within = (list) => Array.from(count < 0 ? list : list.slice(0, count));
    const x = within(spectra.frequency);
    const densities = [channel.measured ? spectra.first : [], spectra.second, difference].map(within).map((list) => (list.length ? list : x.map(() => null)));
    const [, top] = extent(...densities) ?? [0, 1];
    const cursor = { y: false, sync: { key: sync.key }, drag: { x: true, y: false } };
    const xScale = { time: false, distr: 3, range: (u, min, max) => [min, max] };
    const state = chart(
      place,
      166,
      () => ({
        scales: { x: xScale, y: { distr: 3, range: () => [top * decades, 2 * top] } },
        axes: [frequencyAxis(true), logAxis('muted')],
        series: [{}, curve('measured', 'measured', { width: 2.2 }), curve(line.label, line.colour, { width: 1.2 }), curve('difference', 'muted', { width: 1, dash: [4, 3] })],
        cursor,
      }),
      [x, ...densities.map((list) => list.map((value) => (value > top * decades ? value : null)))],
      { name: `spectrum of ${channel.name} of ${recording}`, unit: `(${channel.unit})\u00b2/Hz`, x: ['frequency', 'Hz'] },
    );
    if (!channel.measured) {
      title.append(tools(box, `spectrum ${recording} ${channel.name}`, [state]));
      return [state];
    }
    const coherence = chart(
      below,
      78,
      () => ({
        scales: { x: xScale, y: { range: () => [0, 1.05] } },
        axes: [frequencyAxis(true), linearAxis({ steps: [0.5], size: 64 })],
        series: [{}, curve('coherence', line.colour, { width: 1.2 })],
        cursor,
      }),
      [x, within(spectra.coherence)],
      { name: `coherence of ${channel.name}, model and measurement`, unit: '1', x: ['frequency', 'Hz'] },
    );
    title.append(tools(box, `spectrum ${recording} ${channel.name}`, [state, coherence]));
    return [state, coherence];
  };
  return { box, draw };
}
