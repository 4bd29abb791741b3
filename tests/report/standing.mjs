// Pictures that a page saves, looked at without the page.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { close, open, require } from './browser.mjs';
import { scratch } from './runs.mjs';

const { PNG } = require('pngjs');

/** How many pixels of a screenshot have a colour near this one. */
function count({ data }, [red, green, blue]) {
  let found = 0;
  for (let i = 0; i < data.length; i += 4) if (Math.abs(data[i] - red) + Math.abs(data[i + 1] - green) + Math.abs(data[i + 2] - blue) < 60) ++found;
  return found;
}

/** What clicking an entry of a menu of saving hands over: {name, bytes}. */
export async function saved(page, menu, kind) {
  await menu.locator('summary').click();
  const [download] = await Promise.all([page.waitForEvent('download'), menu.locator('button', { hasText: new RegExp(`^${kind}$`) }).click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

/**
 * An SVG opened as a file of its own. What it says must be there without the page: words in letters that any viewer has and
 * plain colours, for viewers know neither variables nor functions of colours, and few know baselines. Its words, and
 * `coloured(rgb)`: how many pixels have about this colour.
 */
export async function alone(bytes) {
  const text = bytes.toString();
  assert.match(text, /^<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
  assert.doesNotMatch(text, /var\(|color-mix|color\(|rgba?\(|currentcolor|system-ui|dominant-baseline|<image|<style| class=| style=|NaN|undefined/i);
  const file = join(scratch, 'alone.svg');
  writeFileSync(file, bytes);
  const page = await open(file, { width: 1200, height: 1000, whenReady: false });
  const words = await page.evaluate(() => {
    const { width, height } = document.documentElement.getBoundingClientRect();
    return [...document.querySelectorAll('text')].map((one) => {
      const box = one.getBoundingClientRect();
      return { words: one.textContent, inside: box.left >= -1 && box.top >= -1 && box.right <= width + 1 && box.bottom <= height + 1, size: Number.parseFloat(getComputedStyle(one).fontSize) };
    });
  });
  const said = words.filter((one) => one.words.trim());
  assert.ok(said.length > 3, 'it has words');
  for (const one of said) assert.ok(one.inside && one.size >= 8, JSON.stringify(one));
  const shot = PNG.sync.read(await page.screenshot());
  await close(page);
  return { words: said.map((one) => one.words), coloured: (rgb) => count(shot, rgb) };
}
