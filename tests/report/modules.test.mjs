// What the page's scripts compute, without a browser.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';
import { root } from './browser.mjs';

const source = (name) => import(pathToFileURL(join(root, 'analysis', 'report', 'web', 'src', name)).href);
const { extent, fixed, logTicks, multiples, niceStep, shown } = await source('number.js');
const { between, coordinatesAt, framesOf, greatestMotion, greatestOf, linkMotion, phasors, stationAt } = await source('viewer/motion.js');
const { forcesOf } = await source('viewer/forces.js');
const { plainColour } = await source('standing.js');
const { movePlayhead, onPlayhead, playhead } = await source('playhead.js');
const { runLine } = await source('theme.js');

describe('numbers', () => {
  test('have significant digits and a minus sign', () => {
    assert.equal(shown(1.8432, 3), '1.84');
    assert.equal(shown(-0.031, 2), '\u22120.031');
    assert.equal(shown(14123.4, 3), '14\u2009123');
    assert.equal(shown(-1234567, 3), '\u22121\u2009234\u2009567');
    assert.equal(fixed(12345.678, 2), '12\u2009345.68');
    assert.equal(shown(1.5e-7, 2), '1.5\u00b710\u207b\u2077');
    assert.equal(shown(null), '\u2013');
    assert.equal(fixed(-0.001, 2), '0.00');
  });

  test('make axes', () => {
    assert.equal(niceStep(10, 5), 2);
    assert.equal(niceStep(0.9, 5), 0.2);
    assert.deepEqual(multiples(-0.9, 1.1, 0.5), [-0.5, 0, 0.5, 1]);
    assert.deepEqual(extent([null, 3, -1], [7, NaN]), [-1, 7]);
    assert.equal(extent([null]), null);
  });

  test('mark a logarithmic axis twice at least, however short it is', () => {
    assert.deepEqual(logTicks(0.5, 30), [0.5, 1, 2, 5, 10, 20]);
    assert.deepEqual(logTicks(675e3, 1.14e6), [7e5, 8e5, 9e5, 1e6, 1.1e6]);
    assert.deepEqual(logTicks(1, 1e6), [1, 10, 100, 1e3, 1e4, 1e5, 1e6]);
    for (let ratio = 1.01; ratio < 1e9; ratio *= 1.07)
      for (const low of [1e-3, 0.7, 1.9, 123456]) {
        const count = logTicks(low, low * ratio).length;
        assert.ok(count >= 2 && count <= 14, `${count} marks from ${low} to ${low * ratio}`);
      }
  });
});

describe('motion', () => {
  // One link, one coordinate: up by 1 and about y by 2 per unit.
  const link = { motion: [0, 0, 1, 0, 2, 0] };

  test('is the real part of a turning phasor', () => {
    // Of 3 + 4i a quarter of a cycle on: -4.
    assert.ok(Math.abs(coordinatesAt([3, 4], Math.PI / 2)[0] + 4) < 1e-15);
    assert.deepEqual([...linkMotion(link, [0.5])], [0, 0, 0.5, 0, 1, 0]);
  });

  test('is greatest where the turn adds to the rise', () => {
    // A point 1 m behind the origin rises by 1 + 2, and 0.1 m above it moves by 0.2 along x.
    const greatest = greatestMotion({ links: [link] }, [1, 0], [[[-1, 0, 0.1]]]);
    assert.ok(Math.abs(greatest - Math.hypot(3, 0.2)) < 1e-12);
  });

  test('over time is told by steps of a unit, and goes straight between frames', () => {
    const column = (unit, ...steps) => ({ unit, steps });
    const frames = framesOf({ frames: 3, coordinates: [column(0.5, 0, 4, -2), column(0, 0, 0, 0)], posts: [column(0.001, 10, 0, 0)] });
    assert.deepEqual(frames.coordinates.map((row) => [...row]), [[0, 0], [2, 0], [-1, 0]]);
    const at = (time) => [...between(frames.coordinates, time, 2)];
    assert.deepEqual(at(0), [0, 0]);
    assert.deepEqual(at(0.25), [1, 0]);
    assert.deepEqual(at(0.75), [0.5, 0]);
    // Before and after it stands.
    assert.deepEqual(at(-1), [0, 0]);
    assert.deepEqual(at(9), [-1, 0]);
    assert.deepEqual([...between([[7]], 3, 2)], [7]);
    assert.equal(greatestOf({ links: [link] }, frames.coordinates.map((row) => [row[0]]), [[[0, 0, 0]]]), 2);
  });

  test('of a response has posts that move as a sine', () => {
    const motion = { amplitude_m: [0.01], coordinates: [[1, 0]], posts: [1, -1] };
    const { coordinates, posts } = phasors({ posts: [{}, {}] }, { kind: 'response', motion }, 0);
    // A coordinate that follows the post has its phasor.
    const at = (pair, phase) => pair[0] * Math.cos(phase) - pair[1] * Math.sin(phase);
    for (const phase of [0, 0.7, 2]) {
      assert.ok(Math.abs(at(posts[0], phase) - 0.01 * Math.sin(phase)) < 1e-17);
      assert.ok(Math.abs(at(posts[1], phase) + 0.01 * Math.sin(phase)) < 1e-17);
      assert.ok(Math.abs(at(coordinates, phase) - at(posts[0], phase)) < 1e-17);
    }
  });
});

describe('lines of runs', () => {
  test('are told apart by colour and dashes, the first broad below the others', () => {
    const lines = Array.from({ length: 12 }, (_, i) => JSON.stringify(runLine(i)));
    assert.equal(new Set(lines).size, 12);
    assert.equal(runLine(0).dash, undefined);
    assert.equal(runLine(6).colour, runLine(0).colour);
    assert.ok(runLine(6).dash);
    for (let i = 1; i < 6; ++i) assert.ok(runLine(i).dash && runLine(i).width < runLine(0).width);
  });
});

describe('the playhead', () => {
  test('tells who listens where the vehicle is, and nothing where it stays away', () => {
    const heard = [];
    onPlayhead(() => heard.push({ ...playhead }));
    movePlayhead(null, 0);
    movePlayhead('sweep', 1.5);
    movePlayhead(null, 0);
    assert.deepEqual(heard, [{ recording: 'sweep', time: 1.5 }, { recording: null, time: 0 }]);
  });
});

const { valuesOf } = await source('packed_columns.js');
const { compareCells, numberOf } = await source('tables.js');
const { inPairs, partnerOf } = await source('paired_cards.js');
const { effectiveNumber, ratioOf, sideOf, squaresOf } = await source('paired.js');
const { covarianceOf, resolved } = await source('live/resolved.js');
const { residualsOf } = await source('live/misfit.js');
const { withValues } = await source('live/vehicle_file.js');
const { bodily, likeness, named } = await source('live/whatif.js');
const { aligned, followed } = await source('viewer/motion.js');
const { peaksOf } = await source('bench.js');
const { errorOf } = await source('damper_map.js');
const { isNearNode, modeBands } = await source('residuals.js');

describe('channels of two sides', () => {
  test('stand beside each other, those of the middle last', () => {
    assert.equal(partnerOf('a_body_FL'), 'a_body_FR');
    assert.equal(partnerOf('a_left_sill'), 'a_right_sill');
    assert.equal(partnerOf('a_cg'), null);
    const named = (...names) => names.map((name) => ({ name }));
    assert.deepEqual(inPairs(named('a_FL', 'a_cg', 's_FL', 'a_FR', 'a_left_sill', 's_FR')), named('a_FL', 'a_FR', 's_FL', 's_FR', 'a_cg', 'a_left_sill'));
    assert.equal(inPairs(named('a_cg', 'a_front', 'a_rear')), null);
  });
});

describe('packed numbers', () => {
  /** As PackedValues() of the C++ writes them. */
  const packed = (steps, scale) => {
    const bytes = Buffer.alloc(2 * steps.length);
    steps.forEach((step, i) => {
      const difference = (step - (steps[i - 1] ?? 0)) & 0xffff;
      bytes[i] = difference & 0xff;
      bytes[steps.length + i] = difference >> 8;
    });
    return { rows: steps.length, scale, packed: deflateSync(bytes).toString('base64') };
  };

  test('are what was packed, over the whole range', async () => {
    assert.deepEqual([...(await valuesOf(packed([0, 32767, -32767, 5, -1], 0.5)))], [0, 16383.5, -16383.5, 2.5, -0.5]);
    assert.deepEqual(await valuesOf(packed([1, -32768, 3], 2)), [2, null, 6]);
  });

  test('are even steps where they have no others', async () => {
    assert.deepEqual([...(await valuesOf({ rows: 3, first: 1, step: 0.25 }))], [1, 1.25, 1.5]);
    assert.deepEqual(await valuesOf({ values: [1, null] }), [1, null]);
  });
});

describe('tables', () => {
  test('are sorted by the numbers that cells begin with', () => {
    assert.equal(numberOf('\u22121\u2009234.5'), -1234.5);
    assert.equal(numberOf('1.5\u00b710\u207b\u2077'), 1.5e-7);
    assert.equal(numberOf('\u00b1 3.4'), 3.4);
    assert.equal(numberOf('k_front'), null);
    const sorted = (up, ...cells) => cells.sort((a, b) => compareCells(a, b, up));
    assert.deepEqual(sorted(true, '10', '', '9.5 %', '\u22122'), ['\u22122', '9.5 %', '10', '']);
    assert.deepEqual(sorted(false, '10', '', '9.5 %'), ['10', '9.5 %', '']);
    assert.deepEqual(sorted(true, 'b', 'a'), ['a', 'b']);
  });
});

describe('errors in pairs', () => {
  test('are those of phasors', () => {
    // Twice as large; turned by 90 degrees; missing.
    assert.deepEqual(squaresOf({ gain_measured: [1, 1, 1], phase_measured: [0, 0, null] }, { gain: [2, 1, 1], phase: [0, 90, 0] }).map((value) => value && Math.round(1e9 * value) / 1e9), [1, 2, null]);
  });

  test('count less where each resembles the one before', () => {
    const noise = Array.from({ length: 1000 }, (_, i) => Math.sin(12.9898 * i * i));
    const slow = Array.from({ length: 1000 }, (_, i) => Math.sin(i / 50));
    assert.ok(effectiveNumber(noise) > 700, `${effectiveNumber(noise)}`);
    assert.ok(effectiveNumber(slow) < 20, `${effectiveNumber(slow)}`);
  });

  test('of a run and one that is half as far off everywhere differ, those of two of one kind do not', () => {
    const noise = (shift) => Array.from({ length: 60 }, (_, i) => 1 + 0.9 * Math.sin(12.9898 * (i + shift) ** 2));
    const a = noise(0);
    const half = a.map((value) => value / 4);
    assert.deepEqual(ratioOf(half, a), { ratio: 0.5, lower: 0.5, upper: 0.5 });
    const { lower, upper } = ratioOf(noise(100), a);
    assert.ok(lower < 1 && upper > 1, `${lower} ${upper}`);
    // 1.00 (1.00 ... 1.00) is no difference, whatever the digits behind.
    assert.deepEqual([sideOf({ lower: 1.001, upper: 1.003 }), sideOf({ lower: 1.02, upper: 1.2 }), sideOf({ lower: 0.5, upper: 0.98 })], ['alike', 'worse', 'better']);
    assert.equal(ratioOf([1, 2], [1, 2]), null, 'two frequencies say nothing');
  });
});

describe('parameters that follow the data', () => {
  const parameters = [{ name: 'k', value: 10, lower: 0, upper: 100 }, { name: 'c', value: 2, lower: 1, upper: 2.5 }, { name: 'm', value: 5, lower: 1, upper: 9 }];
  const result = { intervals: { covariance: { parameters: ['k', 'c'], noise: [[4], [2, 9]] } } };

  test('are the conditional mean', () => {
    const covariance = covarianceOf(result, parameters);
    assert.deepEqual(covariance, [[4, 2, 0], [2, 9, 0], [0, 0, 0]]);
    // 10 % up; the other by 2 / 4 of that, relative to its own value; the third is not known to the data.
    assert.deepEqual(resolved(covariance, parameters, [11, 2, 6], [0]).map((value) => Math.round(1e9 * value) / 1e9), [11, 2.1, 6]);
    // Within its bounds.
    assert.equal(resolved(covariance, parameters, [20, 2, 5], [0])[1], 2.5);
    assert.equal(covarianceOf({}, parameters), null);
  });
});

describe('a vehicle file', () => {
  test('is saved with other values, and all else as it was', () => {
    const file = '<!-- k --><fp:parameter  name="k" value="10 kN/m" lower="1 kN/m"/>\n<fp:parameter lower="1" name=\'c\' value=\'2\'/><link name="k"/>';
    assert.equal(withValues(file, [{ name: 'k', unit: 'kN/m', value: 12.5 }]), file.replace('10 kN/m', '12.5 kN/m'));
    assert.equal(withValues(file, [{ name: 'c', unit: '1', value: 3 }]), file.replace("'2'", "'3'"));
  });
});

describe('residuals', () => {
  const channel = { unit: 'm', frequency_Hz: [1, 2, 4, 8], in_band: [true, true, true, true], gain_measured: [1, 2, 0.01, 1], phase_measured: [0, 0, 0, 0], loudest: [1, 2, 1, 1] };

  test('are null where nothing weighs them', () => {
    const none = { gain_dB: 0, phase_rad: 0, mean_m: 0, floor: 0 };
    const answer = { gain: [1, 1, 1, null], phase: [0, 0, 0, 0] };
    assert.deepEqual(residualsOf(channel, answer, none, channel.loudest).along, [null, null, null, null]);
    const { along } = residualsOf(channel, answer, { ...none, floor: 0.5 }, channel.loudest);
    assert.deepEqual(along, [0, -1, 1.98, null]);
  });

  test('know where a channel is next to a node', () => {
    const band = [1, 8];
    assert.equal(isNearNode(channel, { low: 3, high: 5, fitted: true }, band), true);
    assert.equal(isNearNode(channel, { low: 1, high: 3, fitted: true }, band), false);
  });

  test('are parted by modes half way between them', () => {
    const modes = [{ name: 'hop', frequency_Hz: 4 }, { name: 'heave', frequency_Hz: 1 }, { name: 'rest', frequency_Hz: 0 }];
    const parts = modeBands(modes, [channel], [1, 8]);
    assert.deepEqual(parts.map(({ name, fitted }) => [name, fitted]), [['heave', true], ['hop', true]]);
    assert.ok(Math.abs(parts[1].low - 4 / Math.SQRT2) < 1e-9 && Math.abs(parts[1].high - 4 * Math.SQRT2) < 1e-9);
  });
});

describe('modes of another car', () => {
  test('are drawn in the phase and size of those that they come from', () => {
    // (3 + 4i) times the other.
    const like = [1, 0, 0, 2];
    const shape = [3, 4, -8, 6];
    aligned(shape, like).forEach((value, k) => assert.ok(Math.abs(value - like[k]) < 1e-12));
  });

  test('take the place of the fitted ones, and of nothing else', () => {
    const mode = { name: 'heave', shape: [1, 0], frequency_Hz: 1 };
    const chosen = { kind: 'mode', mode };
    const now = followed(chosen, { modes: [{ of: mode, name: '', shape: [0, 2], frequency_Hz: 2 }] });
    assert.deepEqual([now.mode.name, now.mode.frequency_Hz, now.mode.shape], ['heave', 2, [1, 0]]);
    assert.equal(followed(chosen, { modes: [] }), chosen);
    assert.equal(followed(chosen, null), chosen);
  });

  test('are named by what has mass, not by coordinates', () => {
    // Two coordinates: the body up, and a wheel of a hundredth of its mass beside it.
    const links = [{ mass: 100, com: [0, 0, 0], turn: [0, 0, 0, 1], motion: [0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0] }, { mass: 1, com: [0, 0, 0], turn: [0, 0, 0, 1], motion: [0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0] }];
    const fit = [{ name: 'heave', shape: [1, 0, 1, 0] }, { name: 'hop', shape: [0, 0, 1, 0] }];
    // The wheel moves thrice as far as the body: still the body's mode.
    const modes = [{ shape: [1, 0, 3, 0] }, { shape: [-0.02, 0, 1, 0] }];
    const as = (shape) => bodily({ links }, shape);
    assert.deepEqual(named(modes, fit, as).map(({ name }) => name), ['heave', 'hop']);
    assert.ok(likeness(as(modes[0].shape), as(fit[0].shape)) > 0.9);
    assert.ok(likeness(modes[0].shape, fit[1].shape) > likeness(modes[0].shape, fit[0].shape), 'coordinates alone would say hop');
  });
});

describe('a damper', () => {
  test('has a peak of each sign in a cycle', () => {
    const t = Array.from({ length: 401 }, (_, i) => (4 * Math.PI * i) / 400 - 1);
    const [x, v] = [t.map(Math.sin), t.map(Math.cos)];
    const force = v.map((speed) => (speed > 0 ? 3 * speed : speed));
    const { x: at, y } = peaksOf(x, v, force);
    // Whole cycles alone: from the first time it passes its middle to the last.
    assert.deepEqual(y.map((value) => Math.round(100 * value) / 100), [-1, 3]);
    at.forEach((speed, i) => assert.ok(Math.abs(Math.abs(speed) - 1) < 1e-3, `${i}`));
  });

  test('is off by what its phasor is off by', () => {
    // Of a pure spring of 3 kN/m, a dashpot of 4 kN/m: |4i - 3| over 3.
    const frequency = 1 / (2 * Math.PI);
    assert.ok(Math.abs(errorOf({ frequency, damping: [0, 4000], stiffness: [3, 4] }) - 5 / 3) < 1e-9);
  });
});

const { fft, spectraOf } = await source('spectra.js');
const { dataOf, sharedWith } = await source('dropped.js');

describe('spectra', () => {
  test('are of a transform that agrees with its definition', () => {
    const values = Array.from({ length: 16 }, (_, i) => [Math.sin(i * i), Math.cos(3 * i * i)]);
    const [re, im] = [0, 1].map((part) => Float64Array.from(values, (value) => value[part]));
    fft(re, im);
    for (let k = 0; k < 16; ++k) {
      const [x, y] = values.reduce(([a, b], [c, d], i) => {
        const angle = (-2 * Math.PI * i * k) / 16;
        return [a + c * Math.cos(angle) - d * Math.sin(angle), b + c * Math.sin(angle) + d * Math.cos(angle)];
      }, [0, 0]);
      assert.ok(Math.abs(re[k] - x) < 1e-12 && Math.abs(im[k] - y) < 1e-12, `${k}`);
    }
  });

  test('hold the power of a sine, and are coherent where one signal is the other filtered', () => {
    const rate = 200;
    const noise = Array.from({ length: 20000 }, (_, i) => Math.sin(12.9898 * i * i));
    const sine = noise.map((_, i) => 3 * Math.sin((2 * Math.PI * 10 * i) / rate));
    const { frequency, first, coherence, windows } = spectraOf(sine.map((value, i) => value + 0.01 * noise[i]), noise, rate);
    // 3^2 / 2 in the peak; a Hann window leaks next to nothing beyond it.
    const power = first.reduce((sum, density) => sum + density * (frequency[1] - frequency[0]), 0);
    assert.ok(Math.abs(power / 4.5 - 1) < 0.01, `${power}`);
    assert.ok(windows >= 8);
    const peak = first.indexOf(Math.max(...first));
    assert.ok(Math.abs(frequency[peak] - 10) < 0.2);
    assert.ok(coherence[peak] < 0.5, `${coherence[peak]}`);
    const late = spectraOf(noise.slice(1), noise.slice(0, -1), rate);
    assert.ok(Math.min(...late.coherence.slice(5, -5)) > 0.99);
    assert.equal(spectraOf([1, 2], [1, 2], rate), null);
  });
});

describe('another report', () => {
  test('is compared where it was measured alike', () => {
    const channel = { recording: 'bounce', name: 'a', frequency_Hz: [1, 2], gain_measured: [1, null] };
    const page = (responses) => `<p></p><script type="application/json" id="data">${JSON.stringify({ responses })}</script>`;
    const other = dataOf(page([{ ...channel, gain_modelled: [2, 3] }]));
    assert.equal(sharedWith([channel], other.responses).get(channel).gain_modelled[1], 3);
    assert.equal(sharedWith([channel], [{ ...channel, gain_measured: [1.1, null] }]).size, 0);
    assert.equal(sharedWith([channel], [{ ...channel, recording: 'pitch' }]).size, 0);
    assert.throws(() => dataOf('<html>'), /no page of fourpost/);
    assert.throws(() => dataOf(page([])), /no frequency responses/);
  });
});

describe('a saved picture', () => {
  test('has colours that every viewer reads', () => {
    assert.deepEqual(plainColour('rgb(213, 94, 0)'), { colour: '#d55e00', opacity: 1 });
    assert.deepEqual(plainColour('rgba(20, 40, 60, 0.05)'), { colour: '#14283c', opacity: 0.05 });
    // What browsers make of color-mix().
    assert.deepEqual(plainColour('color(srgb 1 0.5 0 / 0.25)'), { colour: '#ff8000', opacity: 0.25 });
    for (const text of ['none', '#d55e00', 'url(#clip1)', '']) assert.equal(plainColour(text), null);
  });
});

describe('a travel', () => {
  const at = (travel, angle) => ({ travel, posts: [travel, 0], links: [[0, 1, travel, 0, 0, Math.sin(angle / 2), Math.cos(angle / 2)]] });
  // The last quaternion is that of the same turn with the other sign.
  const motion = { stations: [at(-0.1, 0), at(0, 0.2), { ...at(0.1, 0.4), links: [at(0.1, 0.4).links[0].map((value, i) => (i > 2 ? -value : value))] }] };

  test('goes through its stations and between them', () => {
    for (const [where, travel, angle] of [[0, -0.1, 0], [1, 0, 0.2], [1.5, 0.05, 0.3], [2, 0.1, 0.4]]) {
      const { links, posts, travel: now } = stationAt(motion, where);
      const [x, y, z, w] = links[0].turn;
      assert.ok(Math.abs(now - travel) < 1e-12 && Math.abs(posts[0] - travel) < 1e-12 && Math.abs(links[0].place[2] - travel) < 1e-12);
      // The mean of two turns by 0.1 is off by less than its square.
      assert.ok(Math.abs(2 * Math.atan2(z * Math.sign(w), Math.abs(w)) - angle) < 1e-3 && x === 0 && y === 0, `${where}`);
    }
  });
});

describe('forces of tyres', () => {
  const scene = {
    tyres: [{ name: 'front', load: 4000 }, { name: 'rear', load: 5000 }],
    sensors: [{ name: 'a', type: 'accelerometer' }, { name: 'F', type: 'load cell', tyre: 1 }, { name: 'F_pan', type: 'load cell', tyre: 1 }],
  };

  test('are those at rest and what load cells read', async () => {
    const time = [0, 0.1, 0.3];
    const recording = { recording: 'r', columns: [{ name: 'time', unit: 's', values: time }, { name: 'F_modelled', unit: 'N', values: [0, 1000, -5000] }] };
    const shares = await forcesOf(scene, recording);
    assert.deepEqual(shares(0), [null, 1]);
    assert.deepEqual(shares(0.05), [null, 1.1]);
    assert.deepEqual(shares(0.3), [null, 0]);
    assert.deepEqual(shares(9), [null, 0]);
    assert.equal(await forcesOf(scene, undefined), null);
    assert.equal(await forcesOf({ ...scene, sensors: [] }, recording), null);
  });
});
