// Screenshots compared with stored ones.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { require, root } from './browser.mjs';

const { PNG } = require('pngjs');

/** Letters differ from machine to machine by some pixels: means over blocks of this size are compared. */
const block = 16;
/** By this much, of 255, a block may differ in a channel: a line of text that moved within its block differs by less. */
const tolerance = 40;
/** Share of blocks that may differ by more: text that breaks elsewhere, or a curve drawn by another rasteriser. */
const share = 0.04;

const folder = join(root, 'tests', 'report', 'pictures');

/** Mean colour of each block, row by row. */
function means({ width, height, data }) {
  const columns = Math.floor(width / block);
  const rows = Math.floor(height / block);
  const out = new Float64Array(3 * columns * rows);
  for (let y = 0; y < rows * block; ++y)
    for (let x = 0; x < columns * block; ++x)
      for (let c = 0; c < 3; ++c)
        out[3 * (Math.floor(y / block) * columns + Math.floor(x / block)) + c] += data[4 * (y * width + x) + c] / block ** 2;
  return out;
}

/** Share of blocks in which two pictures differ visibly; 1 where their sizes differ. */
export function difference(a, b) {
  if (a.width !== b.width || a.height !== b.height) return 1;
  const one = means(a);
  const other = means(b);
  let different = 0;
  for (let k = 0; k < one.length; k += 3)
    if ([0, 1, 2].some((c) => Math.abs(one[k + c] - other[k + c]) > tolerance)) ++different;
  return different / (one.length / 3);
}

/**
 * What is wrong with a screenshot, or nothing. UPDATE_PICTURES=1 stores it in place of comparing; one that differs is
 * left in build/report_pictures.
 */
export function compare(name, shot) {
  const stored = join(folder, `${name}.png`);
  if (process.env.UPDATE_PICTURES) {
    writeFileSync(stored, shot);
    return null;
  }
  if (!existsSync(stored)) return `there is no ${stored}: look at the page and run with UPDATE_PICTURES=1`;
  const differing = difference(PNG.sync.read(readFileSync(stored)), PNG.sync.read(shot));
  if (differing <= share) return null;
  const failed = join(root, 'build', 'report_pictures');
  mkdirSync(failed, { recursive: true });
  writeFileSync(join(failed, `${name}.png`), shot);
  return `${name} differs from ${stored} in ${(100 * differing).toFixed(1)} % of its blocks, ${100 * share} % may; see ${failed}`;
}
