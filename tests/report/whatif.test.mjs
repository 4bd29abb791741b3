// The car of the sliders: curves, misfit and modes that follow, in a browser.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { close, open, root } from './browser.mjs';
import { coloured } from './canvas.mjs';
import { fitted, fourpost, scratch } from './runs.mjs';

const source = (name) => import(pathToFileURL(join(root, 'analysis', 'report', 'web', 'src', 'live', name)).href);
const { misfitOf, movedMisfit, squaresOf } = await source('misfit.js');
const { asOptions, shareOf, typedValue, valueAt } = await source('setting.js');
const { named } = await source('whatif.js');

/** The page's --whatif. */
const whatIfColour = [0x8b, 0x3f, 0xb0];

let run;
let report;

before(() => {
  run = fitted('landrover110/model2.yaml');
  report = join(run, 'report.html');
});

async function opened(file = report, options = {}) {
  const page = await open(file, options);
  await page.locator('#responses .opener').click();
  await page.waitForSelector('.whatif');
  return page;
}

const slider = (page, name) => page.locator(`.whatif .row[data-parameter="${name}"] input[type=range]`);

async function set(page, name, value) {
  const field = page.locator(`.whatif .row[data-parameter="${name}"] input.number`);
  await field.fill(String(value));
  await field.press('Enter');
  // The answer of all recordings comes when the hand rests.
  await page.waitForTimeout(600);
}

const dataOf = (file) => JSON.parse(readFileSync(file, 'utf8').match(/id="data">(.*?)<\/script>/s)[1]);

/** Median time [ms] from an event of a slider until its charts are drawn, over 100 events. */
async function dragTime(page, name) {
  await page.evaluate(() => document.getElementById('responses').scrollIntoView());
  return slider(page, name).evaluate(async (input) => {
    const times = [];
    for (let i = 0; i < 100; ++i) {
      // From the beginning of a frame, as a browser hands on the moves of a mouse.
      await new Promise((done) => requestAnimationFrame(done));
      const begin = performance.now();
      input.value = 0.3 + 0.004 * i;
      input.dispatchEvent(new Event('input', { bubbles: true }));
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      times.push(performance.now() - begin);
    }
    return times.sort((a, b) => a - b)[50];
  });
}

describe('sliders', () => {
  test('are not there until they are asked for, nor is their program run', async () => {
    const page = await open(report);
    assert.equal(await page.locator('.whatif').count(), 0);
    assert.equal(await page.locator('#responses .opener').count(), 1);
    await close(page);
  });

  test('stand at the fit, with its misfit, and draw a curve over that of the fit', async () => {
    const page = await opened();
    await page.waitForTimeout(500);
    const [, from, to] = /([\d.]+) \u2192 ([\d.]+)/.exec(await page.locator('.whatif .misfit').textContent());
    assert.equal(from, to);
    // Digits shown.
    assert.ok(Math.abs(from - dataOf(report).result.misfit) < 0.0051, from);
    assert.ok((await coloured(page.locator('#responses canvas').first(), whatIfColour)) > 100);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('say their values with units, and which are as fitted', async () => {
    const page = await opened();
    assert.match(await slider(page, 'k_front').getAttribute('aria-valuetext'), /^[\d.]+ kN\/m, as fitted$/);
    await set(page, 'k_front', 75);
    assert.equal(await slider(page, 'k_front').getAttribute('aria-valuetext'), '75 kN/m');
    await close(page);
  });

  test('are opened from the contents and beside the first picture', async () => {
    for (const [place, width] of [['#contents', 390], ['#contents', 1280], ['#summary', 1280]]) {
      const page = await open(report, { width });
      const button = page.locator(`${place} .asking`);
      const box = await button.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, JSON.stringify(box));
      await button.click();
      await page.waitForSelector('.whatif');
      await page.waitForFunction(() => {
        const { top, bottom } = document.querySelector('.whatif').getBoundingClientRect();
        return top < innerHeight && bottom > 0;
      });
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      // Again it leads to what is open.
      await page.evaluate(() => scrollTo(0, 0));
      await page.locator('#contents .asking').click();
      assert.equal(await page.locator('.whatif').count(), 1);
      assert.ok(await page.locator('.whatif input[type=range]').first().evaluate((one) => one === document.activeElement));
      assert.deepEqual(page.faults, []);
      await close(page);
    }
  });

  test('are on paper with what they say, without what moves them', async () => {
    const page = await opened();
    await set(page, 'k_front', 75);
    await page.emulateMedia({ media: 'print' });
    assert.ok(await page.locator('.whatif').isVisible());
    assert.ok(await page.locator('.whatif .misfit').isVisible());
    assert.ok(await page.locator('.whatif .row[data-parameter=k_front] input.number').isVisible());
    assert.equal(await page.locator('.whatif input[type=range]:visible, .whatif button:visible').count(), 0);
    await close(page);
  });

  test('move curves, misfit and modes, and go back', async () => {
    const page = await opened();
    await page.waitForTimeout(500);
    const canvas = page.locator('#responses canvas').first();
    const picture = () => canvas.evaluate((one) => one.toDataURL());
    const modes = () => page.locator('.whatif .modes tbody').allInnerTexts();
    const misfit = () => page.locator('.whatif .misfit').textContent();
    const [before, modesBefore, misfitBefore] = [await picture(), await modes(), await misfit()];
    await set(page, 'k_front', 75);
    assert.notEqual(await picture(), before);
    assert.notDeepEqual(await modes(), modesBefore);
    const [, from, to] = /([\d.]+) \u2192 ([\d.]+)/.exec(await misfit());
    assert.ok(+to > +from, 'the fit has the least misfit');
    assert.equal(await page.locator('.whatif .options').inputValue(), '--set k_front=75kN/m');
    await page.locator('.whatif button', { hasText: 'undo' }).click();
    await page.waitForTimeout(600);
    assert.deepEqual([await modes(), await misfit()], [modesBefore, misfitBefore]);
    await set(page, 'k_front', 75);
    await page.locator('.whatif button', { hasText: /^A$/ }).click();
    await page.waitForTimeout(600);
    assert.equal(await misfit(), misfitBefore, 'A is the fit until it is moved');
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('give the frequencies that the program gives', async () => {
    const page = await opened();
    await set(page, 'k_front', 75);
    const shown = await page.locator('.whatif .modes tbody tr').evaluateAll((rows) => rows.map((row) => Number(row.children[1].textContent.split('\u2192').pop())));
    const printed = JSON.parse(fourpost('modes', join(run, 'vehicle.urdf'), '--set', 'k_front=75kN/m', '--json')).modes.filter(({ kind }) => kind !== 'free');
    assert.equal(shown.length, printed.length);
    // Three digits are shown.
    printed.forEach(({ frequency_Hz }, i) => assert.ok(Math.abs(shown[i] / frequency_Hz - 1) < 0.006, `${shown[i]} ${frequency_Hz}`));
    await close(page);
  });

  test('take changes relative to the fit, and say what they do not take', async () => {
    const page = await opened();
    const field = page.locator('.whatif .row[data-parameter=k_front] input.number');
    const said = page.locator('.whatif .calls');
    const fit = Number(await field.inputValue());
    await set(page, 'k_front', '-10 %');
    assert.ok(Math.abs(Number(await field.inputValue()) / fit - 0.9) < 1e-4);
    assert.equal(await said.textContent(), '');
    await set(page, 'k_front', '*1.1');
    assert.ok(Math.abs(Number(await field.inputValue()) / fit - 1.1) < 1e-4);
    const before = await field.inputValue();
    await set(page, 'k_front', -5);
    assert.match(await said.textContent(), /^k_front must be positive; -5 kN\/m was not taken\. k_front stays/);
    assert.equal(await field.inputValue(), before);
    await set(page, 'k_front', 9000);
    assert.match(await said.textContent(), /above its upper bound; set to 80 kN\/m/);
    assert.equal(await field.inputValue(), '80');
    assert.equal(await page.locator('.whatif .held').count(), 0, 'held where nothing follows');
    await close(page);
  });

  test('show what a mode was and is, in the table and in the list of motions', async () => {
    const page = await opened();
    const option = page.locator('#vehicle select option', { hasText: /^heave,/ });
    const was = await option.textContent();
    assert.doesNotMatch(await page.locator('.whatif .modes tbody').innerText(), /\u2192/);
    await set(page, 'k_front', 75);
    const heave = page.locator('.whatif .modes tbody tr', { hasText: 'heave' });
    for (const column of [1, 2]) assert.match(await heave.locator('td').nth(column).textContent(), /^[\d.]+ \u2192 [\d.]+$/);
    assert.notEqual(await option.textContent(), was);
    await close(page);
  });

  test('let others follow at once in an address that was opened', async () => {
    const page = await open(report);
    await page.goto('about:blank');
    await page.goto(`file://${encodeURI(report)}#responses&whatif=k_front%3A60`);
    await page.waitForSelector('.whatif');
    const other = page.locator('.whatif .row[data-parameter=m_sprung] input.number');
    const before = await other.inputValue();
    await page.locator('.whatif label', { hasText: 'others follow' }).locator('input').check();
    assert.notEqual(await other.inputValue(), before);
    assert.match(await page.locator('.whatif .held').allTextContents().then((all) => all.join()), /k_front/);
    const followed = await other.inputValue();
    await page.reload();
    await page.waitForSelector('.whatif');
    assert.equal(await other.inputValue(), followed);
    assert.equal(await page.locator('.whatif .held').count(), 1, 'the address says which is held');
    await close(page);
  });

  test('and the table speak of one confidence', async () => {
    const page = await opened();
    const { intervals } = dataOf(report).result;
    const head = (await page.locator('#parameters th', { hasText: 'interval of' }).textContent()).replaceAll('\u00a0', ' ');
    assert.ok(head.includes(`interval of ${intervals.confidence}`), head);
    assert.ok((await page.locator('.whatif .note').last().textContent()).includes(`interval of ${intervals.confidence}`));
    await close(page);
  });

  test('are closed again, and the page is what it was', async () => {
    const page = await open(report);
    const picture = () => page.locator('#responses canvas').first().evaluate((one) => one.toDataURL());
    const before = await picture();
    await page.locator('#responses .opener').click();
    await page.waitForSelector('.whatif');
    await page.locator('.whatif button[aria-label=close]').click();
    await page.waitForTimeout(200);
    assert.equal(await page.locator('.whatif').count(), 0);
    assert.equal(await picture(), before);
    await close(page);
  });

  test('say so where a browser refuses WebAssembly, and the charts stay', async () => {
    const file = join(scratch, 'refused.html');
    writeFileSync(file, readFileSync(report, 'utf8').replace(" 'wasm-unsafe-eval'", ''));
    const page = await open(file);
    await page.locator('#responses .opener').click();
    await page.locator('#responses .controls .note', { hasText: 'does not follow' }).waitFor();
    assert.equal(await page.locator('#responses .chart').count(), 11);
    await close(page);
  });

  test('fit on a telephone', async () => {
    const page = await opened(report, { width: 390, height: 800 });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 390));
    await close(page);
  });

  // Times are shown, not judged: they are those of the machine.
  test('are followed by a car of four degrees of freedom and by the full car', async (t) => {
    const study = readFileSync(join(root, 'studies', 'landrover110', 'full.yaml'), 'utf8');
    const stepped = study
      .replace(/# The same car on a swept sine[^]*?(?=static_loads:)/, '')
      .replace('../../urdf', join(root, 'urdf'))
      .replaceAll('file: ', `file: ${join(root, 'studies', 'landrover110')}/`);
    const folder = join(scratch, 'full');
    writeFileSync(join(scratch, 'full.yaml'), stepped);
    fourpost('response', join(scratch, 'full.yaml'), '--engine', 'reduced', '-o', folder);
    for (const [file, name] of [[report, 'm_rear'], [join(folder, 'report.html'), 'm_body']]) {
      const page = await opened(file);
      await page.waitForTimeout(500);
      const time = await dragTime(page, name);
      t.diagnostic(`${name}: ${time.toFixed(1)} ms, page of ${(readFileSync(file).length / 1e6).toFixed(2)} MB`);
      assert.ok(Number.isFinite(time));
      assert.deepEqual(page.faults, []);
      await close(page);
    }
  });
});

describe('what sliders compute', () => {
  test('residuals are those along and across the measured phasor', () => {
    const channel = { unit: 'm', in_band: [true, false], gain_measured: [2, 1], phase_measured: [90, 0] };
    const error = { gain_dB: 20 * Math.log10(1.1), phase_rad: 0.2, mean_m: 1e-3, floor: 0 };
    // 10 % too much and turned by 0.1: 2.2 cos 0.1 - 2 over 0.2, 2.2 sin 0.1 over 0.4; what is out of band is none.
    const { sum, count } = squaresOf([channel], [{ gain: [2.2, 9], phase: [90 + 18 / Math.PI, 0] }], error);
    assert.equal(count, 2);
    assert.ok(Math.abs(sum - (((2.2 * Math.cos(0.1) - 2) / 0.2) ** 2 + ((2.2 * Math.sin(0.1)) / 0.4) ** 2)) < 1e-12);
    assert.equal(misfitOf([{ sum: 8, count: 4 }], 2, 4), 2);
    assert.equal(misfitOf([], 2, 4), null);
  });

  test('a misfit of the whole fit moves by the squares of the responses', () => {
    assert.equal(movedMisfit(2, { sum: 100 }, { sum: 100 }, 50), 2);
    // 2^2 * 50 and 50 more.
    assert.ok(Math.abs(movedMisfit(2, { sum: 100 }, { sum: 150 }, 50) - Math.sqrt(5)) < 1e-12);
  });

  test('a slider is even in the value, or in its logarithm where bounds are far apart', () => {
    const even = { lower: 10, upper: 30 };
    assert.equal(shareOf(even, 15), 0.25);
    assert.equal(valueAt(even, 0.25), 15);
    const far = { lower: 1, upper: 1e4 };
    assert.equal(shareOf(far, 100), 0.5);
    assert.ok(Math.abs(valueAt(far, 0.5) - 100) < 1e-9);
  });

  test('what is typed is a value, or a change of the fit', () => {
    const k = { name: 'k', unit: 'kN/m', lower: 10, upper: 100, value: 50 };
    for (const [text, value] of [['42', 42], ['4,2e1', 42], ['-30 %', 35], ['+10%', 55], ['\u221210 %', 45], ['*0.7', 35], ['/2', 25], ['42 kN/m', 42]]) {
      const typed = typedValue(k, text);
      assert.ok(Math.abs(typed.value - value) < 1e-9, text);
      assert.equal(typed.said, undefined);
    }
    for (const text of ['', 'soft', '30 %', '+20', '42 N/m', '*', '/0', '-5', '0', '*-1']) assert.equal(typedValue(k, text).value, undefined, text);
    assert.deepEqual(typedValue(k, '200'), { value: 100, said: 'k: 200 is above its upper bound; set to 100 kN/m.' });
    assert.equal(typedValue(k, '1').value, 10);
    assert.equal(typedValue({ ...k, lower: -10 }, '-5').value, -5);
  });

  test('options name what differs from the fit, with its unit', () => {
    const parameters = [{ name: 'k', unit: 'kN/m', value: 20 }, { name: 'loss', unit: '1', value: 0.1 }, { name: 'm', unit: 'kg', value: 3 }];
    assert.equal(asOptions(parameters, [25, 0.2, 3]), '--set k=25kN/m --set loss=0.2');
  });

  test('modes take the names of those that they move like, whatever their order and phase', () => {
    const fit = [{ name: 'heave', shape: [1, 0, 0, 0] }, { name: 'pitch', shape: [0, 0, 1, 0] }];
    const modes = [{ shape: [0.1, 0, 0, 2] }, { shape: [0, -1, 0.1, 0] }];
    assert.deepEqual(named(modes, fit).map(({ name }) => name), ['pitch', 'heave']);
  });
});
