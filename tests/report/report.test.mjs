// Reports in a browser: what they show, and that nothing in them fails.
import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { close, open } from './browser.mjs';
import { colouredHeight, coloured, measuredColour, modelColour } from './canvas.mjs';
import { compare } from './picture.mjs';
import { changed, fitted, fourpost } from './runs.mjs';

/** Gain, phase and residuals of eleven channels, the mean offset of two. */
const canvasCount = 35;
const hostile = '</script><b class="hostile">x</b>';

let run;
let report;

/** The vehicle, which is drawn when it comes into view: then it has a caption. */
async function viewed(page) {
  await page.locator('#vehicle h2').scrollIntoViewIfNeeded();
  await page.locator('.viewer .caption', { hasText: /./ }).waitFor();
}

before(() => {
  run = fitted('landrover110/model2.yaml');
  report = join(run, 'report.html');
});

describe('the report of a fit to frequency responses', () => {
  test('opens from disk without a fault and asks for nothing', async () => {
    const page = await open(report, { webgl: true });
    assert.deepEqual(page.faults, []);
    assert.equal(await page.title(), 'landrover110_linkage \u2013 fourpost report');
    for (const id of ['summary', 'parameters', 'vehicle', 'responses', 'residuals', 'histories', 'loads', 'determination', 'modes', 'search'])
      assert.equal(await page.locator(`section#${id}`).count(), 1, id);
    await close(page);
  });

  test('is no larger than it may be', () => {
    const data = JSON.stringify(JSON.parse(dataOf(report))).length;
    // Beside its data: the bundle, the program in WebAssembly, and the tables as text.
    assert.ok(statSync(report).size - data < 850_000, `${statSync(report).size} bytes of which ${data} are data`);
  });

  test('draws measured dots and modelled curves of every channel', async () => {
    const page = await open(report);
    await page.locator('#responses button', { hasText: 'all frequencies' }).click();
    const charts = page.locator('#responses .chart');
    assert.equal(await charts.count(), 11);
    for (let i = 0; i < 11; ++i) {
      const canvases = charts.nth(i).locator('canvas');
      // Gain, phase and residuals; of struts the mean offset as well.
      const name = await charts.nth(i).locator('code').textContent();
      const count = name.startsWith('s_strut') ? 4 : 3;
      assert.equal(await canvases.count(), count, name);
      for (let k = 0; k < count; ++k) {
        if (k < count - 1) assert.ok((await coloured(canvases.nth(k), measuredColour)) > 300, `dots of chart ${i}`);
        assert.ok((await coloured(canvases.nth(k), modelColour)) > 100, `curve of chart ${i}`);
      }
    }
    await close(page);
  });

  test('leads from its worst channel to the chart', async () => {
    const page = await open(report);
    const link = page.locator('[data-worst]');
    const name = await link.textContent();
    const [, recording] = /largest in (\w+) at [\d.]+\u2013[\d.]+ Hz/.exec(await page.locator('.tile', { has: link }).textContent());
    await link.click();
    assert.equal(await page.locator('#responses .group[aria-label=recording] button[aria-pressed=true]').textContent(), recording);
    await page.locator(`#responses .chart.found[data-channel="${name}"]`).waitFor();
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const { top, bottom } = await page.locator(`#responses .chart[data-channel="${name}"]`).evaluate((chart) => chart.getBoundingClientRect().toJSON());
    assert.ok(top < 900 && bottom > 0, `${top}`);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('shows another recording when asked', async () => {
    const page = await open(report);
    const before = await page.locator('#responses canvas').first().evaluate((canvas) => canvas.toDataURL());
    await page.locator('#responses button', { hasText: 'pitch' }).click();
    const after = await page.locator('#responses canvas').first().evaluate((canvas) => canvas.toDataURL());
    assert.ok(before !== after);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('reads all channels at one cursor', async () => {
    const page = await open(report);
    const first = page.locator('#responses .u-over').first();
    await first.scrollIntoViewIfNeeded();
    const box = await first.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const readings = await page.locator('#responses .reading').allTextContents();
    assert.equal(readings.length, 11);
    const frequencies = new Set(readings.map((text) => /^([\d.]+) Hz: [^\s/]+\/\S+ dB, [^\s/]+\/\S+\u00b0(?:, [^\s/]+\/\S+ mm)?$/.exec(text)?.[1]));
    assert.equal(frequencies.size, 1, readings.join('\n'));
    assert.ok(![...frequencies].includes(undefined), readings[0]);
    await close(page);
  });

  test('reads above the names, which stay, as all charts do', async () => {
    const page = await open(report, { width: 1240 });
    const first = page.locator('#responses .u-over').first();
    await first.scrollIntoViewIfNeeded();
    const boxes = (what) => page.locator(`#responses ${what}`).evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
    const before = await boxes('.chart');
    const box = await first.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const readings = await boxes('.reading');
    assert.ok(readings.every(({ width }) => width > 100), 'all channels are read');
    assert.deepEqual(await boxes('.chart'), before);
    const words = [...(await boxes('h3 code')), ...(await boxes('canvas')), ...(await boxes('.note'))];
    for (const reading of readings) for (const other of words) assert.ok(areApart(reading, other), JSON.stringify([reading, other]));
    await close(page);
  });

  test('zooms to what is in view, and back', async () => {
    const page = await open(report);
    const over = page.locator('#responses .u-over').first();
    const canvas = page.locator('#responses canvas').first();
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    const whole = await colouredHeight(canvas, modelColour, 0);
    // The curve falls towards high frequencies: of half of them it fills the whole height only when that follows.
    const height = await colouredHeight(canvas, modelColour, 0.55);
    await page.mouse.move(box.x + 0.55 * box.width, box.y + 30);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.99 * box.width, box.y + 30, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    const zoomed = await colouredHeight(canvas, modelColour, 0);
    assert.ok(zoomed > 1.15 * height, `${zoomed} after ${height}`);
    await page.mouse.dblclick(box.x + 0.5 * box.width, box.y + 30);
    await page.mouse.move(5, 5);
    assert.equal(await colouredHeight(canvas, modelColour, 0), whole, 'a double click goes back');
    assert.equal(await colouredHeight(canvas, modelColour, 0.55), height, 'of frequency too');
    await close(page);
  });

  test('tells residuals of the fitted band from its rows alone', async () => {
    const page = await open(report);
    await page.locator('#residuals button', { hasText: '%' }).click();
    const rows = await page.locator('#residuals table').first().locator('tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => [cell.textContent, cell.classList.contains('unfitted')])));
    assert.deepEqual(rows[0].slice(1), [['0.5\u20131', false], ['1\u20132', false], ['2\u20134', false], ['4\u20138', false], ['8\u201312', false], ['12\u201316', true], ['16\u201332', true]]);
    const [names, ...table] = readFileSync(join(run, 'response.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
    const edges = [0.5, 1, 2, 4, 8, 12, 16, 32];
    for (const [[channel], ...cells] of rows.slice(1))
      cells.forEach(([text, unfitted], k) => {
        const squares = table
          .map((row) => Object.fromEntries(row.map((value, i) => [names[i], value])))
          .filter((row) => row.recording === 'bounce' && row.channel === channel && +row.frequency_Hz >= edges[k] && +row.frequency_Hz < edges[k + 1])
          .map((row) => {
            assert.equal(row.in_band, unfitted ? '0' : '1');
            const [size, turn] = [row.gain_modelled / row.gain_measured, ((row.phase_modelled_deg - row.phase_measured_deg) * Math.PI) / 180];
            return (size * Math.cos(turn) - 1) ** 2 + (size * Math.sin(turn)) ** 2;
          });
        const percent = 100 * Math.sqrt(squares.reduce((a, b) => a + b, 0) / squares.length);
        // As it is written: a decimal below 10 %; and the last of six digits of the data.
        // A ring marks what is next to a node.
        assert.ok(Math.abs(Number(text.replace('\u25cb', '')) - percent) < (percent < 10 ? 0.051 : 0.51), `${channel}, ${edges[k]} Hz: ${text} for ${percent}`);
      });
    await close(page);
  });

  test('draws what was kept for validation, told as such', async () => {
    const page = await open(report);
    const charts = page.locator('#histories .chart');
    assert.equal(await charts.count(), 11);
    for (let k = 0; k < 11; ++k)
      for (const colour of [measuredColour, modelColour]) assert.ok((await coloured(charts.nth(k).locator('canvas').first(), colour)) > 300, `chart ${k}`);
    assert.match(await page.locator('#histories').textContent(), /bounce_sweep: validation, not fitted\. .* All 29933 samples\./);
    assert.match(await charts.first().textContent(), /NMSE [\d.]+ %/);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('says how large a mode is drawn, and what 0 dB is', async () => {
    const page = await open(report);
    await viewed(page);
    const caption = page.locator('.viewer .caption');
    const size = async () => Number(/, scaled to ([\d.]+) mm/.exec(await caption.textContent())?.[1]);
    const before = await size();
    await page.locator('input[aria-label=exaggeration]').fill('0.5');
    // Of the slider's 4^0.5; both at two digits.
    assert.ok(Math.abs((await size()) / before - 2) < 0.1, `${before} before ${await size()}`);
    assert.match(await page.locator('#responses .note').filter({ hasText: '0 dB' }).textContent(), /0 dB: acceleration equal to that of the post, displacement equal to its motion, force of 1 N per m of its motion\./);
    await close(page);
  });

  test('moves the vehicle: plays, pauses, scrubs', async () => {
    const page = await open(report, { webgl: true });
    await viewed(page);
    const canvas = page.locator('.viewer canvas');
    await canvas.scrollIntoViewIfNeeded();
    const picture = () => canvas.evaluate((element) => element.toDataURL());
    const still = await picture();
    const scrub = page.locator('input.scrub');
    await page.locator('button.play').click();
    await page.waitForFunction((start) => Number(document.querySelector('input.scrub').value) !== start, 0);
    await page.locator('button.play').click();
    assert.ok((await picture()) !== still, 'a playing vehicle moves');
    const paused = await picture();
    await page.waitForTimeout(150);
    assert.ok((await picture()) === paused, 'a paused vehicle stands still');
    await scrub.fill('0');
    assert.ok((await picture()) === still, 'the phase alone tells the picture');
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('shows every mode, and responses at each frequency', async () => {
    const page = await open(report, { webgl: true });
    await viewed(page);
    const select = page.locator('#vehicle select');
    const options = await select.locator('option').allTextContents();
    // Four modes, two stepped sines, and the swept one that was not fitted.
    assert.equal(options.length, 7);
    assert.match(options[6], /^bounce_sweep, (59.\d|60) s$/);
    assert.match(options[0], /^heave, 1\.7\d Hz/);
    const pictures = new Set();
    for (let i = 0; i < options.length; ++i) {
      await select.selectOption({ index: i });
      pictures.add(await page.locator('.viewer canvas').evaluate((element) => element.toDataURL()));
    }
    assert.equal(pictures.size, options.length);
    await select.selectOption({ index: 5 });
    const caption = page.locator('.viewer .caption');
    const before = await caption.textContent();
    await page.locator('input[aria-label=frequency]').fill('40');
    assert.notEqual(await caption.textContent(), before);
    for (const view of ['side', 'front', 'top', 'corner']) await page.locator('#vehicle button', { hasText: view }).click();
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('is readable without JavaScript', async () => {
    const page = await open(report, { javaScript: false });
    await page.locator('.verdict', { hasText: 'The fit converged.' }).waitFor();
    assert.equal(await page.locator('#parameters tbody tr').count(), 12);
    // Eleven channels that were fitted, eleven of the swept sine that was not, and what eleven allow without physics.
    assert.equal(await page.locator('#responses tbody tr').count(), 33);
    assert.equal(await page.locator('#modes tbody tr').count(), 4);
    for (const id of ['responses', 'residuals', 'histories']) assert.match(await page.locator(`#${id} noscript`).textContent(), /JavaScript/, id);
    await close(page);
  });

  test('shows the vehicle by its edges without WebGL', async () => {
    const page = await open(report);
    await viewed(page);
    assert.equal(await page.evaluate(() => document.createElement('canvas').getContext('webgl2')), null);
    const canvas = page.locator('.viewer canvas');
    assert.ok((await coloured(canvas, modelColour)) > 200, 'springs');
    const still = await canvas.evaluate((element) => element.toDataURL());
    await page.locator('input.scrub').fill('120');
    assert.ok((await canvas.evaluate((element) => element.toDataURL())) !== still, 'the vehicle moves');
    assert.equal(await page.locator('#responses canvas').count(), canvasCount);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('changes to dark and back', async () => {
    const page = await open(report);
    const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(await ground(), 'rgb(255, 255, 255)');
    await page.locator('#theme').click();
    assert.notEqual(await ground(), 'rgb(255, 255, 255)');
    assert.ok((await coloured(page.locator('#responses canvas').first(), [0xf0, 0x88, 0x3e])) > 100);
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    assert.equal(await ground(), 'rgb(255, 255, 255)', 'paper is white');
    await close(page);
  });

  test('fits a narrow screen', async () => {
    const page = await open(report, { width: 390, height: 800 });
    await viewed(page);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `the page is ${width} wide`);
    const select = await page.locator('#vehicle select').boundingBox();
    // The margin of the page is 14 px.
    assert.ok(select.x + select.width <= 390 - 14 + 0.5, `the choice of motions ends at ${select.x + select.width}`);
    const [title, button] = [await page.locator('h1').boundingBox(), await page.locator('#theme').boundingBox()];
    assert.ok(areApart(title, button), `title and button: ${JSON.stringify([title, button])}`);
    const heights = await page.locator('#parameters tbody tr').evaluateAll((rows) => rows.map((row) => row.getBoundingClientRect().height));
    // Text is 15 px high; two lines would take 40.
    for (const height of heights) assert.ok(height < 36, `a row is ${height} high`);
    await close(page);
  });

  test('knows where the mouse is after the page moved under it', async () => {
    const page = await open(report);
    const readings = await page.evaluate(() => {
      const over = document.querySelector('#responses .u-over');
      const reading = document.querySelector('#responses .reading');
      const read = () => {
        const { left, top, width, height } = over.getBoundingClientRect();
        over.dispatchEvent(new MouseEvent('mousemove', { clientX: left + width / 3, clientY: top + height / 2, bubbles: true }));
        return reading.textContent;
      };
      const before = read();
      // No event tells of this.
      document.body.style.marginLeft = '120px';
      return [before, read()];
    });
    assert.match(readings[0], /^[\d.]+ Hz: /);
    assert.equal(readings[1], readings[0]);
    await close(page);
  });

  test('keeps a zoom when the colours change', async () => {
    const page = await open(report);
    const over = page.locator('#responses .u-over').first();
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    const picture = () => page.locator('#responses canvas').first().evaluate((canvas) => canvas.toDataURL());
    const whole = await picture();
    await page.mouse.move(box.x + 0.2 * box.width, box.y + 30);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 30, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    const zoomed = await picture();
    assert.ok(zoomed !== whole);
    for (let k = 0; k < 2; ++k) await page.locator('#theme').click();
    assert.ok((await picture()) === zoomed);
    await close(page);
  });
});

describe('pictures', () => {
  for (const [name, options, id] of [
    ['summary_light', {}, 'summary'],
    // That of README.md.
    ['report_light', { width: 960, height: 1020 }, null],
    ['vehicle_light', { webgl: true }, 'vehicle'],
    ['responses_light', {}, 'responses'],
    ['responses_dark', { dark: true }, 'responses'],
    ['parameters_narrow', { width: 390, height: 800 }, 'parameters'],
    ['determination_light', {}, 'determination'],
    ['modes_dark', { dark: true }, 'modes'],
    ['search_light', {}, 'search'],
  ])
    test(name, async () => {
      const page = await open(report, options);
      if (id) await page.evaluate((section) => document.getElementById(section).scrollIntoView({ behavior: 'instant' }), id);
      if (id === 'vehicle') await viewed(page);
      // The vehicle's first frame, and fonts.
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const fault = compare(name, await page.screenshot());
      assert.equal(fault, null, fault);
      await close(page);
    });
});

test('the report of a fit to time histories opens without a fault', async () => {
  const page = await open(join(fitted('single_wheel_station/model2.yaml'), 'report.html'), { webgl: true });
  await viewed(page);
  assert.deepEqual(page.faults, []);
  assert.equal(await page.locator('#histories .chart').count(), 5);
  for (let k = 0; k < 5; ++k)
    assert.ok((await coloured(page.locator('#histories .chart').nth(k).locator('canvas').first(), modelColour)) > 500, `curve of chart ${k}`);
  await page.locator('#histories button', { hasText: 'busiest' }).click();
  assert.equal(await page.locator('#responses').count(), 0);
  // The vehicle goes through the recording, and the charts show where it is.
  await page.locator('#histories button', { hasText: /^all$/ }).click();
  assert.equal(await page.locator('#histories .playhead:visible').count(), 0);
  await page.locator('#vehicle select').selectOption('history 0');
  const canvas = page.locator('.viewer canvas');
  const picture = () => canvas.evaluate((element) => element.toDataURL());
  const still = await picture();
  assert.equal(await page.locator('#histories .playhead:visible').count(), 5);
  const line = () => page.locator('#histories .playhead').first().evaluate((element) => parseFloat(element.style.left));
  assert.ok(Math.abs(await line()) < 1);
  const scrub = page.locator('input.scrub');
  await canvas.scrollIntoViewIfNeeded();
  await page.locator('button.play').click();
  await page.waitForFunction(() => Number(document.querySelector('input.scrub').value) > 0.3);
  await page.locator('button.play').click();
  assert.ok((await picture()) !== still, 'a playing vehicle moves');
  await scrub.fill('17.45');
  assert.match(await page.locator('.viewer .caption').textContent(), /^sweep_12mm at 17\.4\d s, motion scaled by \d\S*, tyre force \d\.\d\d of that at rest$/);
  const width = await page.locator('#histories .u-over').first().evaluate((element) => element.clientWidth);
  // Half of the recording.
  assert.ok(Math.abs((await line()) - 0.5 * width) < 0.01 * width);
  // Modes and ride follow sliders, what was recorded does not.
  await page.locator('#vehicle .opener').click();
  await page.waitForSelector('.whatif .ride tbody');
  assert.match(await page.locator('.whatif').textContent(), /Curves over time stay those of the fit/);
  await page.locator('.whatif button[aria-label=close]').click();
  // A mode is in no recording.
  await page.locator('#vehicle select').first().selectOption({ index: 0 });
  assert.equal(await page.locator('#histories .playhead:visible').count(), 0);
  assert.deepEqual(page.faults, []);
  await close(page);
});

test('the labels of a pole map keep apart', async () => {
  for (const folder of [run, fitted('single_wheel_station/model2.yaml')])
    for (const width of [1240, 390]) {
      const page = await open(join(folder, 'report.html'), { width, height: 900 });
      const labels = await page.locator('#modes svg text').evaluateAll((texts) =>
        texts.map((text) => ({ words: text.textContent, ...text.getBoundingClientRect().toJSON() })),
      );
      // Two poles at least, both axes, their units, and a damping ratio.
      assert.ok(labels.length > 8, `${labels.length} labels`);
      for (const [i, one] of labels.entries())
        for (const other of labels.slice(i + 1)) assert.ok(areApart(one, other), `'${one.words}' over '${other.words}' at ${width} px in ${folder}`);
      await close(page);
    }
});

test('the report of a fit of one parameter speaks of one', async () => {
  const page = await open(join(fitted('damper/model1.yaml'), 'report.html'));
  const text = await page.locator('#determination').textContent();
  assert.match(text, /One parameter was fitted/);
  assert.doesNotMatch(text, /together/);
  assert.match(await page.locator('#summary').textContent(), /The one parameter is determined/);
  assert.match(await page.locator('footer').textContent(), /^Made by fourpost \d+\.\d+\.\d+ on \d{4}-\d\d-\d\d of /);
  await close(page);
});

describe('reports of other runs', () => {
  test('a hostile name is text', async () => {
    const file = changed(run, 'hostile', ({ read, write }) => {
      const result = JSON.parse(read('result.json'));
      result.vehicle = hostile;
      result.study = hostile;
      result.parameters[0].name = hostile;
      result.channels[0].name = hostile;
      result.recordings[0].name = hostile;
      result.identifiability.weakest = [hostile];
      result.search.settings.base = hostile;
      write('result.json', JSON.stringify(result));
      const quoted = `"${hostile.replaceAll('"', '""')}"`;
      write('response.csv', read('response.csv').replaceAll('a_body_front', quoted).replaceAll(/^bounce/gm, quoted));
    });
    const page = await open(file);
    assert.deepEqual(page.faults, []);
    assert.equal(await page.locator('.hostile').count(), 0, 'no element comes of a name');
    assert.equal(await page.locator('h1').textContent(), hostile);
    assert.equal(await page.locator('#parameters tbody td').first().textContent(), hostile);
    assert.equal(await page.locator('#responses .chart code').first().textContent(), hostile);
    assert.equal(await page.locator('#responses button').first().textContent(), hostile);
    await close(page);
  });

  test('a run of an older version shows what it has', async () => {
    const file = changed(run, 'older', ({ read, write }) => {
      const { termination, vehicle, parameters, channels, cost } = JSON.parse(read('result.json'));
      const old = parameters.map(({ start, ...rest }) => rest);
      write('result.json', JSON.stringify({ termination, vehicle, parameters: old, channels, cost }));
      const rows = read('response.csv').trim().split('\n').map((row) => row.split(',').slice(0, 12).join(','));
      write('response.csv', `${rows.join('\n')}\n`);
    });
    const page = await open(file);
    assert.deepEqual(page.faults, []);
    assert.equal(await page.locator('#parameters tbody tr').count(), 12);
    assert.equal(await page.locator('#responses canvas').count(), canvasCount);
    await close(page);
  });

  test('a run of a newer version shows what is understood', async () => {
    for (const [name, change] of [
      ['unknown kinds', (result) => { result.termination = 'exhausted'; result.parameters = Object.fromEntries(result.parameters.map((one) => [one.name, one])); result.versions = { fourpost: '9.9.9' }; }],
      ['lists of nothing', (result) => { result.identifiability.correlation = [null]; result.starts.runs = [null, {}, { cost: 1, values: 3 }]; result.search.log = [null, 1]; result.channels = [null]; result.validation = {}; result.band_Hz = 12; }],
      ['objects for lists', (result) => { result.identifiability.correlation = {}; result.starts.runs = {}; result.search.log = {}; result.channels = {}; result.validation = 1; result.band_Hz = {}; }],
    ]) {
      const file = changed(run, name, ({ read, write }) => {
        const result = JSON.parse(read('result.json'));
        change(result);
        write('result.json', JSON.stringify(result));
      });
      const page = await open(file);
      assert.deepEqual(page.faults, [], name);
      assert.equal(await page.locator('#responses canvas').count(), canvasCount);
      assert.doesNotMatch(await page.locator('main').textContent(), /could not be drawn/);
      for (const section of await page.locator('main > section').all()) assert.ok((await section.locator(':scope > :not(h2)').allTextContents()).join('') || (await section.locator('canvas').count()), await section.getAttribute('id'));
      await close(page);
    }
  });

  test('an interrupted run without its vehicle shows the rest', async () => {
    const file = changed(run, 'interrupted', ({ read, write, remove }) => {
      const result = JSON.parse(read('result.json'));
      result.termination = 'interrupted';
      result.identifiability = null;
      for (const parameter of result.parameters) Object.assign(parameter, { sd: null, interval_95: null, state: 'not_computed' });
      result.starts.runs = [];
      write('result.json', JSON.stringify(result));
      remove('vehicle.urdf');
    });
    const page = await open(file);
    assert.deepEqual(page.faults, []);
    assert.match(await page.locator('.verdict').textContent(), /interrupted/);
    // The reason once, and no sign before nothing.
    assert.doesNotMatch(await page.locator('#parameters').textContent(), /\u00b1|sd/);
    for (const id of ['parameters', 'determination']) assert.match(await page.locator(`#${id}`).textContent(), /ended before standard deviations could be computed/);
    assert.match(await page.locator('#vehicle').textContent(), /vehicle\.urdf is missing/);
    assert.equal(await page.locator('#responses canvas').count(), canvasCount);
    await close(page);
  });

  test('time histories are drawn, long ones thinned', async () => {
    const samples = 60_000;
    const file = changed(run, 'histories', ({ read, write, remove }) => {
      const result = JSON.parse(read('result.json'));
      result.channels = [{ recording: 'sweep', name: 'a_body', nmse_percent: 3.2, vaf_percent: 96.8 }];
      write('result.json', JSON.stringify(result));
      const rows = ['recording,time,a_body_measured,a_body_modelled,s_strut_measured,s_strut_modelled', ',s,m/s^2,m/s^2,m,m'];
      for (let k = 0; k < samples; ++k) {
        const t = k / 1000;
        const wave = (shift) => Math.sin(2 * Math.PI * (0.5 * t + 0.05 * t * t) + shift);
        rows.push(['sweep', t, wave(0), wave(0.2), 0.02 * wave(1), 0.02 * wave(1.1)].join(','));
      }
      write('history.csv', `${rows.join('\n')}\n`);
      remove('response.csv');
    });
    const page = await open(file);
    assert.deepEqual(page.faults, []);
    assert.equal(await page.locator('#histories .chart').count(), 2);
    assert.match(await page.locator('#histories').textContent(), /All 60000 samples/);
    assert.match(await page.locator('.verdict + dl').textContent(), /a_body is within 5 % NMSE/);
    const canvas = page.locator('#histories canvas').first();
    const before = await canvas.evaluate((element) => element.toDataURL());
    await canvas.scrollIntoViewIfNeeded();
    const box = await page.locator('#histories .u-over').first().boundingBox();
    await page.mouse.move(box.x + 0.2 * box.width, box.y + 30);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.4 * box.width, box.y + 30, { steps: 4 });
    await page.mouse.up();
    // Not notEqual, which would print both pictures.
    assert.ok((await canvas.evaluate((element) => element.toDataURL())) !== before, 'dragging zooms');
    await close(page);
  });

  test('damper diagrams are drawn', async () => {
    const file = changed(run, 'bench', ({ write, remove, read }) => {
      const result = JSON.parse(read('result.json'));
      result.channels = [{ recording: '1 Hz', name: 'force', nmse_percent: 1.5, vaf_percent: 98.5 }];
      write('result.json', JSON.stringify(result));
      const rows = ['recording,time_s,displacement_m,speed_mps,measured_N,modelled_N'];
      for (const frequency of [1, 3])
        for (let k = 0; k <= 400; ++k) {
          const phase = (2 * Math.PI * k) / 400;
          const velocity = 2 * Math.PI * frequency * 0.025 * Math.cos(phase);
          const force = velocity > 0 ? 1800 * velocity : 700 * velocity;
          rows.push([`${frequency} Hz`, phase / (2 * Math.PI * frequency), 0.025 * Math.sin(phase), velocity, force + 20, force].join(','));
        }
      write('bench.csv', `${rows.join('\n')}\n`);
      remove('response.csv');
    });
    const page = await open(file);
    assert.deepEqual(page.faults, []);
    const canvases = page.locator('#bench canvas');
    assert.equal(await canvases.count(), 2);
    for (let k = 0; k < 2; ++k) {
      assert.ok((await coloured(canvases.nth(k), measuredColour)) > 200, `measured of diagram ${k}`);
      assert.ok((await coloured(canvases.nth(k), modelColour)) > 200, `modelled of diagram ${k}`);
    }
    // Of one recording force over time as well, and what the model differs by.
    await page.locator('#bench select').selectOption('1 Hz');
    assert.equal(await page.locator('#bench canvas').count(), 4);
    assert.equal(await page.locator('#bench output').textContent(), 'NMSE 1.5 %, fitted');
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});

/** Whether two boxes share less than half a pixel: letters' boxes are rounded. */
function areApart(a, b) {
  return a.x + a.width < b.x + 0.5 || b.x + b.width < a.x + 0.5 || a.y + a.height < b.y + 0.5 || b.y + b.height < a.y + 0.5;
}

/** The JSON in a report's file. */
function dataOf(file) {
  const text = readFileSync(file, 'utf8');
  const begin = text.indexOf('>', text.indexOf('id="data"')) + 1;
  return text.slice(begin, text.indexOf('</script>', begin));
}

describe('ride numbers beside the sliders', () => {
  /** Of the program, by name. */
  const told = (...words) => new Map(JSON.parse(fourpost('ride', join(run, 'vehicle.urdf'), ...words, '--json')).rides[0].metrics.map(({ name, value }) => [name, value]));
  /** Rows of the table: name, then the numbers of the fit and now, and the change in percent. */
  const rows = (page) => page.locator('.whatif .ride tbody tr:has(td)').evaluateAll((all) => all.map((row) => [...row.cells].map(({ textContent }) => textContent)));
  /** Once a frame has been drawn, and the ride of it. */
  const settled = async (page) => {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await page.waitForSelector('.whatif .ride table[aria-busy=false]');
  };
  const number = (text) => Number(text.replace('\u2212', '-').replaceAll('\u2009', ''));
  /** What the table shows of the program's numbers: three digits. */
  const agrees = (shown, value, about) => assert.ok(Math.abs(number(shown) - value) <= 0.6 * 10 ** (Math.floor(Math.log10(Math.abs(value))) - 2), `${about}: ${shown} for ${value}`);
  const compared = (list, column, metrics) => {
    const felt = list.filter(([name]) => / W[kdbf]$/.test(name));
    assert.ok(felt.length > 0);
    for (const row of felt) agrees(row[column], metrics.get(row[0].replace(' ', '.')), row[0]);
    for (const row of list) {
      if (metrics.has(`${row[0]}.variation`)) agrees(row[column], 100 * metrics.get(`${row[0]}.variation`), row[0]);
      if (metrics.has(`${row[0]}.travel`)) agrees(row[column], 1e3 * metrics.get(`${row[0]}.travel`), row[0]);
    }
  };

  test('follow a slider, a road and a speed as the program has them', async (t) => {
    const page = await open(report);
    await page.locator('#responses .opener').click();
    await page.waitForSelector('.whatif .ride tbody');
    assert.match(await page.locator('.whatif .ride summary').textContent(), /^ride on road C at 60 km\/h$/);
    const atFit = await rows(page);
    const fit = told('--road', 'C', '--speed', '60km/h');
    for (const column of [1, 2]) compared(atFit, column, fit);
    assert.ok(atFit.every((row) => row[3] === '0.0 %'), 'nothing has moved');
    await page.locator('.whatif .row[data-parameter=k_front] input[type=range]').evaluate((slider) => {
      for (const type of ['input', 'input', 'change']) {
        slider.value = 0.5 + 0.5 * Number(slider.value);
        slider.dispatchEvent(new Event(type, { bubbles: true }));
      }
    });
    await settled(page);
    const setting = (await page.locator('.whatif .options').inputValue()).split(' ');
    const now = await rows(page);
    const moved = told('--road', 'C', '--speed', '60km/h', ...setting);
    compared(now, 1, fit);
    compared(now, 2, moved);
    const [name, , , change] = now[0];
    const metric = name.replace(' ', '.');
    assert.ok(Math.abs(number(change.replace(' %', '')) - 100 * (moved.get(metric) / fit.get(metric) - 1)) < 0.051, `${name}: ${change}`);
    t.diagnostic(`${name}: ${now[0][1]} to ${now[0][2]} m/s^2, ${change}, for ${setting.join(' ')}`);
    await page.locator('.whatif .ride select').selectOption('B');
    await page.locator('.whatif .ride input').fill('100');
    await page.locator('.whatif .ride input').press('Enter');
    await settled(page);
    const other = await rows(page);
    compared(other, 1, told('--road', 'B', '--speed', '100km/h'));
    compared(other, 2, told('--road', 'B', '--speed', '100km/h', ...setting));
    assert.match(page.url(), /road=B%3A100/);
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});
