import { el } from './dom.js';
import { ratioCell, ratioOf, squaresOf } from './paired.js';
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

/** Of each channel by how much another run is further off than this one. */
export function comparisonOf(channels, { name, place, shared }) {
  const names = ['this fit', name];
  const counts = { better: 0, worse: 0, alike: 0 };
  const rows = channels.flatMap((channel) => {
    const other = shared.get(channel);
    if (!other) return [];
    const within = (list) => list.map((value, i) => (channel.in_band[i] && other.in_band[i] ? value : null));
    const [own, theirs] = [channel, other].map(({ gain_modelled: gain, phase_modelled: phase }) => within(squaresOf(channel, { gain, phase })));
    const ratio = ratioOf(theirs, own);
    if (ratio) counts[ratio.lower > 1 ? 'worse' : ratio.upper < 1 ? 'better' : 'alike'] += 1;
    return [el('tr', {}, el('td', {}, channel.recording), el('td', {}, el('code', {}, channel.name)), ratioCell(ratio, place, names[1], names[0]))];
  });
  return el(
    'details',
    {},
    el('summary', {}, `${name}: ${counts.better} channels better than this fit, ${counts.worse} worse, ${counts.alike} that cannot be distinguished`),
    el('div', { class: 'table' }, el('table', {}, el('thead', {}, el('tr', {}, ...['recording', 'channel', `error of ${name} over that of this fit, and its interval of 95 %`].map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...rows))),
  );
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
