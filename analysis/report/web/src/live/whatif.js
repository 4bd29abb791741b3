import { choice, el, tick } from '../dom.js';
import { fit as fitName } from '../line_name.js';
import { inAddress, putInAddress } from '../address.js';
import { fixed, shown } from '../number.js';
import { tellAnswer } from './answers.js';
import { misfitOf, movedMisfit, polar, squaresOf } from './misfit.js';
import { asOptions, inSi, rounded, shareOf, typedValue, valueAt } from './setting.js';
import { linkMotion } from '../viewer/motion.js';
import { covarianceOf, resolved } from './resolved.js';
import { rideTable } from './ride.js';
import { save } from '../tools.js';
import { openVehicle } from './vehicle.js';
import { withValues } from './vehicle_file.js';

const hysteretic = 'Dry friction acts on a mount: steady responses would take time integration, too slow to follow a slider. Modes follow.';
const fullGeometry = () => `The ${fitName} is drawn with the full geometry, this line with small motion about the design pose.`;

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

/** How the links of a scene move in a shape, by the roots of their masses: re, im, re, im ... Coordinates have no weight. */
export function bodily({ links }, shape) {
  const moving = links.filter(({ mass }) => mass > 0);
  return moving.flatMap(({ mass, motion, com, turn }) => {
    const offset = turned(com, turn);
    const parts = [0, 1].map((part) => {
      const m = linkMotion({ motion }, shape.filter((_, k) => k % 2 === part));
      return [m[0] + m[4] * offset[2] - m[5] * offset[1], m[1] + m[5] * offset[0] - m[3] * offset[2], m[2] + m[3] * offset[1] - m[4] * offset[0], m[3], m[4], m[5]];
    });
    return parts[0].flatMap((re, k) => [Math.sqrt(mass) * re, Math.sqrt(mass) * parts[1][k]]);
  });
}

/** A vector turned by a quaternion x y z w. */
function turned([a, b, c], [x, y, z, w]) {
  const [p, q, r] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * p + y * r - z * q, b + w * q + z * p - x * r, c + w * r + x * q - y * p];
}

/** Each mode with the name of the fitted mode that it is most like, which no other takes; `as`: how a shape is compared. */
export function named(modes, fitted, as = (shape) => shape) {
  const likes = fitted.map(({ shape }) => as(shape));
  const pairs = modes.flatMap((mode, i) => {
    const own = as(mode.shape);
    return likes.map((like, k) => ({ i, k, alike: likeness(own, like) }));
  });
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
      squares: this.data.model_error ? squaresOf(channels, answers, this.data.model_error) : { sum: 0, count: 0 },
      coordinates: motion.frequency_Hz.map((_, i) => coordinates.flatMap(({ re, im }) => [re[i], im[i]])),
    };
  }

  /** `wanted`: names of recordings; without: all. */
  at(si, wanted) {
    const responds = this.vehicle.set(si);
    const recordings = this.recordings.filter(({ motion }) => !wanted || wanted.includes(motion.name));
    const responses = responds ? new Map(recordings.map((recording) => [recording.motion.name, this.#answer(recording)])) : null;
    const modes = this.coordinates ? named(this.vehicle.modes(this.coordinates), this.data.scene.modes, (shape) => bodily(this.data.scene, shape)) : [];
    return { responses, modes };
  }

  squares({ responses }) {
    const parts = [...(responses?.values() ?? [])].map(({ squares }) => squares);
    return parts.length ? { sum: parts.reduce((all, { sum }) => all + sum, 0), count: parts.reduce((all, { count }) => all + count, 0) } : null;
  }

  /** Of the whole fit, which begins at that of its page, where the responses alone move; of the responses as recorded where the fit has calibrated them. */
  misfit(squares) {
    if (!squares?.count) return null;
    const { parameters, residuals } = this.data.result;
    const whole = this.whole();
    return whole ? movedMisfit(whole, this.fitted, squares, this.data.overview.expected_squares) : misfitOf([squares], parameters.length, residuals);
  }

  /** Null where the page has none that responses alone would move. */
  whole() {
    const { misfit, expected_squares: expected, is_calibrated: isCalibrated } = this.data.overview ?? {};
    return misfit > 0 && expected > 0 && !isCalibrated && this.fitted?.count ? misfit : null;
  }
}

const percent = (share) => `${fixed(100 * share, 2)}%`;

/** A slider over the bounds with the fit, the start and the interval on its track, and a field for the number. */
function row(parameter, change, type) {
  const { name, unit, value, start, interval_95: interval } = parameter;
  const field = el('input', {
    type: 'text',
    inputMode: 'decimal',
    class: 'number',
    autocomplete: 'off',
    'aria-label': `${name}, ${unit}`,
    title: `a value from ${shown(parameter.lower, 4)} to ${shown(parameter.upper, 4)}, or a change of the fit: -30 %, +10 %, *0.7`,
    onchange: () => type(field.value),
  });
  const slide = (rests) => change(rounded(parameter, valueAt(parameter, Number(slider.value))), rests);
  const slider = el('input', { type: 'range', min: 0, max: 1, step: 'any', 'aria-label': name, oninput: () => slide(false), onchange: () => slide(true) });
  const mark = (of, at) => (at == null ? null : el('i', { class: of, style: { left: percent(shareOf(parameter, at)) } }));
  const band =
    interval?.[0] == null
      ? null
      : el('i', { class: `interval${interval[0] <= parameter.lower ? ' below' : ''}${interval[1] >= parameter.upper ? ' above' : ''}`, style: { left: percent(shareOf(parameter, interval[0])), width: percent(shareOf(parameter, interval[1]) - shareOf(parameter, interval[0])) } });
  const box = el(
    'div',
    { class: 'row', 'data-parameter': name },
    el('label', {}, el('code', {}, name)),
    el('span', {}, field, ' ', unit === '1' ? '' : unit.replace('^2', '\u00b2').replaceAll('*', '\u00b7')),
    el('div', { class: 'track' }, el('span', { class: 'bar' }, band, mark('start', start), mark('value', value)), slider),
  );
  const show = (now, isHeld = false) => {
    box.classList.toggle('held', isHeld);
    slider.value = shareOf(parameter, now);
    slider.setAttribute('aria-valuetext', `${Number(now.toPrecision(5))} ${unit === '1' ? '' : unit}${now === value ? ', as fitted' : ''}`);
    field.value = Number(now.toPrecision(5));
    box.classList.toggle('changed', now !== value);
  };
  return { box, show };
}

/** What the figure of the panel is, beside that of the fit. */
const figureOf = (overview, whole) =>
  whole
    ? 'of the whole fit, as above; here only responses move it, loads at rest and recordings over time stay as fitted'
    : overview?.is_calibrated && overview.misfit
      ? `of the responses alone and without calibrations; the fit\u2019s misfit of ${shown(overview.misfit, 2)} has its instruments calibrated`
      : 'of the responses alone';

/** Modes beside those of the fit: "1.26 \u2192 1.31" where a mode moved. */
function modeRows(modes) {
  const moved = (then, now, text) => (then == null || text(then) === text(now) ? text(now) : [el('span', { class: 'then' }, `${text(then)} \u2192 `), text(now)]);
  return modes
    .filter(({ kind }) => kind !== 'free')
    .map(({ name, frequency_Hz, damping_ratio, of }) =>
      el(
        'tr',
        {},
        el('td', { class: 'name' }, name || 'new'),
        el('td', { class: 'n' }, moved(of?.frequency_Hz, frequency_Hz, (value) => shown(value, 3))),
        el('td', { class: 'n' }, moved(of?.damping_ratio, damping_ratio, (value) => fixed(value, 3))),
      ),
    );
}

/**
 * The panel of sliders. `shownRecording()`: which one is drawn, and follows first. `shut`: called when it is closed.
 * Throws where the browser refuses the program.
 */
export async function openWhatIf(data, shownRecording, shut) {
  const { parameters } = data.live;
  const vehicle = await openVehicle(document.getElementById('program').textContent, data.live.vehicle, data.live.ride?.instruments);
  const car = new Car(vehicle, data);
  const fit = parameters.map(({ value }) => value);
  const settings = { A: [...fit], B: [...fit] };
  const past = [];
  /** What a hand has moved. */
  const held = { A: new Set(), B: new Set() };
  const covariance = covarianceOf(data.result, parameters);
  const confidence = data.result.intervals?.confidence ?? '95 %';
  let others = false;
  let chosen = 'B';
  let before = [...fit];
  let waits = null;
  let frame = null;

  const first = car.at(inSi(parameters, fit));
  car.fitted = car.squares(first);
  const fitted = car.misfit(car.fitted);
  const misfit = el('b', { class: 'misfit' });
  const fault = el('p', { class: 'note', role: 'status' });
  /** What was not taken as it was typed. */
  const said = el('p', { class: 'note calls', role: 'status' });
  const modes = el('tbody');
  const options = el('input', { type: 'text', readOnly: true, 'aria-label': 'options of the program', class: 'options' });
  const undo = el('button', { type: 'button', onclick: () => { if (past.length) take(past.pop(), false); } }, 'undo');
  const ride = rideTable(data.live.ride, vehicle, inSi(parameters, fit), () => ask());
  const rows = parameters.map((parameter, i) => row(parameter, (value, rests) => set(i, value, rests), (text) => type(i, text)));

  const values = () => settings[chosen];

  function answer(rests) {
    frame = null;
    const begin = performance.now();
    try {
      const si = inSi(parameters, values());
      const now = car.at(si, rests ? undefined : [shownRecording()]);
      fault.textContent = now.responses ? (data.result.responses?.some(({ engine }) => engine === 'full') ? fullGeometry() : '') : car.recordings.length ? hysteretic : '';
      // All recordings together weigh the model; while a slider moves, the one in view.
      if (rests && now.responses) misfit.textContent = fromFit(car.misfit(car.squares(now)));
      modes.replaceChildren(...modeRows(now.modes));
      tellAnswer({ ...now, ride: ride.follow(si, rests), rests });
    } catch (error) {
      fault.textContent = `Not possible: ${error.message}`;
    }
    clearTimeout(waits);
    if (!rests) waits = setTimeout(() => answer(true), Math.max(60, 2 * (performance.now() - begin)));
  }
  const fromFit = (now) => (fitted == null ? '' : `${fixed(fitted, 2)} \u2192 ${fixed(now, 2)}`);
  const ask = () => (frame ??= requestAnimationFrame(() => answer(false)));

  function showAll() {
    rows.forEach(({ show }, i) => show(values()[i], others && held[chosen].has(i)));
    options.value = asOptions(parameters, values());
    undo.disabled = !past.length;
    putInAddress('whatif', parameters.flatMap(({ name }, i) => (values()[i] === fit[i] ? [] : [`${name}:${Number(values()[i].toPrecision(6))}`])).join(','));
    putInAddress('held', others ? [...held[chosen]].map((i) => parameters[i].name).join(',') || '-' : null);
  }
  /** The others where the data want them while those that a hand has moved are held. */
  function solveOthers() {
    if (!others || !held[chosen].size) return;
    settings[chosen] = resolved(covariance, parameters, values(), [...held[chosen]]).map((value, k) => (held[chosen].has(k) ? value : rounded(parameters[k], value)));
    rows.forEach(({ show }, k) => show(values()[k], held[chosen].has(k)));
  }
  function type(i, text) {
    const { value, said: words = '' } = typedValue(parameters[i], text);
    if (value == null) rows[i].show(values()[i], others && held[chosen].has(i));
    else set(i, value, true);
    said.textContent = value == null ? `${words} ${parameters[i].name} stays ${Number(values()[i].toPrecision(5))}.` : words;
  }
  function set(i, value, rests) {
    said.textContent = '';
    values()[i] = value;
    held[chosen].add(i);
    rows[i].show(value, others);
    solveOthers();
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
    held[chosen] = new Set(list.flatMap((value, i) => (value === fit[i] || others ? [] : [i])));
    before = [...list];
    said.textContent = '';
    showAll();
    ask();
  }
  async function copy() {
    options.select();
    await navigator.clipboard?.writeText(options.value).catch(() => {});
  }

  function saveVehicle() {
    const changed = parameters.map((parameter, i) => ({ ...parameter, value: Number(values()[i].toPrecision(8)) }));
    save('vehicle_whatif.urdf', 'application/xml', withValues(data.live.file, changed.filter((_, i) => values()[i] !== fit[i])));
  }

  const split = parameters.findIndex((parameter) => !('interval_95' in parameter));
  const boxes = rows.map(({ box }) => box);
  const further = split < 0 ? [] : boxes.slice(split);
  const panel = el(
    'aside',
    { class: 'whatif', 'aria-label': 'What if', onkeydown: (event) => event.key === 'Escape' && close() },
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
    fitted == null ? null : el('p', { class: 'figure', title: figureOf(data.overview, car.whole()) }, car.whole() ? 'misfit ' : 'misfit of responses as recorded ', misfit),
    fault,
    said,
    covariance
      ? tick('others follow the data', inAddress('held') != null, (on) => {
          others = on;
          if (on) past.push([...values()]);
          if (on && !held[chosen].size) said.textContent = 'Move a slider: it is held there, and all others follow.';
          else if (on && held[chosen].size === parameters.length) said.textContent = 'Every parameter was moved, so none can follow; reset, then move one.';
          else said.textContent = '';
          solveOthers();
          before = [...values()];
          showAll();
          ask();
        })
      : null,
    el(
      'div',
      { class: 'given' },
      el('div', { class: 'rows' }, ...(split < 0 ? boxes : boxes.slice(0, split))),
      further.length ? el('details', { open: split === 0 }, el('summary', {}, split === 0 ? 'parameters' : 'not fitted'), el('div', { class: 'rows' }, ...further)) : null,
    ),
    el(
      'div',
      { class: 'found' },
      ride.box,
      el('table', { class: 'modes' }, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'mode'), ...['Hz', 'damping'].map((head) => el('th', { class: 'n', scope: 'col' }, head)))), modes),
    ),
    el('div', { class: 'copy' }, options, el('button', { type: 'button', onclick: copy }, 'copy')),
    data.histories?.length ? el('p', { class: 'note' }, 'Curves over time stay those of the fit: this page does not have the motion of the posts that they take.') : null,
    data.live.file ? el('div', { class: 'copy' }, el('button', { type: 'button', onclick: saveVehicle }, 'save as vehicle file')) : null,
    el('p', { class: 'note' }, split === 0 ? 'On each track: dot the value of the file.' : `On each track: dot the fit, line the start, band the interval of ${confidence}. Where others follow the data, those that you moved are held, and all others go where the data want them, to first order about the fit.`),
  );
  function close() {
    clearTimeout(waits);
    if (frame) cancelAnimationFrame(frame);
    panel.remove();
    putInAddress('whatif', null);
    putInAddress('held', null);
    putInAddress('road', null);
    shut();
    tellAnswer(null);
  }
  misfit.textContent = fromFit(fitted);
  // Of a link that was handed on.
  for (const [name, value] of (inAddress('whatif') ?? '').split(',').map((pair) => pair.split(':'))) {
    const i = parameters.findIndex((parameter) => parameter.name === name);
    if (i < 0) continue;
    const typed = typedValue(parameters[i], value ?? '');
    if (typed.said) said.textContent = typed.said;
    if (typed.value == null) continue;
    values()[i] = typed.value;
    if (typed.value !== fit[i]) held[chosen].add(i);
  }
  // Of those that followed none was held.
  if (covariance && inAddress('held') != null) {
    others = true;
    const names = inAddress('held').split(',');
    held[chosen] = new Set(parameters.flatMap(({ name }, i) => (names.includes(name) ? [i] : [])));
  }
  before = [...values()];
  showAll();
  modes.replaceChildren(...modeRows(first.modes));
  return { panel, answer: () => answer(true) };
}
