// What axe, a checker of accessibility, finds wrong in a page.
import { readFileSync } from 'node:fs';
import { require } from './browser.mjs';

const axe = readFileSync(require.resolve('axe-core'), 'utf8');

/** What axe finds wrong: "rule: element". */
export async function faultsOf(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => (await axe.run()).violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 160)}`)));
}
