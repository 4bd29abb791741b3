import uPlot from 'uplot';
import { inAddress, putInAddress } from './address.js';
import { choice, el, tick } from './dom.js';
import { comparisonOf, dataOf, lineOf, parametersOf, sharedWith, takeFiles } from './dropped.js';
import { onFocus } from './focus.js';
import { readable } from './histories.js';
import { legend } from './legend.js';
import { fit as fitName } from './line_name.js';
import { onAnswer } from './live/answers.js';
import { canFollow, openWhatIf } from './live/whatif.js';
import { listOf } from './number.js';
import { fittedBand } from './residuals.js';
import { inPairs } from './paired_cards.js';
import { isWeighed, weighed } from './residual_strip.js';
import { card } from './response_card.js';
import { onPaper, runLine } from './theme.js';

/** Start, where it is wanted, fit, or the car of a file that was not fitted, and the place of what a car of other values would do. */
function linesOf(channel, withStart, withWhatIf) {
  const start = { label: 'start', colour: 'start', dash: [4, 3], width: 1.2, gain: channel.gain_start, phase: channel.phase_start, read: false, counts: false };
  const fit = { label: fitName, colour: 'model', gain: channel.gain_modelled, phase: channel.phase_modelled, mean: channel.mean_modelled };
  const none = channel.gain_measured.map(() => null);
  const whatIf = { label: 'what if', colour: 'whatif', width: 1.8, gain: none, phase: none, mean: none };
  return [...(withStart ? [start] : []), fit, ...(withWhatIf ? [whatIf] : [])];
}

/** What 0 dB stands for, by the units of the channels: accelerations are relative to that of the post, all else to its motion. */
export function zeroDecibel(units) {
  const known = { 'm/s^2': 'acceleration equal to that of the post', m: 'displacement equal to its motion', N: 'force of 1 N per m of its motion' };
  return `0 dB: ${[...new Set(units)].map((unit) => known[unit] ?? `1 ${readable(unit)[1]} per m of its motion`).join(', ')}.`;
}

/** Left and right of a pair beside each other. */
function placeIn(charts, cards) {
  const boxes = cards.map(({ box }) => ({ name: box.dataset.channel, box }));
  const pairs = inPairs(boxes);
  charts.classList.toggle('paired', pairs != null);
  charts.replaceChildren(...(pairs ?? boxes).map(({ box }) => box));
}

/** The charts of a recording below the others. */
function printed(name, cards, place) {
  const charts = el('div', { class: 'charts' });
  placeIn(charts, cards);
  const part = el('div', {}, el('h3', {}, name), charts);
  place.append(part);
  for (const { draw } of cards) draw();
  return part;
}

/** Bode charts of every channel of one recording, with one cursor for all. */
export function drawResponses(place, data) {
  const recordings = [...new Set(data.responses.map((channel) => channel.recording))];
  const hasStart = data.responses.some((channel) => channel.gain_start?.some((value) => value != null));
  const hasBars = data.responses.some((channel) => channel.gain_sd?.some((value) => value != null));
  const hasAreas = data.responses.some((channel) => channel.gain_bands);
  const isMeasured = data.responses.some(({ gain_measured }) => gain_measured.some((value) => value != null));
  const band = (isMeasured && fittedBand(data.result.band_Hz, data.responses)) || [0, Infinity];
  const hasBand = band[0] > 0;
  const all = weighed(data.responses, data.model_error);
  const hasStrips = all.some((channel) => isWeighed({ ...channel, lines: linesOf(channel) }));
  const known = (name) => (recordings.includes(name) ? name : null);
  const state = { recording: known(inAddress('recording')) ?? recordings[0], start: hasStart, whatIf: false, answer: null, others: [], axes: inAddress('axes') === 'all' ? 'all' : 'band' };
  const charts = el('div', { class: 'charts' });
  const pair = el('div', {}, charts);
  let cards = [];

  const cardsOf = (recording) => {
    const sync = uPlot.sync(`responses ${recording}`);
    return all
      .filter((channel) => channel.recording === recording)
      .map((channel) => card({ ...channel, lines: [...linesOf(channel, state.start, state.whatIf), ...state.others.flatMap((other) => (other.shared.has(channel) ? [lineOf(other, other.shared.get(channel))] : []))] }, hasBand ? [band] : [], sync, state.axes === 'band' && hasBand ? band : null));
  };
  /** After a cell of a map led to some frequencies. */
  const back = el('button', { type: 'button', class: 'back', hidden: true, onclick: () => redraw() }, 'show the whole range again');
  const redraw = () => {
    back.hidden = true;
    cards = cardsOf(state.recording);
    placeIn(charts, cards);
    for (const { draw } of cards) draw();
    if (state.answer) follow(state.answer);
  };
  const follow = (answer) => {
    state.answer = answer;
    const found = answer?.responses?.get(state.recording);
    if (state.whatIf) cards.forEach(({ follow: show }, i) => show(found?.answers[i] ?? null, answer?.rests ?? true));
  };
  const controls = el('div', { class: 'controls' });
  const recording = choice('recording', recordings.map((name) => [name, name]), state.recording, (name) => {
    state.recording = name;
    putInAddress('recording', name === recordings[0] ? null : name);
    redraw();
  });
  if (recordings.length > 1) controls.append(recording);
  if (hasStart)
    controls.append(
      tick('start', state.start, (on) => {
        state.start = on;
        redraw();
      }),
    );
  if (hasBand)
    controls.append(
      choice('axes', [['band', 'fitted band'], ['all', 'all frequencies']], state.axes, (axes) => {
        state.axes = axes;
        putInAddress('axes', axes === 'all' ? axes : null);
        redraw();
      }),
    );
  const marks = (withWhatIf) =>
    legend(
      ...(isMeasured ? [['dot', 'measured', hasBars ? 'measured, bars: 95 %' : 'measured']] : []),
      ['line', 'model', fitName],
      ...(withWhatIf ? [['line', 'whatif', 'what if']] : []),
      ...state.others.map(({ name, place }) => [runLine(place), runLine(place).colour, name]),
      ...(hasStart ? [['dash', 'start', 'start']] : []),
      ...(hasAreas ? [['patch', 'model', 'bands of 95 %: inner, of the parameters; outer, of new measured points']] : []),
      ...(hasBand ? [['patch', 'line', 'not fitted']] : []),
      ...(hasStrips ? [['line', 'model', 'residual along (gain)'], ['dash', 'model', 'across (phase)'], ['patch', 'strip', '\u00b12 sd']] : []),
    );
  const key = el('div', {}, marks(false));
  const show = (on) => {
    state.whatIf = on;
    state.answer = null;
    key.replaceChildren(marks(on));
    pair.classList.toggle('beside', on);
    redraw();
  };
  onFocus(({ recording: name, channel, low, high }) => {
    if (!known(name)) return;
    if (name !== state.recording) recording.select(name);
    const found = cards.find(({ box }) => box.dataset.channel === channel);
    if (!found) return;
    // A little more than the octave, and its neighbours' beginnings.
    if (low) for (const one of cards) one.show(low / 1.15, high * 1.15);
    if (low) back.hidden = false;
    // Charts have their heights from the next frame on.
    requestAnimationFrame(() => found.box.scrollIntoView({ block: 'center' }));
    found.box.classList.add('found');
    setTimeout(() => found.box.classList.remove('found'), 1600);
  });
  const compared = el('div');
  const message = el('p', { class: 'note', role: 'status' });
  const redrawAll = () => {
    key.replaceChildren(marks(state.whatIf));
    redraw();
  };
  const add = (one) => {
    const { box, words } = comparisonOf(all, one, () => {
      state.others = state.others.filter((other) => other !== one);
      box.remove();
      message.textContent = `${one.name} is removed.`;
      redrawAll();
    });
    state.others.push(one);
    compared.append(box);
    return `Compared with ${words}${one.parameters.length ? `; ${one.parameters.length} parameters side by side` : ''}.`;
  };
  const freePlace = () => [2, 3, 4, 5].find((place) => state.others.every((other) => other.place !== place)) ?? 2;
  const take = async (files) => {
    const words = [];
    for (const file of files) {
      try {
        const other = dataOf(await file.text());
        const ofFile = [file.name.replace(/\.html$/, ''), other.result?.study?.replace(/\.ya?ml$/, '')].filter((part) => part && part !== 'report').join(' ') || 'other';
        const taken = (name) => name === data.result?.study?.replace(/\.ya?ml$/, '') || state.others.some((one) => one.name === name);
        const name = taken(ofFile) ? `${ofFile} (${state.others.length + 2})` : ofFile;
        const place = freePlace();
        const parameters = parametersOf(listOf(data.result?.parameters), listOf(other.result?.parameters), place, data.live?.parameters);
        const one = { name, place, shared: sharedWith(all, other.responses), parameters };
        if (!one.shared.size) throw new Error('it has no channel that was measured alike');
        words.push(add(one));
      } catch (error) {
        words.push(`${file.name} is not compared: ${error.message}.`);
      }
    }
    message.textContent = words.join(' ');
    redrawAll();
    message.scrollIntoView({ block: 'center' });
  };
  if (isMeasured) controls.append(takeFiles(take));
  // On paper every recording.
  let others = [];
  onPaper((isOn) => {
    for (const one of others) one.remove();
    others = isOn ? recordings.filter((name) => name !== state.recording).map((name) => printed(name, cardsOf(name), place)) : [];
  });
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
        sliders.querySelector('input[type=range]').focus({ preventScroll: true });
      } catch (error) {
        // The page stays what it is without.
        opener.replaceWith(el('span', { class: 'note' }, `This browser does not follow other values: ${error.message}`));
      }
    });
    controls.append(opener);
    if (inAddress('whatif')) opener.click();
    onAnswer((answer) => {
      if (answer) follow(answer);
    });
  }
  controls.append(back);
  place.append(
    controls,
    message,
    compared,
    key,
    el('p', { class: 'note' }, `Gain in dB, phase in degrees${isMeasured ? ' and, where it was measured, mean offset in mm,' : ''} over frequency in Hz. ${zeroDecibel(data.responses.map(({ unit }) => unit))} ${isMeasured ? 'The cursor shows model/measured. ' : ''}Drag to zoom all charts, double-click to reset.${hasStrips ? ' Below them residuals in standard deviations, of noise and stated model error: within \u00b12 are 95 % of them where the model explains the data.' : ''}`),
    pair,
  );
  redraw();
}
