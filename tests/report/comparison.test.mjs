// Pages that compare runs, and methods of search, in a browser.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { close, open } from './browser.mjs';
import { coloured, measuredColour, modelColour } from './canvas.mjs';
import { compare } from './picture.mjs';
import { changed, compared, fitted, methods } from './runs.mjs';

/** Gain and phase of eleven channels, the mean offset of two. */
const canvasCount = 24;
const hostile = '</script><b class="hostile">x</b>';

let run;

before(() => {
  run = fitted('landrover110/model2.yaml');
});

describe('a comparison of runs', () => {
  let file;
  let other;
  before(() => {
    other = fitted('landrover110/model1.yaml');
    file = compared('cars', other, run);
  });

  test('overlays what the runs share', async () => {
    const page = await open(file);
    assert.deepEqual(page.faults, []);
    for (const id of ['summary', 'errors', 'parameters', 'responses', 'histories']) assert.equal(await page.locator(`section#${id}`).count(), 1, id);
    assert.match(await page.locator('.verdict').textContent(), /^model\d fits best: .* predict(s best| alike): .*Recommended: model/);
    assert.deepEqual(await page.locator('#responses .legend span').allTextContents(), ['measured', 'model1', 'model2', 'not fitted']);
    assert.match(await page.locator('#histories').textContent(), /bounce_sweep: predicted by model1 and model2\./);
    assert.match(await page.locator('footer').textContent(), /^Made by fourpost \d+\.\d+\.\d+ on \d{4}-\d\d-\d\d of the fits model1, model2 \(by fourpost /);
    assert.equal(await page.locator('#responses canvas').count(), canvasCount);
    assert.equal(await page.locator('#histories canvas').count(), 11);
    // Where they are alike, the last run lies over the first, and the first shows between its dashes.
    for (const part of ['responses', 'histories'])
      for (const canvas of await page.locator(`#${part} canvas`).all())
        for (const colour of [modelColour, measuredColour]) assert.ok((await coloured(canvas, colour)) > 50, `${part}: ${colour}`);
    // Above 12 of 30 Hz nothing was fitted: from the right a fifth is shaded, by 5 % of a dark colour.
    const shaded = await page.locator('#responses canvas').first().evaluate((canvas) => {
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((value, i) => i % 4 === 3 && value > 8 && value < 20).length / (canvas.width * canvas.height);
    });
    assert.ok(shaded > 0.1 && shaded < 0.35, `${shaded} of the chart is shaded`);
    await page.locator('#responses .u-over').first().scrollIntoViewIfNeeded();
    const box = await page.locator('#responses .u-over').first().boundingBox();
    const reading = page.locator('#responses .reading').first();
    // One move is enough: a long reading does not push the chart from under the mouse.
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    assert.deepEqual(await page.locator('#responses .u-over').first().boundingBox(), box);
    assert.match(await reading.textContent(), /^[\d.]+ Hz: \S+, [^\s/]+\/\S+ dB, \S+, [^\s/]+\/\S+\u00b0$/);
    const busiest = await page.locator('#histories canvas').first().evaluate((canvas) => canvas.toDataURL());
    await page.locator('#histories button', { hasText: /^all$/ }).click();
    assert.ok((await page.locator('#histories canvas').first().evaluate((canvas) => canvas.toDataURL())) !== busiest);
    assert.equal(await page.locator('#parameters table').last().locator('thead th').count(), 4);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('is readable without JavaScript and on a narrow screen', async () => {
    const plain = await open(file, { javaScript: false });
    assert.equal(await plain.locator('#summary tbody tr').count(), 2);
    await close(plain);
    const page = await open(file, { width: 390, height: 800 });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `the page is ${width} wide`);
    await close(page);
  });

  test('shows a hostile name as text', async () => {
    const makeHostile = ({ read, write }) => {
      const result = JSON.parse(read('result.json'));
      // Of a path the end is the name.
      result.study = '<b class="hostile">x';
      result.parameters[0].name = hostile;
      result.channels[0].name = hostile;
      result.validation[0].recording = hostile;
      write('result.json', JSON.stringify(result));
      const quoted = `"${hostile.replaceAll('"', '""')}"`;
      write('response.csv', read('response.csv').replaceAll('a_body_front', quoted).replaceAll(/^bounce/gm, quoted));
    };
    const folders = ['hostile run', 'another hostile run'].map((name) => join(changed(run, name, makeHostile), '..'));
    const page = await open(compared('hostile comparison', ...folders));
    assert.deepEqual(page.faults, []);
    assert.equal(await page.locator('.hostile').count(), 0, 'no element comes of a name');
    assert.match(await page.locator('#responses .legend span').nth(1).textContent(), /<b class="hostile">x/);
    assert.equal(await page.locator('#responses .chart code').first().textContent(), hostile);
    await close(page);
  });

  test('overlays dampers', async () => {
    const page = await open(compared('dampers', ...['model1', 'model2'].map((model) => fitted(`damper/${model}.yaml`))));
    assert.deepEqual(page.faults, []);
    const canvases = page.locator('#bench canvas');
    assert.equal(await canvases.count(), 3);
    for (let k = 0; k < 3; ++k) for (const colour of [modelColour, measuredColour]) assert.ok((await coloured(canvases.nth(k), colour)) > 100, `chart ${k}`);
    await page.locator('#bench select').selectOption({ index: 0 });
    assert.equal(await canvases.count(), 3);
    assert.match(await page.locator('#summary thead').textContent(), /AICc/);
    // Its table of fifteen columns fits a page of 1200 px, and the paper.
    await page.setViewportSize({ width: 1200, height: 800 });
    const cut = () => page.locator('#summary .table').evaluate((table) => table.scrollWidth - table.clientWidth);
    assert.equal(await cut(), 0);
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    assert.equal(await cut(), 0);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  for (const [name, id] of [['comparison_light', 'summary'], ['compared_responses_light', 'responses']])
    test(`looks as it did: ${name}`, async () => {
      const page = await open(file);
      await page.evaluate((section) => document.getElementById(section).scrollIntoView({ behavior: 'instant' }), id);
      const fault = compare(name, await page.screenshot());
      assert.equal(fault, null, fault);
      await close(page);
    });
});

test('a comparison of methods shows when they succeed', async () => {
  const page = await open(methods('test_problems/oscillator.yaml', 'dvhde,de,simplex', 10));
  assert.deepEqual(page.faults, []);
  assert.match(await page.locator('.verdict').textContent(), /^dvhde solved it in 10 of 10 runs, at \d\d\.\d evaluations per success; next simplex/);
  assert.equal(await page.locator('#summary tbody tr').count(), 3);
  assert.ok((await page.locator('#summary svg').first().boundingBox()).width > 600);
  const fault = compare('methods_light', await page.screenshot());
  assert.equal(fault, null, fault);
  await close(page);
});
