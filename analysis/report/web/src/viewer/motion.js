/**
 * Small motion of links from complex coordinates s: the velocity of link k's origin and its turn are `motion` (6 x n,
 * column by column) times s. `coordinates`: re, im, re, im ...
 */

/** s at a phase [rad] as real numbers: Re(s e^(i phase)). */
export function coordinatesAt(coordinates, phase) {
  const cos = Math.cos(phase);
  const sin = Math.sin(phase);
  const s = new Float64Array(coordinates.length / 2);
  for (let i = 0; i < s.length; ++i) s[i] = coordinates[2 * i] * cos - coordinates[2 * i + 1] * sin;
  return s;
}

/** Six components of a link's motion: displacement [m] and turn [rad], ground axes. */
export function linkMotion(link, s) {
  const out = new Float64Array(6);
  for (let j = 0; j < s.length; ++j) for (let i = 0; i < 6; ++i) out[i] += link.motion[6 * j + i] * s[j];
  return out;
}

/** The greatest displacement over a cycle of any link's centre of mass or of points that elements hold [m]. */
export function greatestMotion(scene, coordinates, points) {
  return greatestOf(scene, Array.from({ length: 16 }, (_, step) => coordinatesAt(coordinates, (step * Math.PI) / 8)), points);
}

/** The same over a list of s. */
export function greatestOf(scene, list, points) {
  let greatest = 0;
  for (const s of list) {
    scene.links.forEach((link, k) => {
      const m = linkMotion(link, s);
      for (const [x, y, z] of points[k]) {
        const dx = m[0] + m[4] * z - m[5] * y;
        const dy = m[1] + m[5] * x - m[3] * z;
        const dz = m[2] + m[3] * y - m[4] * x;
        greatest = Math.max(greatest, Math.hypot(dx, dy, dz));
      }
    });
  }
  return greatest;
}

/** Columns of whole numbers of a unit as rows, one per frame. */
function rows(columns, frames) {
  return Array.from({ length: frames }, (_, k) => Float64Array.from(columns, ({ unit, steps }) => unit * steps[k]));
}

/** A recording over time as frames: s and heights of the posts [m]. */
export function framesOf({ frames, coordinates, posts }) {
  return { coordinates: rows(coordinates, frames), posts: rows(posts, frames) };
}

/** Rows between two frames, at a time [s] after the first. */
export function between(list, time, rate_Hz) {
  const at = Math.min(Math.max(time * rate_Hz, 0), list.length - 1);
  const k = Math.min(Math.floor(at), list.length - 2);
  return list.length < 2 ? list[0] : list[k].map((value, i) => value + (at - k) * (list[k + 1][i] - value));
}

/** The place of each link, x y z and a quaternion x y z w, and heights of the posts [m], at `at` between two stations. */
export function stationAt({ stations }, at) {
  const k = Math.max(0, Math.min(Math.floor(at), stations.length - 2));
  const [a, b] = [stations[k], stations[k + 1] ?? stations[k]];
  const mixed = (from, to) => from.map((value, i) => value + (at - k) * (to[i] - value));
  // Stations are so near that what is between two turns is their mean, with the length of a turn.
  const turns = (from, to) => (from.reduce((sum, value, i) => sum + value * to[i], 0) < 0 ? mixed(from, to.map((value) => -value)) : mixed(from, to));
  return {
    travel: a.travel + (at - k) * (b.travel - a.travel),
    posts: mixed(a.posts, b.posts),
    links: a.links.map((link, i) => ({ place: mixed(link.slice(0, 3), b.links[i].slice(0, 3)), turn: turns(link.slice(3), b.links[i].slice(3)) })),
  };
}

/** What can be played: modes, responses to the recorded motions of the posts, recordings over time, and travels of wheels. */
export function motionsOf(scene) {
  const modes = scene.modes
    .filter((mode) => mode.shape.length)
    .map((mode, i) => ({ id: `mode ${i}`, kind: 'mode', mode, name: mode.name }));
  const responses = scene.motions.map((motion, i) => ({ id: `response ${i}`, kind: 'response', motion, name: motion.name }));
  const histories = scene.histories.map((motion, i) => ({ id: `history ${i}`, kind: 'history', motion, name: motion.name }));
  const travels = (scene.travels ?? []).map((motion, i) => ({ id: `travel ${i}`, kind: 'travel', motion, name: motion.name }));
  return [...travels, ...modes, ...responses, ...histories];
}

/** A shape turned and scaled to come nearest to another, for a shape has neither size nor phase: re, im, re, im ... */
export function aligned(shape, like) {
  let [re, im, size] = [0, 0, 0];
  for (let k = 0; k + 1 < shape.length; k += 2) {
    re += shape[k] * like[k] + shape[k + 1] * like[k + 1];
    im += shape[k] * like[k + 1] - shape[k + 1] * like[k];
    size += shape[k] ** 2 + shape[k + 1] ** 2;
  }
  if (!size) return shape;
  return shape.map((_, k) => (k % 2 ? shape[k] * re + shape[k - 1] * im : shape[k] * re - shape[k + 1] * im) / size);
}

/** A motion as the car of the sliders has it, {responses, modes}; as it is where that says nothing of it. */
export function followed(chosen, answer) {
  if (chosen?.kind === 'mode') {
    const mode = answer?.modes?.find(({ of }) => of === chosen.mode);
    return mode ? { ...chosen, mode: { ...chosen.mode, ...mode, name: chosen.mode.name, shape: aligned(mode.shape, chosen.mode.shape) } } : chosen;
  }
  const coordinates = chosen?.kind === 'response' ? answer?.responses?.get(chosen.name)?.coordinates : null;
  return coordinates ? { ...chosen, motion: { ...chosen.motion, coordinates } } : chosen;
}

/**
 * Coordinates and heights of the posts (one complex number each) of a motion; of a response at frequency number `at`,
 * and those of the measured car where sensors saw it.
 * Posts move as A sin(wt) = Re(-i A e^(iwt)), and the coordinates are relative to A.
 */
export function phasors(scene, chosen, at) {
  if (chosen.kind === 'mode') return { coordinates: chosen.mode.shape, posts: scene.posts.map(() => [0, 0]), measured: null };
  const { motion } = chosen;
  const amplitude = motion.amplitude_m[at];
  const sized = (told) => told.map((_, k) => amplitude * (k % 2 ? -(told[k - 1] ?? 0) : told[k + 1] ?? 0));
  return {
    coordinates: sized(motion.coordinates[at]),
    posts: motion.posts.map((share) => [0, -share * amplitude]),
    measured: motion.measured ? sized(motion.measured[at]) : null,
  };
}
