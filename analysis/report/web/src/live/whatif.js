import { choice, el } from '../dom.js';
import { fixed, shown } from '../number.js';
import { tellAnswer } from './answers.js';
import { misfitOf, polar, squaresOf } from './misfit.js';
import { asOptions, inSi, rounded, shareOf, valueAt } from './setting.js';
import { openVehicle } from './vehicle.js';

const hysteretic = 'Dry friction acts on a mount: steady responses would take time integration, too slow to follow a slider. Modes follow.';
const fullGeometry = 'The fit is drawn with the full geometry, this line with small motion about the design pose.';

/** Whether this page can follow other values, as far as is known before the program is asked. */
export const canFollow = (data) =>
  data.live != null && document.getElementById('program') != null && typeof WebAssembly === 'object' && typeof DecompressionStream === 'function';

/** Of a list of complex numbers re, im, ... how alike two are, 0 to 1, whatever their phase and size. */
export function likeness(a, b) {
  let [re, im, aa, bb] = [0, 0, 0, 0];
  for (let k = 0; k + 1 < a.length; k += 2) {
    re += a[k] * b[k] + a[k + 1] * b[k + 1];
    im += a[k] * b[k + 1] - a[k + 1] * b[k];
    aa += a[k] ** 2 + a[k + 1] ** 2;
    bb += b[k] ** 2 + b[k + 1] ** 2;
  }
  return aa && bb ? (re * re + im * im) / (aa * bb) : 0;
}

/** Each mode with the name of the fitted mode that it is most like, which no other takes. */
export function named(modes, fitted) {
  const pairs = modes.flatMap((mode, i) => fitted.map((like, k) => ({ i, k, alike: likeness(mode.shape, like.shape) })));
  const names = new Array(modes.length).fill(null);
  const taken = new Set();
  for (const { i, k } of pairs.sort((a, b) => b.alike - a.alike)) {
    if (names[i] != null || taken.has(k)) continue;
    names[i] = k;
    taken.add(k);
  }
  return modes.map((mode, i) => ({ ...mode, of: fitted[names[i]] ?? null, name: fitted[names[i]]?.name ?? '' }));
}

/** The car at values of its own: what it answers to the recorded motions of the posts. */
class Car {
  constructor(vehicle, data) {
    this.vehicle = vehicle;
    this.data = data;
    this.places = new Map(data.scene.sensors.map(({ name }, i) => [name, i]));
    this.coordinates = data.scene.modes[0]?.shape.length / 2 || 0;
    this.recordings = data.scene.motions.map((motion) => ({ motion, channels: (data.responses ?? []).filter(({ recording }) => recording === motion.name) }));
  }

  /** Of one recording: {gain, phase, mean} by channel, and the motion of the coordinates at each frequency. */
  #answer({ motion, channels }) {
    const all = this.vehicle.response(motion.posts, motion.frequency_Hz, motion.amplitude_m);
    const answers = channels.map(({ name }) => {
      const channel = all[this.places.get(name)];
      return { ...polar(channel), mean: Array.from(channel.mean, (value) => (Number.isFinite(value) ? value : null)) };
    });
    const coordinates = all.slice(this.places.size);
    return {
      answers,
      squares: squaresOf(channels, answers, this.data.model_error),
      coordinates: motion.frequency_Hz.map((_, i) => coordinates.flatMap(({ re, im }) => [re[i], im[i]])),
    };
  }

  /** `wanted`: names of recordings; without: all. */
  at(si, wanted) {
    const responds = this.vehicle.set(si);
    const recordings = this.recordings.filter(({ motion }) => !wanted || wanted.includes(motion.name));
    const responses = responds ? new Map(recordings.map((recording) => [recording.motion.name, this.#answer(recording)])) : null;
    const modes = this.coordinates ? named(this.vehicle.modes(this.coordinates), this.data.scene.modes) : [];
    return { responses, modes };
  }

  misfit({ responses }) {
    if (!responses?.size) return null;
    const { parameters, residuals } = this.data.result;
    return misfitOf([...responses.values()].map(({ squares }) => squares), parameters.length, residuals);
  }
}

const percent = (share) => `${fixed(100 * share, 2)}%`;

/** A slider over the bounds with the fit, the start and the interval on its track, and a field for the number. */
function row(parameter, change) {
  const { name, unit, value, start, interval_95: interval } = parameter;
  const field = el('input', { type: 'number', step: 'any', 'aria-label': `${name}, ${unit}`, onchange: () => Number.isFinite(field.valueAsNumber) && change(field.valueAsNumber, true) });
  const slide = (rests) => change(rounded(parameter, valueAt(parameter, Number(slider.value))), rests);
  const slider = el('input', { type: 'range', min: 0, max: 1, step: 'any', 'aria-label': name, oninput: () => slide(false), onchange: () => slide(true) });
  const mark = (of, at) => (at == null ? null : el('i', { class: of, style: { left: percent(shareOf(parameter, at)) } }));
  const band =
    interval?.[0] == null
      ? null
      : el('i', { class: 'interval', style: { left: percent(shareOf(parameter, interval[0])), width: percent(shareOf(parameter, interval[1]) - shareOf(parameter, interval[0])) } });
  const box = el(
    'div',
    { class: 'row', 'data-parameter': name },
    el('label', {}, el('code', {}, name)),
    el('span', {}, field, ' ', unit === '1' ? '' : unit.replace('^2', '\u00b2').replaceAll('*', '\u00b7')),
    el('div', { class: 'track' }, el('span', { class: 'bar' }, band, mark('start', start), mark('value', value)), slider),
  );
  const show = (now) => {
    slider.value = shareOf(parameter, now);
    field.value = Number(now.toPrecision(5));
    box.classList.toggle('changed', now !== value);
  };
  return { box, show };
}

/** Modes beside those of the fit. */
function modeRows(modes) {
  const change = (now, then) => {
    const percents = 100 * (now / then - 1);
    return Math.abs(percents) >= 0.05 ? `${percents < 0 ? '' : '+'}${fixed(percents, 1)} %` : '';
  };
  return modes
    .filter(({ kind }) => kind !== 'free')
    .map(({ name, frequency_Hz, damping_ratio, of }) =>
      el(
        'tr',
        {},
        el('td', { class: 'name' }, name || 'new'),
        el('td', { class: 'n' }, shown(frequency_Hz, 3)),
        el('td', { class: 'n' }, change(frequency_Hz, of?.frequency_Hz)),
        el('td', { class: 'n' }, fixed(damping_ratio, 3)),
      ),
    );
}

/**
 * The panel of sliders. `shownRecording()`: which one is drawn, and follows first. `shut`: called when it is closed.
 * Throws where the browser refuses the program.
 */
export async function openWhatIf(data, shownRecording, shut) {
  const { parameters } = data.live;
  const car = new Car(await openVehicle(document.getElementById('program').textContent, data.live.vehicle), data);
  const fit = parameters.map(({ value }) => value);
  const settings = { A: [...fit], B: [...fit] };
  const past = [];
  let chosen = 'B';
  let before = [...fit];
  let waits = null;
  let frame = null;

  const first = car.at(inSi(parameters, fit));
  const fitted = car.misfit(first);
  const misfit = el('b', { class: 'misfit' });
  const fault = el('p', { class: 'note', role: 'status' });
  const modes = el('tbody');
  const options = el('input', { type: 'text', readOnly: true, 'aria-label': 'options of the program', class: 'options' });
  const undo = el('button', { type: 'button', onclick: () => { if (past.length) take(past.pop(), false); } }, 'undo');
  const rows = parameters.map((parameter, i) => row(parameter, (value, rests) => set(i, value, rests)));

  const values = () => settings[chosen];

  function answer(rests) {
    frame = null;
    const begin = performance.now();
    try {
      const now = car.at(inSi(parameters, values()), rests ? undefined : [shownRecording()]);
      fault.textContent = now.responses ? (data.result.responses?.some(({ engine }) => engine === 'full') ? fullGeometry : '') : hysteretic;
      // All recordings together weigh the model; while a slider moves, the one in view.
      if (rests && now.responses) misfit.textContent = fromFit(car.misfit(now));
      modes.replaceChildren(...modeRows(now.modes));
      tellAnswer({ ...now, rests });
    } catch (error) {
      fault.textContent = `Not possible: ${error.message}`;
    }
    clearTimeout(waits);
    if (!rests) waits = setTimeout(() => answer(true), Math.max(60, 2 * (performance.now() - begin)));
  }
  const fromFit = (now) => (fitted == null ? '' : `${fixed(fitted, 2)} \u2192 ${fixed(now, 2)}`);
  const ask = () => (frame ??= requestAnimationFrame(() => answer(false)));

  function showAll() {
    rows.forEach(({ show }, i) => show(values()[i]));
    options.value = asOptions(parameters, values());
    undo.disabled = !past.length;
  }
  function set(i, value, rests) {
    values()[i] = value;
    rows[i].show(value);
    if (rests) {
      if (before.some((one, k) => one !== values()[k])) past.push(before);
      before = [...values()];
      showAll();
    }
    ask();
  }
  function take(list, remember = true) {
    if (remember) past.push([...values()]);
    settings[chosen] = [...list];
    before = [...list];
    showAll();
    ask();
  }
  async function copy() {
    options.select();
    await navigator.clipboard?.writeText(options.value).catch(() => {});
  }

  const split = parameters.findIndex((parameter) => !('interval_95' in parameter));
  const boxes = rows.map(({ box }) => box);
  const others = split < 0 ? [] : boxes.slice(split);
  const panel = el(
    'aside',
    { class: 'whatif', 'aria-label': 'What if' },
    el(
      'div',
      { class: 'head' },
      el('h3', {}, 'What if'),
      choice('setting', [['A', 'A'], ['B', 'B']], chosen, (name) => {
        chosen = name;
        before = [...values()];
        past.length = 0;
        showAll();
        ask();
      }),
      undo,
      el('button', { type: 'button', onclick: () => take(fit) }, 'reset'),
      el('button', { type: 'button', onclick: close, 'aria-label': 'close' }, '\u00d7'),
    ),
    fitted == null ? null : el('p', { class: 'figure' }, 'misfit of responses ', misfit),
    fault,
    el('div', { class: 'rows' }, ...(split < 0 ? boxes : boxes.slice(0, split))),
    others.length ? el('details', {}, el('summary', {}, 'not fitted'), el('div', { class: 'rows' }, ...others)) : null,
    el('table', {}, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'mode'), ...['Hz', '', '\u03b6'].map((head) => el('th', { class: 'n', scope: 'col' }, head)))), modes),
    el('div', { class: 'copy' }, options, el('button', { type: 'button', onclick: copy }, 'copy')),
    el('p', { class: 'note' }, 'On each track: dot the fit, line the start, band the interval of 95 %.'),
  );
  function close() {
    clearTimeout(waits);
    if (frame) cancelAnimationFrame(frame);
    panel.remove();
    tellAnswer(null);
    shut();
  }
  misfit.textContent = fromFit(fitted);
  showAll();
  modes.replaceChildren(...modeRows(first.modes));
  return { panel, answer: () => answer(true) };
}
