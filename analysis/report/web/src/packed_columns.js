import { bytesOf } from './unpacked.js';

const none = -32768;

async function inflated(base64) {
  if (typeof DecompressionStream !== 'function') throw new Error('this browser cannot unpack its numbers');
  const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The numbers of a column as PackedValues() writes them; null where there is none. */
export async function valuesOf({ values, rows, first, step, scale, packed }) {
  if (values) return values;
  if (packed == null) return Float64Array.from({ length: rows }, (_, i) => first + i * step);
  const bytes = await inflated(packed);
  const all = new Float64Array(rows);
  let missing = false;
  let now = 0;
  for (let i = 0; i < rows; ++i) {
    // Of 16 bits, with their sign.
    now = ((now + bytes[i] + (bytes[rows + i] << 8)) << 16) >> 16;
    missing ||= now === none;
    all[i] = now === none ? NaN : now * scale;
  }
  return missing ? Array.from(all, (value) => (Number.isNaN(value) ? null : value)) : all;
}

/** Recordings with the values of their columns. */
export function unpackedRecordings(recordings) {
  return Promise.all(
    recordings.map(async (recording) => ({
      ...recording,
      columns: await Promise.all(recording.columns.map(async (column) => ({ name: column.name, unit: column.unit, values: await valuesOf(column) }))),
    })),
  );
}
