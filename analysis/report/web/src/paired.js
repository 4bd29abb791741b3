import { choice, el } from './dom.js';
import { fixed, shown } from './number.js';
import { runLine } from './theme.js';

const radian = Math.PI / 180;

/** Squared relative error of a run's phasor at each frequency; null where something is missing. */
export function squaresOf({ gain_measured, phase_measured }, { gain, phase }) {
  return gain_measured.map((measured, i) => {
    const ratio = gain[i] / measured;
    const turn = (phase[i] - phase_measured[i]) * radian;
    const square = 1 + ratio * ratio - 2 * ratio * Math.cos(turn);
    return measured == null || gain[i] == null || phase[i] == null || phase_measured[i] == null || !Number.isFinite(square) ? null : Math.max(0, square);
  });
}

const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;

/** As many values as count when each resembles the one before: n (1 - r) / (1 + r), r their correlation. */
export function effectiveNumber(list) {
  const m = mean(list);
  const [all, next] = list.reduce(([a, b], value, i) => [a + (value - m) ** 2, i ? b + (value - m) * (list[i - 1] - m) : b], [0, 0]);
  const r = all > 0 ? Math.min(0.99, Math.max(0, next / all)) : 0;
  return Math.max(1.5, (list.length * (1 - r)) / (1 + r));
}

/**
 * Ratio of two runs' root mean square errors of one channel, and its interval of 95 %, of errors at the same frequencies:
 * with a, b the squares over their means, ln(ratio) has the variance of (a - b) / 2 over the number of values that count.
 */
export function ratioOf(squares, reference) {
  const rows = squares.flatMap((value, i) => (value == null || reference[i] == null ? [] : [i]));
  if (rows.length < 8) return null;
  const [a, b] = [squares, reference].map((list) => rows.map((i) => list[i]));
  const [over, under] = [mean(a), mean(b)];
  if (!(over > 0 && under > 0)) return null;
  const differences = a.map((value, k) => (value / over - b[k] / under) / 2);
  const m = mean(differences);
  const variance = differences.reduce((sum, value) => sum + (value - m) ** 2, 0) / (differences.length - 1);
  const reach = 1.96 * Math.sqrt(variance / effectiveNumber(differences));
  const ratio = Math.sqrt(over / under);
  return { ratio, lower: ratio * Math.exp(-reach), upper: ratio * Math.exp(reach) };
}

/** Whether a run is worse, better or alike: a difference counts beyond noise, and where the printed digits show it. */
export function sideOf({ lower, upper }) {
  if (Number(lower.toFixed(2)) > 1) return 'worse';
  return Number(upper.toFixed(2)) < 1 ? 'better' : 'alike';
}

/** Of what a bar shows: ratios from 1/4 to 4. */
const widest = 4;
const placeOf = (ratio) => `${(100 * Math.min(1, Math.max(0, 0.5 + Math.log(ratio) / (2 * Math.log(widest))))).toFixed(2)}%`;

/** A ratio as a dot with its interval: filled where it differs from 1. `run`: whose colour; `name` and `reference`: words. */
export function ratioCell(compared, run, name, reference) {
  if (!compared) return el('td', {}, '');
  const { ratio, lower, upper } = compared;
  const differs = sideOf(compared) !== 'alike';
  const colour = `var(--${runLine(run).colour})`;
  const words = differs ? `${name} is ${sideOf(compared)} than ${reference}` : 'no difference beyond what is left to chance';
  return el(
    'td',
    { title: words },
    el(
      'span',
      { class: 'bar ratio' },
      el('i', { class: 'interval', style: { left: placeOf(lower), width: `calc(${placeOf(upper)} - ${placeOf(lower)})`, background: colour } }),
      el('i', { class: `value${differs ? '' : ' ring'}`, style: { left: placeOf(ratio), ...(differs ? { background: colour } : { borderColor: colour }) } }),
    ),
    ' ',
    el('span', { class: differs ? '' : 'unfitted' }, `${fixed(ratio, 2)} (${fixed(lower, 2)} \u2026 ${fixed(upper, 2)})`),
  );
}

/** Errors of each channel against those of one run, pair by pair of frequencies, with intervals. */
export function drawComparedErrors(place, { comparison: { runs: names, bands, responses } }) {
  if (!responses?.length) return;
  const box = el('div', { class: 'table' });
  const show = (reference) => {
    const others = names.map((_, run) => run).filter((run) => run !== reference);
    const count = { better: 0, worse: 0, alike: 0 };
    const rows = responses.map((entry) => {
      const squares = new Map(entry.runs.map((one) => [one.run, squaresOf(entry, one)]));
      // Where both were fitted, or where neither was.
      const within = (list, run) => list?.map((value, i) => ([run, reference].every((k) => !bands[k] || (entry.frequency_Hz[i] >= bands[k][0] * 0.999999 && entry.frequency_Hz[i] <= bands[k][1] * 1.000001)) ? value : null));
      return el(
        'tr',
        {},
        el('td', {}, entry.recording),
        el('td', {}, el('code', {}, entry.name)),
        ...others.map((run) => {
          const compared = squares.has(run) && squares.has(reference) ? ratioOf(within(squares.get(run), run), within(squares.get(reference), run)) : null;
          if (compared) count[sideOf(compared)] += 1;
          return ratioCell(compared, run, names[run], names[reference]);
        }),
      );
    });
    box.replaceChildren(
      el('table', {}, el('caption', {}, `${count.better} better than ${names[reference]}, ${count.worse} worse, ${count.alike} that cannot be distinguished.`), el('thead', {}, el('tr', {}, ...['recording', 'channel', ...others.map((run) => `${names[run]} over ${names[reference]}`)].map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...rows)),
    );
  };
  place.append(
    el('h3', {}, 'Errors beside those of one run'),
    el('div', { class: 'controls' }, choice('beside', names.map((name, i) => [i, name]), 0, show)),
    el('p', { class: 'note' }, `Ratio of root mean square errors of a channel over the frequencies that both fitted, on a scale of 1/${widest} to ${widest}, with its interval of 95 % by the differences at each frequency. Filled: differs from 1 beyond noise and at the digits shown; hollow: may be chance.`),
    box,
  );
  show(0);
}

/** Whether no value lies in both intervals. */
const areApart = (a, b) => a.lower != null && b.lower != null && (a.lower > b.upper || b.lower > a.upper);

/** Where all numbers of a parameter are positive, changes of the first run's value, in which parameters compare; else null. */
const changesOf = (ends, first) => (ends.every((number) => number > 0) ? (value) => value / first - 1 : null);

/** Beyond it an interval is cut, with an arrow. */
const widestChange = 1;

/** Parameters of the runs with their intervals; positive ones as changes of the first run's, all on one scale. */
export function drawComparedParameters(place, { comparison: { runs: names, parameters } }) {
  if (!parameters?.length) return;
  const known = parameters.map((parameter) => {
    const ends = parameter.runs.flatMap(({ value, lower, upper }) => [value, lower, upper]).filter((number) => Number.isFinite(number));
    return { ...parameter, ends, change: changesOf(ends, parameter.runs[0].value) };
  });
  const changes = known.flatMap(({ ends, change }) => (change ? ends.map((end) => Math.abs(change(end))) : []));
  const reach = Math.min(widestChange, Math.max(0.01, ...changes));
  const rows = known.map(({ name, unit, runs, ends, change }) => {
    const [low, high] = [Math.min(...ends), Math.max(...ends)];
    const share = change ? (value) => 0.5 + change(value) / (2 * reach) : (value) => (high > low ? 0.04 + (0.92 * (value - low)) / (high - low) : 0.5);
    const at = (value) => `${(100 * Math.min(1, Math.max(0, share(value)))).toFixed(2)}%`;
    const apart = runs.flatMap((a, i) => runs.slice(i + 1).filter((b) => areApart(a, b)).map((b) => `${names[a.run]} and ${names[b.run]}`));
    const words = ({ value, lower, upper }) => `${shown(value, 4)}${lower == null ? '' : ` (${shown(lower, 4)} \u2026 ${shown(upper, 4)})`}`;
    const marks = runs.flatMap((one, i) => {
      const { run, value, lower, upper } = one;
      const top = `${(100 * (i + 1)) / (runs.length + 1)}%`;
      const colour = `var(--${runLine(run).colour})`;
      const title = `${names[run]}: ${words(one)} ${unit}`;
      const cut = lower == null ? '' : `${share(lower) < 0 ? ' below' : ''}${share(upper) > 1 ? ' above' : ''}`;
      return [
        lower == null ? null : el('i', { class: `interval${cut}`, title, style: { top, left: at(lower), width: `calc(${at(upper)} - ${at(lower)})`, background: colour, color: colour } }),
        el('i', { class: 'value', title, style: { top, left: at(value), background: colour } }),
      ];
    });
    const numbers = names.map((_, run) => {
      const one = runs.find((other) => other.run === run);
      return el('td', { class: 'n' }, one ? words(one) : '');
    });
    return el(
      'tr',
      {},
      el('td', {}, el('code', {}, name)),
      ...numbers,
      el('td', {}, unit === '1' ? '' : unit.replace('^2', '\u00b2').replaceAll('*', '\u00b7')),
      el('td', { class: 'lanes' }, el('span', { class: `bar wide lanes${change ? '' : ' own'}`, style: { height: `${Math.max(14, 10 * runs.length + 4)}px` } }, ...marks)),
      el('td', { class: 'remark' }, apart.length ? `contradict: ${apart.join(', ')}` : ''),
    );
  });
  const contradicting = rows.filter((row) => row.lastChild.textContent).length;
  const percent = fixed(100 * reach, reach < 0.1 ? 1 : 0);
  const own = known.some(({ change }) => !change) ? ' Those with values of both signs are on a scale of their own (dashed).' : '';
  place.append(
    el('p', { class: 'note' }, `Values and intervals; bars: change from the value of ${names[0]}, all on one scale from \u2212${percent} to +${percent} %.${own} ${contradicting ? `${contradicting} of ${rows.length} contradict each other: their intervals have no value in common.` : 'No intervals contradict each other.'}`),
    el('div', { class: 'legend' }, ...names.map((name, run) => el('span', {}, el('i', { class: 'dot', style: { color: `var(--${runLine(run).colour})` } }), name))),
    el('div', { class: 'table agreement' }, el('table', {}, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'parameter'), ...names.map((name) => el('th', { class: 'n', scope: 'col' }, name)), el('th', { scope: 'col' }, 'unit'), el('th', { scope: 'col' }, `\u2212${percent} % \u2026 +${percent} %`), el('th', { scope: 'col' }, 'contradictions'))), el('tbody', {}, ...rows))),
  );
}
