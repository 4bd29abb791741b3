// Pages of vehicles that were never fitted, in a browser.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { faultsOf } from './axe.mjs';
import { close, open, root } from './browser.mjs';
import { coloured } from './canvas.mjs';
import { fourpost, scratch } from './runs.mjs';


describe('the page of a vehicle', () => {
  test('that was never fitted moves by sliders', async () => {
    const file = join(scratch, 'car.html');
    const car = join(root, 'urdf', 'quarter_car.urdf');
    fourpost('view', car, '--frequencies', '0.5Hz:20Hz:30', '-o', file);
    const page = await open(file);
    assert.equal(await page.locator('h1').textContent(), 'quarter_car');
    await page.locator('#responses .opener').click();
    await page.locator('.whatif .row[data-parameter=k] input.number').fill('25');
    await page.locator('.whatif .row[data-parameter=k] input.number').press('Enter');
    await page.waitForTimeout(500);
    assert.ok((await coloured(page.locator('#responses canvas').first(), [0x8b, 0x3f, 0xb0])) > 100);
    const shown = await page.locator('.whatif .modes tbody tr').evaluateAll((rows) => rows.map((row) => Number(row.children[1].textContent.split('\u2192').pop())));
    const printed = JSON.parse(fourpost('modes', car, '--set', 'k=25kN/m', '--json')).modes.filter(({ kind }) => kind !== 'free');
    // Three digits are shown.
    printed.forEach(({ frequency_Hz }, i) => assert.ok(Math.abs(shown[i] / frequency_Hz - 1) < 0.006));
    assert.deepEqual(page.faults, []);
    assert.deepEqual(await faultsOf(page), []);
    await close(page);
  });
});
