// The reduced vehicle of a page in WebAssembly: identify/live/live_calls.h.

import { bytesOf, unpacked } from '../unpacked.js';

const kinds = ['oscillating', 'overdamped', 'free', 'diverging'];

/** What the program imports of a system that a page has not: all answer 0, and it ends by an exception. */
function noSystem(module) {
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = name === 'proc_exit' ? () => { throw new Error('the program ended'); } : () => 0;
  }
  return imports;
}

/**
 * `program`: WebAssembly, gzip in base 64. `vehicle`: its bytes in base 64, and those of its ride `instruments`, if it has
 * some. Throws where a browser refuses or lacks what it takes.
 */
export async function openVehicle(program, vehicle, instruments = '') {
  const module = await WebAssembly.compile(await unpacked(program));
  const { exports } = await WebAssembly.instantiate(module, noSystem(module));
  exports._initialize?.();

  const fault = () => {
    const bytes = new Uint8Array(exports.memory.buffer, exports.live_fault());
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  };
  const checked = (answer) => {
    if (answer < 0) throw new Error(fault());
    return answer;
  };
  /** Memory moves when it grows: views are made anew. */
  const put = (numbers) => new Float64Array(exports.memory.buffer, exports.live_room(8 * numbers.length), numbers.length).set(numbers);
  const answer = (count) => new Float64Array(exports.memory.buffer, exports.live_answer(), count).slice();

  const parts = [vehicle, instruments].map(bytesOf);
  const [first, second] = parts.map(({ length }) => length);
  const room = new Uint8Array(exports.memory.buffer, exports.live_room(first + second), first + second);
  room.set(parts[0]);
  room.set(parts[1], first);
  checked(exports.live_open(first, second));

  return {
    /** SI, one per parameter of the vehicle. Whether responses are to be had, which those of a hysteretic one are not. */
    set(values) {
      put(values);
      return checked(exports.live_set(values.length)) === 0;
    },

    /** Of the posts' `shares`: {re, im, mean} over frequency of each sensor, then of each coordinate; NaN where open. */
    response(shares, frequencies, amplitudes) {
      put([...shares, ...frequencies, ...amplitudes]);
      const channels = checked(exports.live_response(shares.length, frequencies.length));
      const n = frequencies.length;
      const all = answer(3 * n * channels);
      const part = (c, k) => all.subarray((3 * c + k) * n, (3 * c + k + 1) * n);
      return Array.from({ length: channels }, (_, c) => ({ re: part(c, 0), im: part(c, 1), mean: part(c, 2) }));
    },

    /**
     * Of a road of this `roughness` [m^3] at a `speed` [m/s] within a band [Hz]: of so many points, tyres and dampers
     * {converged, gridError, stopContact, points: [{weighted}], tyres: [{variation, offGround}], dampers: [{travel}],
     * frequency_Hz, density}, SI, `density` the weighted one of each point, `stopContact` the share of time of the stop
     * that is in contact most.
     */
    ride({ roughness, speed, band_Hz }, { points, tyres, dampers }) {
      put([roughness, speed, ...band_Hz]);
      const n = checked(exports.live_ride());
      const all = answer(3 + points + 2 * tyres + dampers + n * (1 + points));
      let at = 0;
      const next = (count) => all.subarray(at, (at += count));
      const each = (count, names) =>
        Array.from({ length: count }, () => {
          const numbers = next(names.length);
          return Object.fromEntries(names.map((name, i) => [name, numbers[i]]));
        });
      const [converged, gridError, stopContact] = next(3);
      return {
        converged: converged === 1,
        gridError,
        stopContact,
        points: each(points, ['weighted']),
        tyres: each(tyres, ['variation', 'offGround']),
        dampers: each(dampers, ['travel']),
        frequency_Hz: next(n),
        density: Array.from({ length: points }, () => next(n)),
      };
    },

    /** {kind, frequency_Hz, damping_ratio, pole: [re, im], shape: [re, im, re, ...]} by rising frequency. */
    modes(coordinates) {
      const count = checked(exports.live_modes());
      const size = 5 + 2 * coordinates;
      const all = answer(size * count);
      return Array.from({ length: count }, (_, i) => {
        const [kind, frequency_Hz, damping_ratio, re, im, ...shape] = all.subarray(size * i, size * (i + 1));
        return { kind: kinds[kind], frequency_Hz, damping_ratio, pole: [re, im], shape };
      });
    },
  };
}
