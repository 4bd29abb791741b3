import { el } from './dom.js';
import { drawComparedParameters, ratioCell, ratioOf, sideOf, squaresOf } from './paired.js';
import { runLine } from './theme.js';

/** The data in the text of a report; throws for another file. */
export function dataOf(text) {
  const [, json] = /<script type="application\/json" id="data">(.*?)<\/script>/s.exec(text) ?? [];
  if (!json) throw new Error('this is no page of fourpost');
  const data = JSON.parse(json);
  if (!data.responses?.length) throw new Error('it has no frequency responses');
  return data;
}

/** Numbers that two files write of the same recording: at six digits. */
const areAlike = (a, b) => a.length === b.length && a.every((value, i) => value === b[i] || Math.abs(value - b[i]) <= 2e-5 * Math.abs(value));

/** Of another run its channels that were measured alike, by recording and name. */
export function sharedWith(channels, other) {
  const shared = new Map();
  for (const channel of channels) {
    const same = other.find(({ recording, name }) => recording === channel.recording && name === channel.name);
    if (same && areAlike(channel.frequency_Hz, same.frequency_Hz) && areAlike(channel.gain_measured, same.gain_measured)) shared.set(channel, same);
  }
  return shared;
}

/** A line of another run over those of this one. */
export const lineOf = ({ name, place }, channel) => ({ label: name, ...runLine(place), width: 1.8, gain: channel.gain_modelled, phase: channel.phase_modelled, mean: channel.mean_modelled, read: false });

/** Parameters of two results, {name, unit, runs}, in the units of the sliders where there are some. */
export function parametersOf(own, theirs, place, scales) {
  const found = (list, name) => (list ?? []).find((parameter) => parameter.name === name);
  return (own ?? []).flatMap((parameter) => {
    const other = found(theirs, parameter.name);
    if (!other || other.value == null || parameter.value == null) return [];
    const scale = found(scales, parameter.name) ?? { si: 1, unit: parameter.unit };
    const of = (run, { value, interval_95: ends }) => ({ run, value: value / scale.si, lower: ends?.[0] == null ? null : ends[0] / scale.si, upper: ends?.[1] == null ? null : ends[1] / scale.si });
    return [{ name: parameter.name, unit: scale.unit, runs: [of(0, parameter), of(place, other)] }];
  });
}

/** Of each channel by how much another run is further off than this one. */
export function comparisonOf(channels, { name, place, shared, parameters }, remove) {
  const names = ['this fit', name];
  const counts = { better: 0, worse: 0, alike: 0 };
  const rows = channels.flatMap((channel) => {
    const other = shared.get(channel);
    if (!other) return [];
    const within = (list) => list.map((value, i) => (channel.in_band[i] && other.in_band[i] ? value : null));
    const [own, theirs] = [channel, other].map(({ gain_modelled: gain, phase_modelled: phase }) => within(squaresOf(channel, { gain, phase })));
    const ratio = ratioOf(theirs, own);
    if (ratio) counts[sideOf(ratio)] += 1;
    return [el('tr', {}, el('td', {}, channel.recording), el('td', {}, el('code', {}, channel.name)), ratioCell(ratio, place, names[1], names[0]))];
  });
  const words = `${name}: ${counts.better} channels better than this fit, ${counts.worse} worse, ${counts.alike} that cannot be distinguished`;
  const further = el('div');
  if (parameters?.length) {
    const runs = [];
    runs[0] = names[0];
    runs[place] = name;
    drawComparedParameters(further, { comparison: { runs, parameters } });
  }
  const details = el(
    'details',
    { open: true },
    el('summary', {}, words),
    el('div', { class: 'table' }, el('table', {}, el('thead', {}, el('tr', {}, ...['recording', 'channel', `error of ${name} over that of this fit, and its interval of 95 %`].map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...rows))),
    further,
  );
  return { words, box: el('div', { class: 'dropped' }, details, el('button', { type: 'button', onclick: remove }, `remove ${name}`)) };
}

/** Files that are dropped on the page, or chosen by a button, which is given back. */
export function takeFiles(take) {
  const input = el('input', { type: 'file', multiple: true, accept: '.html', hidden: true, onchange: () => take([...input.files]) });
  addEventListener('dragover', (event) => {
    if ([...event.dataTransfer.types].includes('Files')) event.preventDefault();
  });
  addEventListener('drop', (event) => {
    if (!event.dataTransfer.files.length) return;
    event.preventDefault();
    take([...event.dataTransfer.files]);
  });
  return el('span', {}, el('button', { type: 'button', title: 'another report.html; or drop it on the page', onclick: () => input.click() }, 'compare with \u2026'), input);
}
