// The reduced vehicle in WebAssembly answers as the native program does.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { root } from './browser.mjs';

const source = (name) => import(pathToFileURL(join(root, 'analysis', 'report', 'web', 'src', 'live', name)).href);
const { openVehicle } = await source('vehicle.js');
const program = readFileSync(join(root, 'identify', 'live', 'bundle', 'live.base64'), 'utf8');
const native = process.env.LIVE_ANSWERS ?? join(root, 'build', 'release', 'live_answers');

const files = ['urdf', 'studies', 'examples'].flatMap((folder) =>
  readdirSync(join(root, folder), { recursive: true }).filter((name) => name.endsWith('.urdf')).map((name) => join(root, folder, name)),
);

const largestOf = (list) => list.reduce((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);

/** Largest difference of two lists as a share of a number; where one has none, both have none. */
function difference(a, b, largest) {
  return b.reduce((most, value, i) => {
    assert.equal(Number.isFinite(a[i]), value != null, `number ${i}: ${a[i]} and ${value}`);
    return value == null ? most : Math.max(most, Math.abs(a[i] - value) / (largest || 1));
  }, 0);
}

describe('WebAssembly of live pages', () => {
  // Rounding alone differs; a balance that takes one iteration more or less would show as 1e-6.
  const limit = 1e-9;
  const lines = execFileSync(native, files, { encoding: 'utf8', maxBuffer: 1e9 }).trim().split('\n').map((line) => JSON.parse(line));

  test('knows all shipped vehicles on posts', () => assert.ok(lines.length >= 12, `${lines.length}`));

  test('has the ride of nearly all of them', () => {
    const having = lines.filter(({ draws }) => draws.some(({ rides }) => rides.some(({ frequencies }) => frequencies > 0)));
    assert.ok(having.length >= 12, `${having.length}`);
  });

  for (const { file, coordinates, vehicle, instruments, points, tyres, dampers, draws } of lines)
    test(`answers as the native program: ${file.slice(root.length + 1)}`, async () => {
      const car = await openVehicle(program, vehicle, instruments);
      for (const draw of draws) {
        assert.equal(car.set(draw.values), draw.hysteretic === 0);
        const n = draw.frequencies.length;
        const channels = car.response(draw.shares, draw.frequencies, draw.amplitudes);
        assert.equal(channels.length, draw.channels);
        const complexOf = (c) => draw.response.slice(3 * n * c, 3 * n * c + 2 * n);
        // Coordinates are one motion, in which some may nearly rest.
        const sensors = channels.length - coordinates;
        const motion = Math.max(...channels.slice(sensors).map((_, i) => largestOf(complexOf(sensors + i))));
        channels.forEach(({ re, im, mean }, c) => {
          const at = 3 * n * c;
          const complex = difference([...re, ...im], complexOf(c), c < sensors ? largestOf(complexOf(c)) : motion);
          assert.ok(complex < limit, `channel ${c}: ${complex}`);
          // Of the motion of the posts, where a mean is next to nothing.
          const means = draw.response.slice(at + 2 * n, at + 3 * n);
          const scale = Math.max(...means.map(Math.abs), draw.amplitudes[0] * largestOf(complexOf(c)));
          means.forEach((value, i) => assert.ok(value == null ? Number.isNaN(mean[i]) : Math.abs(mean[i] - value) <= limit * scale, `mean of channel ${c}`));
        });
        for (const { road, frequencies, fault, numbers } of draw.rides) {
          const [roughness, speed, ...band_Hz] = road;
          const ride = () => car.ride({ roughness, speed, band_Hz }, { points, tyres, dampers });
          if (frequencies < 0) {
            assert.throws(ride, new RegExp(fault));
            continue;
          }
          const found = ride();
          assert.equal(found.frequency_Hz.length, frequencies);
          const list = [...found.points, ...found.tyres, ...found.dampers].flatMap((one) => Object.values(one));
          // Each number by its own size: tyres that never lift off have a share of nothing.
          [+found.converged, found.gridError, found.stopContact, ...list].forEach((value, i) => assert.ok(Math.abs(value - numbers[i]) <= limit * Math.max(Math.abs(numbers[i]), 1e-3), `number ${i} of a ride: ${value} and ${numbers[i]}`));
          found.density.forEach((density, i) => {
            const expected = numbers.slice(3 + list.length + (1 + i) * frequencies).slice(0, frequencies);
            assert.ok(difference(density, expected, largestOf(expected)) < limit, `density of point ${i}`);
          });
        }
        const modes = car.modes(coordinates);
        assert.equal(modes.length, draw.modes);
        const size = 5 + 2 * coordinates;
        modes.forEach(({ frequency_Hz, damping_ratio }, i) => {
          const expected = draw.mode_numbers.slice(size * i, size * (i + 1));
          // Eigenvalues next to each other lose half of the digits.
          assert.ok(Math.abs(frequency_Hz - expected[1]) <= 1e-6 * Math.max(expected[1], 1), `mode ${i}`);
          assert.ok(Math.abs(damping_ratio - expected[2]) <= 1e-6 * Math.max(expected[2], 1), `mode ${i}`);
        });
      }
    });
});

test('a vehicle of another version is refused in words', async () => {
  await assert.rejects(openVehicle(program, btoa('<robot/>')), /no reduced vehicle of this version/);
});
