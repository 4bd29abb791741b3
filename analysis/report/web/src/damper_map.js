import { el, svg } from './dom.js';
import { listOf, shown } from './number.js';
import { axesOf, mark, path, rangeAround } from './svg_plot.js';
import { still, tools } from './tools.js';

/** Cycles of all recordings, each as an object. */
function cyclesOf(equivalents) {
  return listOf(equivalents)
    .flatMap((one) =>
      listOf(one.frequency_Hz).map((frequency, i) => ({
        recording: one.recording,
        frequency,
        amplitude: 1000 * one.amplitude_m[i],
        damping: [one.damping_measured_Nspm[i], one.damping_modelled_Nspm[i]],
        stiffness: [one.stiffness_measured_Npm[i] / 1000, one.stiffness_modelled_Npm[i] / 1000],
        // Of the first harmonic: W = pi c w X^2, J.
        work: [one.damping_measured_Nspm[i], one.damping_modelled_Nspm[i]].map((c) => 2 * Math.PI ** 2 * c * frequency * one.amplitude_m[i] ** 2),
      })),
    )
    .filter(({ frequency, amplitude }) => frequency > 0 && amplitude > 0);
}

const quantities = {
  damping: ['Equivalent damping', 'N\u00b7s/m'],
  stiffness: ['Dynamic stiffness', 'kN/m'],
  work: ['Work of a cycle', 'J'],
};

/** `further`: columns of its numbers beside recording, frequency and amplitude of each cycle. */
function box(title, unit, picture, cycles, further) {
  const frame = el('div', { class: 'chart' });
  const columns = () => [
    { name: 'recording', values: cycles.map(({ recording }) => recording) },
    { name: 'frequency [Hz]', values: cycles.map(({ frequency }) => frequency) },
    { name: 'amplitude [mm]', values: cycles.map(({ amplitude }) => amplitude) },
    ...further,
  ];
  frame.append(el('h3', {}, title, el('span', {}, unit), tools(frame, title, [still(picture, columns)])), el('div', { class: 'picture' }, picture));
  return frame;
}

/** A quantity of each cycle over frequency, measured and modelled; those of other recordings than `name` are pale. */
function overFrequency(cycles, quantity, width, name) {
  const [title, unit] = quantities[quantity];
  const of = (k) => cycles.map((cycle) => cycle[quantity][k]);
  const { picture, at } = axesOf({
    x: { ...rangeAround(cycles.map(({ frequency }) => frequency), { logarithmic: true }), label: 'Hz' },
    y: { ...rangeAround([...of(0), ...of(1)], { logarithmic: [...of(0), ...of(1)].every((value) => value > 0) }), label: '' },
    width,
    height: 240,
    name: `${title}, ${unit}, over frequency, measured and modelled`,
  });
  for (const cycle of cycles) {
    const words = `${cycle.recording}: ${shown(cycle.frequency, 3)} Hz, ${shown(cycle.amplitude, 3)} mm: model ${shown(cycle[quantity][1], 4)}, measured ${shown(cycle[quantity][0], 4)} ${unit}`;
    const [a, b] = cycle[quantity].map((value) => at(cycle.frequency, value));
    const marks = svg('g', { opacity: !name || cycle.recording === name ? 1 : 0.25 }, path([a, b], { colour: 'var(--muted)', width: 0.8 }), mark(a, { colour: 'var(--measured)', words }), mark(b, { colour: 'var(--model)', ring: true, radius: 3.5, words }));
    picture[cycle.recording === name ? 'append' : 'prepend'](marks);
  }
  return box(title, `${unit} over Hz`, picture, cycles, ['measured', 'modelled'].map((kind, k) => ({ name: `${kind} [${unit}]`, values: of(k) })));
}

/** Error of a cycle: the model's dynamic force, with its phase, less the measured one, as a share of that. */
export function errorOf({ frequency, damping: [c0, c1], stiffness: [k0, k1] }) {
  const parts = (c, k) => {
    const across = (2 * Math.PI * frequency * c) / 1000;
    return [Math.sqrt(Math.max(0, k * k - across * across)), across];
  };
  const [a, b] = [parts(c0, k0), parts(c1, k1)];
  return Math.hypot(b[0] - a[0], b[1] - a[1]) / k0;
}

/** Where over frequency and amplitude the model is off: the larger and redder, the more. */
function errorMap(cycles, width, choose) {
  const { picture, at } = axesOf({
    x: { ...rangeAround(cycles.map(({ frequency }) => frequency), { logarithmic: true }), label: 'Hz' },
    y: { ...rangeAround(cycles.map(({ amplitude }) => amplitude), { logarithmic: true }), label: '' },
    width,
    height: 240,
    name: 'error of the force of each cycle over its frequency and amplitude',
  });
  for (const cycle of [...cycles].sort((a, b) => errorOf(b) - errorOf(a))) {
    const error = errorOf(cycle);
    const strength = Math.min(100, Math.round(100 * Math.sqrt(error / 0.3)));
    const words = `${cycle.recording}: ${shown(cycle.frequency, 3)} Hz, ${shown(cycle.amplitude, 3)} mm: off by ${shown(100 * error, 2)} %`;
    picture.append(mark(at(cycle.frequency, cycle.amplitude), { colour: `color-mix(in srgb, var(--poor) ${strength}%, var(--good))`, radius: 3 + 9 * Math.min(1, error / 0.3), words, onclick: () => choose(cycle.recording) }));
  }
  return box('Error of the force', '%, area and hue, by mm over Hz', picture, cycles, [{ name: 'error [%]', values: cycles.map((cycle) => 100 * errorOf(cycle)) }]);
}

/** Equivalents of a damper's cycles, those of recording `name` before the others; `choose`: shows a recording. */
export function drawEquivalents(place, equivalents, name, choose) {
  const cycles = cyclesOf(equivalents);
  place.replaceChildren();
  if (!cycles.length) return;
  const room = place.clientWidth || 1120;
  const width = room < 640 ? room : Math.min(560, room / 2 - 12);
  const worst = cycles.reduce((most, cycle) => (errorOf(cycle) > errorOf(most) ? cycle : most));
  place.append(
    el('p', { class: 'note' }, `Each cycle as a spring beside a dashpot, of the first harmonics of force and extension: dots measured, rings the model. Largest error ${shown(100 * errorOf(worst), 2)} % at ${shown(worst.frequency, 3)} Hz and ${shown(worst.amplitude, 3)} mm (${worst.recording}). A mark of the map leads to its recording.`),
    el('div', { class: 'charts wide' }, errorMap(cycles, width, choose), ...Object.keys(quantities).map((quantity) => overFrequency(cycles, quantity, width, name))),
  );
}
