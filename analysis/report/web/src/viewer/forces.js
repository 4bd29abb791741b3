import { unpackedRecordings } from '../packed_columns.js';

/** Of each tyre that has a load cell: the tyre's number, its load at rest [N] and the cell's name. */
export function cellsOf({ sensors, tyres }) {
  const cells = new Map();
  for (const { type, tyre, name } of sensors) if (type === 'load cell' && tyres[tyre]?.load > 0 && !cells.has(tyre)) cells.set(tyre, { tyre, name, load: tyres[tyre].load });
  return [...cells.values()];
}

/** A number at a time of a recording, between its samples. */
export function valueAt(time, values, at) {
  let [low, high] = [0, time.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= at) low = middle;
    else high = middle;
  }
  const span = time[high] - time[low];
  return span > 0 ? values[low] + Math.min(1, Math.max(0, (at - time[low]) / span)) * (values[high] - values[low]) : values[low];
}

/**
 * Vertical forces of tyres through a recording, modelled where they are, of load cells: a function of time that gives of
 * each tyre its force over that at rest, or null where it has no cell. Null where there is none at all.
 */
export async function forcesOf(scene, recording) {
  const cells = cellsOf(scene);
  if (!recording || !cells.length) return null;
  const [{ columns }] = await unpackedRecordings([recording]);
  const column = (name) => columns.find((one) => one.name === name)?.values;
  const time = column('time');
  const known = cells.map((cell) => ({ ...cell, values: column(`${cell.name}_modelled`) ?? column(`${cell.name}_measured`) })).filter(({ values }) => values);
  if (!time || !known.length) return null;
  return (at) => {
    const shares = scene.tyres.map(() => null);
    // A cell reads the change from rest.
    for (const { tyre, load, values } of known) shares[tyre] = 1 + valueAt(time, values, at) / load;
    return shares;
  };
}
