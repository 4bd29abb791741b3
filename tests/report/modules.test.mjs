// What the page's scripts compute, without a browser.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { root } from './browser.mjs';

const source = (name) => import(pathToFileURL(join(root, 'analysis', 'report', 'web', 'src', name)).href);
const { extent, fixed, logTicks, multiples, niceStep, shown } = await source('number.js');
const { between, coordinatesAt, framesOf, greatestMotion, greatestOf, linkMotion, phasors } = await source('viewer/motion.js');
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
