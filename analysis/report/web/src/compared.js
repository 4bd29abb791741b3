import uPlot from 'uplot';
import { liveliest, overTime, xy } from './bench.js';
import { choice, el } from './dom.js';
import { busiest, card as historyCard, readable } from './histories.js';
import { legend } from './legend.js';
import { extent } from './number.js';
import { card as responseCard } from './responses.js';
import { runLine } from './theme.js';

/** Of several runs what was measured is in the colour of the text. */
const ink = 'text';

/** A line of each run: its label, colour and dashes, and what it tells. */
export function linesOf(entry, names) {
  return entry.runs.map(({ run, ...told }) => ({ label: names[run], ...runLine(run), ...told }));
}

const legendOf = (mark, entries, names) => {
  const present = new Set(entries.flatMap(({ runs }) => runs.map(({ run }) => run)));
  const lines = names.map((name, i) => [runLine(i).dash ? 'dash' : 'line', runLine(i).colour, name]);
  return legend([mark, ink, 'measured'], ...lines.filter((_, i) => present.has(i)));
};

/** Controls for one of the recordings, and a place that `fill` makes anew of its entries. */
function byRecording(place, entries, fill, first = entries[0].recording) {
  const names = [...new Set(entries.map(({ recording }) => recording))];
  const charts = el('div', { class: `charts${entries[0].frequency_Hz ? '' : ' wide'}` });
  const redraw = (name) => fill(charts, entries.filter(({ recording }) => recording === name), name);
  const options = names.map((name) => [name, name]);
  if (names.length > 4) {
    const select = el('select', { 'aria-label': 'recording', onchange: () => redraw(select.value) }, ...names.map((name) => el('option', { value: name }, name)));
    select.value = first;
    place.append(el('div', { class: 'controls' }, el('label', {}, 'recording', select)));
  } else if (names.length > 1) place.append(el('div', { class: 'controls' }, choice('recording', options, first, redraw)));
  return { charts, show: () => redraw(first) };
}

const left = ' A run without a channel, or with another measurement of it, has no line.';

export function drawComparedResponses(place, { comparison: { runs, responses } }) {
  const { charts, show } = byRecording(place, responses, (box, entries, name) => {
    const sync = uPlot.sync(`compared responses ${name}`);
    const cards = entries.map((entry) => responseCard({ ...entry, ink, lines: linesOf(entry, runs) }, [0, Infinity], sync));
    box.replaceChildren(...cards.map((card) => card.box));
    for (const { draw } of cards) draw();
  });
  place.append(legendOf('dot', responses, runs), el('p', { class: 'note' }, `Gain in dB, phase in degrees and mean offset in mm over frequency in Hz. The cursor reads the runs in turn for measured.${left}`), charts);
  show();
}

export function drawComparedHistories(place, { comparison: { runs, histories } }) {
  let stretch = () => {};
  const { charts, show } = byRecording(place, histories, (box, entries, name) => {
    const sync = uPlot.sync(`compared history ${name}`);
    const channels = entries.map((entry) => {
      const [factor, unit] = readable(entry.unit);
      const scaled = (values) => values.map((value) => (value == null ? null : factor * value));
      return { name: entry.name, unit, ink, time: entry.time, measured: scaled(entry.measured), lines: linesOf(entry, runs).map((line) => ({ ...line, values: scaled(line.values) })) };
    });
    const cards = channels.map((channel) => historyCard(name, channel, channel.time, null, sync));
    box.replaceChildren(...cards.map((card) => card.box));
    const states = cards.map(({ draw }) => draw());
    stretch = (part) => {
      const [min, max] = part === 'all' ? extent(channels[0].time) : busiest(channels[0].time, [channels[0]]);
      for (const { plot } of states) plot.setScale('x', { min, max });
    };
  });
  place.append(
    el('div', { class: 'controls' }, choice('stretch', [['all', 'all of it'], ['close', 'where most happens']], 'all', (part) => stretch(part))),
    legendOf('line', histories, runs),
    el('p', { class: 'note' }, `Over time in s. Drag to zoom all, double click to go back. Long recordings are thinned to the extremes of each stretch.${left}`),
    charts,
  );
  show();
}

export function drawComparedBench(place, { comparison: { runs, bench } }) {
  const { charts, show } = byRecording(
    place,
    bench,
    (box, entries) => {
      const drawn = entries.map((entry) => ({ ...entry, ink, lines: linesOf(entry, runs) }));
      const parts = [
        xy(box, 'Work diagram', drawn, 'displacement_m', 1000, 'mm'),
        xy(box, 'Characteristic', drawn, 'speed_mps', 1, 'm/s'),
        overTime(box, drawn[0]),
      ].filter((part) => part);
      box.replaceChildren(...parts.map(({ card }) => card));
      for (const { draw } of parts) draw();
    },
    liveliest(bench),
  );
  place.append(legendOf('line', bench, runs), charts);
  show();
}
