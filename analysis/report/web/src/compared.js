import uPlot from 'uplot';
import { liveliest, overTime, xy } from './bench.js';
import { choice, el } from './dom.js';
import { card as historyCard, readable } from './histories.js';
import { legend } from './legend.js';
import { extent } from './number.js';
import { card as responseCard } from './response_card.js';
import { zeroDecibel } from './responses.js';
import { runLine } from './theme.js';

/** Of several runs what was measured is in the colour of the text. */
const ink = 'text';

/** A line of each run: its label, colour and dashes, and what it shows. */
export function linesOf(entry, names) {
  return entry.runs.map(({ run, ...told }) => ({ label: names[run], ...runLine(run), ...told }));
}

/** Runs that show one of these entries. */
const present = (entries) => [...new Set(entries.flatMap(({ runs }) => runs.map(({ run }) => run)))].sort((a, b) => a - b);

const legendOf = (mark, entries, names, ...more) =>
  legend([mark, ink, 'measured'], ...present(entries).map((i) => [runLine(i), runLine(i).colour, names[i]]), ...more);

const listed = (items) => items.join(', ').replace(/, ([^,]*)$/, ' and $1');

/** Of a recording, which runs it was fitted in and which predict it. */
function usesOf(entries, names) {
  const fitted = new Set(entries.flatMap(({ runs }) => runs.filter((one) => one.fitted).map(({ run }) => run)));
  const told = present(entries);
  const of = (wanted) => listed(told.filter((run) => fitted.has(run) === wanted).map((run) => names[run]));
  return [[true, 'fitted by'], [false, 'predicted by']].filter(([wanted]) => of(wanted)).map(([wanted, words]) => `${words} ${of(wanted)}`).join(', ');
}

/** The bands [Hz] of runs, each once. */
const bandsOf = (entries, bands) => [...new Map(present(entries).map((run) => bands[run]).filter((band) => band).map((band) => [band.join(), band])).values()];

/** Controls for one of the recordings, and a place that `fill` makes anew of its entries. */
function byRecording(place, entries, fill, first = entries[0].recording) {
  const names = [...new Set(entries.map(({ recording }) => recording))];
  const charts = el('div', { class: `charts compared${entries[0].frequency_Hz ? '' : ' wide'}` });
  const redraw = (name) => fill(charts, entries.filter(({ recording }) => recording === name), name);
  const options = names.map((name) => [name, name]);
  if (names.length > 4) {
    const select = el('select', { 'aria-label': 'recording', onchange: () => redraw(select.value) }, ...names.map((name) => el('option', { value: name }, name)));
    select.value = first;
    place.append(el('div', { class: 'controls' }, el('label', {}, 'recording', select)));
  } else if (names.length > 1) place.append(el('div', { class: 'controls' }, choice('recording', options, first, redraw)));
  return { charts, show: () => redraw(first) };
}

const left = ' Runs without a channel, or with another measurement of it, have no line.';

export function drawComparedResponses(place, { comparison: { runs, bands, responses } }) {
  const shaded = bandsOf(responses, bands);
  const { charts, show } = byRecording(place, responses, (box, entries, name) => {
    const sync = uPlot.sync(`compared responses ${name}`);
    const cards = entries.map((entry) => responseCard({ ...entry, ink, lines: linesOf(entry, runs) }, bandsOf([entry], bands), sync));
    box.replaceChildren(...cards.map((card) => card.box));
    for (const { draw } of cards) draw();
  });
  const only = responses.every(({ recording }) => recording === responses[0].recording);
  const of = only ? `Recording ${responses[0].recording}. ` : '';
  const outside = shaded.length ? [['patch', 'line', shaded.length > 1 ? 'not fitted by some runs, darkest: by none' : 'not fitted']] : [];
  place.append(legendOf('dot', responses, runs, ...outside), el('p', { class: 'note' }, `${of}Gain in dB, phase in degrees and mean offset in mm over frequency in Hz. ${zeroDecibel(responses.map(({ unit }) => unit))} The cursor shows the runs one after the other/measured.${left}`), charts);
  show();
}

export function drawComparedHistories(place, { comparison: { runs, histories } }) {
  let part = 'close';
  let stretch = () => {};
  const uses = el('p', { class: 'note' });
  const { charts, show } = byRecording(place, histories, (box, entries, name) => {
    uses.textContent = `${name}: ${usesOf(entries, runs)}.`;
    const sync = uPlot.sync(`compared history ${name}`);
    const channels = entries.map((entry) => {
      const [factor, unit] = readable(entry.unit);
      const scaled = (values) => values.map((value) => (value == null ? null : factor * value));
      return { name: entry.name, unit, ink, time: entry.time, measured: scaled(entry.measured), lines: linesOf(entry, runs).map((line) => ({ ...line, values: scaled(line.values) })) };
    });
    const cards = channels.map((channel) => historyCard(name, channel, channel.time, null, sync));
    box.replaceChildren(...cards.map((card) => card.box));
    const states = cards.map(({ draw }) => draw());
    stretch = () => {
      const [min, max] = part === 'all' ? extent(channels[0].time) : entries[0].busiest;
      for (const { plot } of states.flat()) plot.setScale('x', { min, max });
    };
    stretch();
  });
  place.append(
    el('div', { class: 'controls' }, choice('stretch', [['all', 'all'], ['close', 'busiest']], part, (chosen) => { part = chosen; stretch(); })),
    legendOf({ width: 3 }, histories, runs),
    uses,
    el('p', { class: 'note' }, `Over time in s. Drag to zoom all charts, double-click to reset. Long recordings are thinned to the extremes of each interval, except for the busiest.${left}`),
    charts,
  );
  show();
}

export function drawComparedBench(place, { comparison: { runs, bench } }) {
  const uses = el('p', { class: 'note' });
  const { charts, show } = byRecording(
    place,
    bench,
    (box, entries, name) => {
      uses.textContent = `${name}: ${usesOf(entries, runs)}.`;
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
  place.append(legendOf({ width: 3 }, bench, runs), uses, charts);
  show();
}
