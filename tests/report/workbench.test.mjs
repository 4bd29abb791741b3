// What an engineer does with a report: finds where the model is off, goes there, compares, takes away, hands on.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { faultsOf } from './axe.mjs';
import { close, open } from './browser.mjs';
import { coloured, measuredColour, modelColour } from './canvas.mjs';
import { changed, compared, fitted, fourpost, scratch } from './runs.mjs';
import { alone, saved } from './standing.mjs';

let run;
let report;

before(() => {
  run = fitted('landrover110/model2.yaml');
  report = join(run, 'report.html');
});

/** The download that an action begins: its name and text. */
async function downloaded(page, act) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

const dataOf = (file) => JSON.parse(readFileSync(file, 'utf8').match(/id="data">(.*?)<\/script>/s)[1]);

/** Numbers of a recording and channel in response.csv. */
function rowsOf(recording, channel) {
  const [names, ...rows] = readFileSync(join(run, 'response.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  return rows.map((row) => Object.fromEntries(row.map((value, i) => [names[i], value]))).filter((row) => row.recording === recording && row.channel === channel);
}

describe('errors', () => {
  test('stand below each response in standard deviations, as the fit weighs them', async () => {
    const page = await open(report);
    const chart = page.locator('#responses .chart[data-channel="a_cg"]');
    await chart.locator('.menu summary').click();
    const { bytes } = await downloaded(page, () => chart.locator('.menu button', { hasText: 'CSV' }).click());
    const [head, ...lines] = bytes.toString().trim().split('\n');
    const at = head.split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/).findIndex((name) => /residuals: fit, gain/.test(name));
    const rows = rowsOf('bounce', 'a_cg');
    assert.equal(lines.length, rows.length);
    // 1 dB and 5 degrees of the study, the scatter of the repeats, and a floor that is 0 there or small.
    const study = readFileSync(join(run, 'study.yaml'), 'utf8');
    const gain_dB = Number(/gain: ([\d.]+) dB/.exec(study)?.[1] ?? 1);
    lines.forEach((line, i) => {
      const row = rows[i];
      const turn = ((row.phase_modelled_deg - row.phase_measured_deg) * Math.PI) / 180;
      const along = row.gain_modelled * Math.cos(turn) - row.gain_measured;
      const most = Math.abs(along) / (row.gain_measured * (10 ** (gain_dB / 20) - 1));
      const shown = Number(line.split(',')[at]);
      // Further parts of the weight make a residual smaller, never larger; the file has six digits.
      assert.ok(Math.abs(shown) <= most * 1.001 + 1e-4 && shown * along >= 0, `${shown} of ${most}`);
    });
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('lead from a cell of their map to the curve, in its recording and octave', async () => {
    const page = await open(report);
    const cell = page.locator('#residuals table').nth(1).locator('tbody tr', { hasText: 's_strut_front' }).locator('button').first();
    assert.match(await cell.getAttribute('aria-label'), /^s_strut_front in pitch, 0\.5 to 1 Hz: [\d.]+ sd/);
    await cell.click();
    assert.equal(await page.locator('#responses .group[aria-label=recording] button[aria-pressed=true]').textContent(), 'pitch');
    const chart = page.locator('#responses .chart.found');
    assert.equal(await chart.getAttribute('data-channel'), 's_strut_front');
    // The page scrolls there.
    await page.waitForFunction(() => {
      const { top, bottom } = document.querySelector('#responses .chart[data-channel=s_strut_front]').getBoundingClientRect();
      return top > 0 && bottom < innerHeight;
    });
    assert.match(page.url(), /recording=pitch/);
    await close(page);
  });

  test('are told by mode as well, and next to a node they are marked', async () => {
    const page = await open(report);
    await page.locator('#residuals button', { hasText: 'by mode' }).click();
    const heads = await page.locator('#residuals table').first().locator('thead th').allTextContents();
    for (const mode of ['heave', 'pitch', 'front hop', 'rear hop']) assert.ok(heads.some((head) => head.startsWith(mode)), `${heads}`);
    // In pitch the middle of the car nearly rests.
    assert.ok((await page.locator('#residuals table').nth(1).locator('tbody tr', { hasText: 'a_cg' }).locator('sup').count()) > 0);
    await close(page);
  });

  test('are seen at one look, above the prose', async () => {
    const page = await open(report);
    const boxes = page.locator('#summary .maps rect');
    // Two recordings of eleven channels.
    assert.ok((await boxes.count()) > 500);
    const verdict = await page.locator('.verdict').boundingBox();
    const map = await page.locator('#summary .maps').boundingBox();
    assert.ok(map.y + map.height <= verdict.y + 1 && map.y + map.height < 900, 'on the first screen');
    assert.equal(await page.locator('[data-worst]').textContent(), 's_strut_front');
    await close(page);
  });

  test('have one worst channel and one misfit, whoever says so', async () => {
    const page = await open(report);
    const { overview, result } = dataOf(report);
    const { name, misfit, place } = overview.worst;
    const own = result.channels.find((channel) => channel.name === name);
    assert.deepEqual([own.misfit, own.worst], [misfit, place]);
    assert.ok(result.channels.every((channel) => channel.misfit <= misfit));
    const two = (value) => (value < 9.95 ? value.toFixed(1) : value.toFixed(0));
    const tile = await page.locator('.tile', { has: page.locator('[data-worst]') }).textContent();
    assert.match(tile, new RegExp(`${name}.*${two(misfit)} times noise.*largest in ${place.recording} at ${place.band_Hz[0]}\u2013${place.band_Hz[1]} Hz`));
    const verdict = await page.locator('.verdict').textContent();
    assert.ok(verdict.includes(`Worst channel: ${name}, ${two(misfit)} times`) && verdict.includes(`(${two(place.misfit)} times there)`), verdict);
    assert.ok(verdict.includes(`Residuals are ${two(result.misfit)} times`) && (await page.locator('.tile b').nth(1).textContent()) === two(result.misfit));
    assert.ok((await page.locator('dd', { hasText: /^Poor:/ }).textContent()).startsWith(`Poor: ${name} (${two(misfit)} times`));
    assert.equal(await page.locator('.maps .worst').count(), 1);
    // The largest cell of its row in the tables of residuals, of all recordings.
    const cells = page.locator('#residuals tbody tr', { has: page.locator('th code', { hasText: new RegExp(`^${name}$`) }) }).locator('td:not(.unfitted) button');
    const values = (await cells.allTextContents()).map(parseFloat);
    assert.ok(Math.abs(Math.max(...values) - place.misfit) < (place.misfit < 9.95 ? 0.06 : 0.6), `${values} ${place.misfit}`);
    await close(page);
  });

  test('are read by keys, cell by cell, and lead to the curve', async () => {
    const page = await open(report);
    const map = page.locator('#summary .maps svg').nth(1);
    await map.focus();
    const said = page.locator('#summary .maps .said').nth(1);
    assert.match(await said.textContent(), /^a_body_front in pitch, 0\.5 Hz: [\d.]+ sd$/);
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowUp', 'End']) await page.keyboard.press(key);
    assert.match(await said.textContent(), /^a_body_rear in pitch, 1[12][.\d]* Hz/);
    await page.keyboard.press('Enter');
    await page.locator('#responses .chart.found[data-channel="a_body_rear"]').waitFor();
    assert.equal(await page.locator('#responses .group[aria-label=recording] button[aria-pressed=true]').textContent(), 'pitch');
    assert.equal(await page.locator('#summary .maps [tabindex]').count(), 2, 'one stop a map');
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});

describe('charts', () => {
  test('are enlarged, and with Escape as they were', async () => {
    const page = await open(report);
    const chart = page.locator('#responses .chart').first();
    const before = await chart.boundingBox();
    await chart.locator('.tools > button').click();
    const large = await chart.boundingBox();
    assert.ok(large.width > 1.8 * before.width && large.height > 1.8 * before.height, JSON.stringify(large));
    await page.keyboard.press('Escape');
    await page.waitForTimeout(100);
    assert.deepEqual((await chart.boundingBox()).height, before.height);
    await close(page);
  });

  test('are saved as PNG, and as SVG that stands alone', async () => {
    const page = await open(report);
    const menu = page.locator('#responses .chart').first().locator('.menu');
    const { name, bytes } = await saved(page, menu, 'SVG');
    assert.equal(name, 'bounce_a_body_front.svg');
    const { words, coloured: pixels } = await alone(bytes);
    for (const said of ['bounce a_body_front', 'measured', 'fit', 'gain, dB, over Hz']) assert.ok(words.includes(said), said);
    assert.ok((bytes.toString().match(/<path/g) ?? []).length > 20, 'as vectors');
    // As many dots and lines as on the page, which is of the same size.
    const canvases = page.locator('#responses .chart').first().locator('canvas');
    for (const [colour, least] of [[measuredColour, 400], [modelColour, 300]]) {
      const shown = (await Promise.all([0, 1, 2].map((i) => coloured(canvases.nth(i), colour)))).reduce((a, b) => a + b);
      const drawn = pixels(colour);
      assert.ok(drawn > least && drawn > 0.5 * shown && drawn < 2 * shown, `${drawn} for ${shown} of ${colour}`);
    }
    const png = await saved(page, menu, 'PNG');
    assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG');
    assert.ok(png.bytes.length > 20_000);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('in the dark are saved on a ground of their own', async () => {
    const page = await open(report, { dark: true });
    const { bytes } = await saved(page, page.locator('#responses .chart').first().locator('.menu'), 'SVG');
    const { coloured: pixels } = await alone(bytes);
    assert.ok(pixels([0x14, 0x18, 0x1b]) > 40_000);
    await close(page);
  });

  test('that are drawn otherwise are saved likewise, with their numbers', async () => {
    const page = await open(report);
    const result = JSON.parse(readFileSync(join(run, 'result.json'), 'utf8'));
    const names = result.parameters.map(({ name }) => name);
    for (const [place, file, rows, told] of [
      ['#modes', 'pole_map', 4, ['heave', 'pitch', 'real part, 1/s']],
      ['#determination', 'correlations', names.length, names],
      ['#summary .maps > div:first-child', 'residuals_of_bounce', null, ['residuals of bounce', 'a_body_front']],
    ]) {
      const menu = page.locator(`${place} .menu`).first();
      const picture = await saved(page, menu, 'SVG');
      assert.equal(picture.name, `${file}.svg`);
      const { words } = await alone(picture.bytes);
      for (const said of told) assert.ok(words.includes(said), `${said} of ${file}: ${words}`);
      const table = await saved(page, menu, 'CSV');
      const lines = table.bytes.toString().trim().split('\n');
      if (rows) assert.equal(lines.length, rows + 1, `${file}: ${lines[0]}`);
      assert.ok(lines.length > 4 && lines.every((line) => line.split(',').length === lines[0].split(',').length));
    }
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('are read by keys, and as a table', async () => {
    const page = await open(report);
    const over = page.locator('#responses .u-over').first();
    await over.focus();
    assert.match(await over.getAttribute('aria-label'), /^gain of a_body_front over frequency$/);
    await page.keyboard.press('Home');
    assert.match(await over.getAttribute('aria-valuetext'), /^0\.5: measured .*, fit /);
    await page.keyboard.press('ArrowRight');
    const second = rowsOf('bounce', 'a_body_front')[1].frequency_Hz;
    assert.ok((await over.getAttribute('aria-valuetext')).startsWith(`${Number(Number(second).toPrecision(4))}: `));
    assert.match(await page.locator('#responses .reading').first().textContent(), / Hz: /);
    const chart = page.locator('#responses .chart').first();
    await chart.locator('.menu summary').click();
    await chart.locator('.menu button', { hasText: 'numbers' }).click();
    assert.equal(await chart.locator('.numbers tbody tr').count(), rowsOf('bounce', 'a_body_front').length);
    await close(page);
  });

  test('on paper are vectors, of every recording', async () => {
    const page = await open(report);
    await page.waitForTimeout(500);
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const vectors = page.locator('#responses svg.vector');
    // Two recordings of eleven channels: gain, phase, residuals; the mean offset of two.
    assert.equal(await vectors.count(), 2 * 35);
    assert.equal(await page.locator('#responses canvas:visible').count(), 0);
    assert.ok((await vectors.first().locator('path').count()) > 5);
    assert.match(await page.locator('#responses').innerText(), /pitch/);
    assert.ok(await page.locator('#parameters thead', { hasText: 'fitted' }).isVisible());
    assert.match(await page.locator('.viewer .caption').textContent(), /^heave/, 'the vehicle is printed though nobody has looked at it');
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await vectors.count(), 0);
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});

describe('tables', () => {
  test('sort by their heads and go back', async () => {
    const page = await open(report);
    const table = page.locator('#parameters table').first();
    const names = () => table.locator('tbody tr td:first-child').allTextContents();
    const before = await names();
    const head = table.locator('thead th', { hasText: 'fitted' }).locator('button');
    await head.click();
    const values = (await table.locator('tbody tr').evaluateAll((rows) => rows.map((row) => row.cells[2].innerText))).map((text) => Number(text.replaceAll(/\s/g, '')));
    assert.deepEqual(values, [...values].sort((a, b) => a - b));
    assert.notDeepEqual(await names(), before);
    await head.click();
    await head.click();
    assert.deepEqual(await names(), before);
    await close(page);
  });

  test('are copied as spreadsheets take them', async () => {
    const page = await open(report);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.locator('#parameters .copytable').first().click();
    const text = await page.evaluate(() => navigator.clipboard.readText());
    const rows = text.split('\n').map((row) => row.split('\t'));
    assert.equal(rows.length, 13);
    assert.equal(rows[1][0], 'm_sprung');
    assert.ok(rows.every((row) => row.length === rows[0].length));
    await close(page);
  });
});

describe('the head', () => {
  test('says what was tested, where, when and by whom', async () => {
    const file = changed(run, 'about', ({ read, write }) => write('study.yaml', `${read('study.yaml')}\nabout: {car: <b>Defender</b>, rig: four-post 2, date: 2024-05-17, operator: A. Miller}\n`));
    const page = await open(file);
    assert.equal(await page.locator('h1').textContent(), '<b>Defender</b>');
    assert.equal(await page.locator('header .facts').first().textContent(), 'landrover110_linkage\u00b7four-post 2\u00b72024-05-17\u00b7A. Miller');
    assert.match(await page.title(), /^<b>Defender<\/b> /);
    await close(page);
  });
});

describe('an address', () => {
  test('leads another reader to what was chosen', async () => {
    const page = await open(report);
    await page.locator('#responses button', { hasText: 'pitch' }).click();
    await page.locator('#responses button', { hasText: 'all frequencies' }).click();
    const url = page.url();
    assert.match(url, /#.*&recording=pitch&axes=all/);
    await page.goto('about:blank');
    await page.goto(url);
    await page.waitForSelector('html[data-ready]', { state: 'attached' });
    assert.equal(await page.locator('#responses .group[aria-label=recording] button[aria-pressed=true]').textContent(), 'pitch');
    assert.equal(await page.locator('#responses .group[aria-label=axes] button[aria-pressed=true]').textContent(), 'all frequencies');
    // A link of the contents leaves it.
    await page.locator('#contents a', { hasText: 'Modes' }).click();
    await page.waitForFunction(() => location.hash.startsWith('#modes&recording=pitch'));
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('leads to a car of other values, and to its motion', async () => {
    const page = await open(report);
    await page.goto('about:blank');
    await page.goto(`file://${encodeURI(report)}#responses&whatif=k_front%3A70`);
    await page.waitForSelector('.whatif');
    assert.equal(await page.locator('.whatif .row[data-parameter=k_front] input.number').inputValue(), '70');
    assert.equal(await page.locator('.whatif .options').inputValue(), '--set k_front=70kN/m');
    // The vehicle and the map of poles follow.
    await page.locator('#modes .moved path').first().waitFor({ state: 'attached' });
    assert.equal(await page.locator('#modes .moved path').count(), 4);
    await page.locator('#vehicle').scrollIntoViewIfNeeded();
    await page.locator('.viewer .caption', { hasText: /^what if: heave, 1\.8/ }).waitFor();
    await close(page);
  });
});

describe('sliders', () => {
  const opened = async () => {
    const page = await open(report);
    await page.locator('#responses .opener').click();
    await page.waitForSelector('.whatif');
    return page;
  };
  const field = (page, name) => page.locator(`.whatif .row[data-parameter="${name}"] input.number`);

  test('of others follow the data while one is held', async () => {
    const page = await opened();
    const [k, m] = ['k_front', 'm_sprung'];
    const before = Number(await field(page, m).inputValue());
    await page.locator('.whatif label', { hasText: 'others follow' }).locator('input').check();
    await field(page, k).fill('60');
    await field(page, k).press('Enter');
    const { parameters, intervals: { covariance } } = JSON.parse(readFileSync(join(run, 'result.json'), 'utf8'));
    const place = (name) => covariance.parameters.indexOf(name);
    const fit = parameters.find(({ name }) => name === k).value;
    const expected = before * (1 + (covariance.noise[place(k)][place(m)] / covariance.noise[place(k)][place(k)]) * (60e3 / fit - 1));
    // Four digits of a slider.
    assert.ok(Math.abs(Number(await field(page, m).inputValue()) / expected - 1) < 1e-3, `${expected}`);
    assert.equal(await field(page, k).inputValue(), '60');
    assert.match(await page.locator('.whatif .held').allTextContents().then((all) => all.join()), /k_front/);
    assert.deepEqual(page.faults, []);
    await close(page);
  });

  test('give a vehicle file that the program reads', async () => {
    const page = await opened();
    await field(page, 'k_front').fill('61.5');
    await field(page, 'k_front').press('Enter');
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('.whatif button', { hasText: 'save as vehicle file' }).click()]);
    const file = join(scratch, 'whatif.urdf');
    await download.saveAs(file);
    const values = new Map(JSON.parse(fourpost('params', file, '--json')).parameters.map(({ name, value }) => [name, value]));
    const fit = new Map(JSON.parse(fourpost('params', join(run, 'vehicle.urdf'), '--json')).parameters.map(({ name, value }) => [name, value]));
    assert.ok(Math.abs(values.get('k_front') - 61500) < 1e-6);
    for (const [name, value] of fit) if (name !== 'k_front') assert.equal(values.get(name), value, name);
    await close(page);
  });
});

describe('the measured car', () => {
  test('is said to be missing where a motion has none', async () => {
    const page = await open(report);
    const box = page.locator('#vehicle label', { hasText: 'measured car' });
    const select = page.locator('#vehicle select');
    await select.selectOption('mode 0');
    assert.ok(await box.locator('input').isDisabled());
    assert.match(await box.textContent(), /a mode is a shape of the model/);
    await select.selectOption('response 0');
    assert.ok(await box.locator('input').isEnabled());
    await select.selectOption('history 0');
    assert.match(await box.textContent(), /no measured motion here/);
    await close(page);
  });

  test('is drawn over the modelled one where sensors saw it', async () => {
    const page = await open(report);
    await page.locator('#vehicle').scrollIntoViewIfNeeded();
    await page.locator('.viewer .caption', { hasText: /./ }).waitFor();
    const canvas = page.locator('.viewer canvas');
    const blue = () => coloured(canvas, measuredColour);
    const ofMode = await blue();
    await page.locator('#vehicle select').selectOption({ label: 'bounce' });
    const withGhost = await blue();
    assert.ok(withGhost > ofMode + 1000, `${withGhost} after ${ofMode}`);
    assert.match(await page.locator('.viewer .caption').textContent(), /blue lines the measured car/);
    await page.locator('#vehicle label', { hasText: 'measured car' }).locator('input').uncheck();
    assert.ok((await blue()) < withGhost - 1000);
    await canvas.focus();
    const picture = () => canvas.evaluate((one) => one.toDataURL());
    const before = await picture();
    await page.keyboard.press('ArrowLeft');
    assert.ok((await picture()) !== before, 'arrow keys turn the vehicle');
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});

describe('histories', () => {
  test('have every sample, and take less of the page than a quarter of them as text', async () => {
    const text = readFileSync(report, 'utf8');
    const data = JSON.parse(text.match(/id="data">(.*?)<\/script>/s)[1]);
    const [sweep] = data.validation;
    assert.equal(sweep.shown_rows, 29933);
    // 22 columns of 29933 samples: 0.9 MB; thinned to a quarter they took 1.8 MB.
    const size = JSON.stringify(sweep).length;
    assert.ok(size < 1_100_000, `${size}`);
    const page = await open(report);
    const chart = page.locator('#histories .chart').first();
    await chart.locator('.menu summary').click();
    const { bytes } = await downloaded(page, () => chart.locator('.menu button', { hasText: 'CSV' }).click());
    const lines = bytes.toString().trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
    const rows = readFileSync(join(run, 'validation.csv'), 'utf8').trim().split('\n').slice(2).map((row) => row.split(','));
    assert.equal(lines.length, rows.length);
    const most = rows.reduce((largest, row) => Math.max(largest, Math.abs(row[2])), 0);
    for (let i = 0; i < rows.length; i += 7) {
      // Half a step of 32767 of the largest; time to a thousandth of a sample.
      assert.ok(Math.abs(lines[i][1] - rows[i][2]) <= (0.51 * most) / 32767, `row ${i}`);
      assert.ok(Math.abs(lines[i][0] - rows[i][1]) < 3e-6);
    }
    await close(page);
  });

  test('have spectra, and the coherence of model and measurement', async () => {
    const page = await open(report);
    await page.locator('#histories button', { hasText: 'spectra' }).click();
    await page.locator('#histories .note', { hasText: 'Power spectra' }).waitFor();
    assert.equal(await page.locator('#histories .chart').count(), 11);
    const canvases = page.locator('#histories .chart').first().locator('canvas');
    assert.ok((await coloured(canvases.first(), measuredColour)) > 300);
    assert.ok((await coloured(canvases.nth(1), modelColour)) > 300);
    await page.locator('#histories button', { hasText: /^all$/ }).click();
    await page.locator('#histories .note', { hasText: 'Over time' }).waitFor();
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});

describe('a damper', () => {
  test('has its equivalents over frequency and a map of errors that leads to recordings', async () => {
    const page = await open(join(fitted('damper/model2.yaml'), 'report.html'));
    const pictures = page.locator('#bench .picture svg');
    assert.equal(await pictures.count(), 4);
    const cycles = readFileSync(join(fitted('damper/model2.yaml'), 'cycles.csv'), 'utf8').trim().split('\n').slice(1);
    // A mark of each cycle.
    assert.equal(await pictures.first().locator('circle').count(), cycles.length);
    await pictures.first().locator('circle', { hasText: /^sine_20Hz_1\.3mm/ }).first().click({ force: true });
    assert.equal(await page.locator('#bench select').inputValue(), 'sine_20Hz_1.3mm');
    const own = cycles.filter((line) => line.startsWith('sine_20Hz_1.3mm,')).length;
    assert.equal(await pictures.nth(1).locator('circle').count(), 2 * cycles.length);
    assert.equal(await pictures.nth(1).locator('g[opacity="1"]').count(), own, 'its cycles stand out');
    assert.ok((await coloured(page.locator('#bench .chart.whole canvas').nth(1), modelColour)) > 200, 'the residual of the force');
    assert.deepEqual(page.faults, []);
    assert.deepEqual(await faultsOf(page), []);
    await close(page);
  });
});

describe('a comparison', () => {
  test('says of pairs what differs beyond chance, and which parameters contradict each other', async () => {
    const page = await open(compared('pairs', fitted('landrover110/model1.yaml'), run));
    const caption = await page.locator('#errors caption').textContent();
    const [, better, worse, alike] = /^(\d+) better than model1, (\d+) worse, (\d+) that cannot be distinguished\.$/.exec(caption).map(Number);
    assert.equal(better + worse + alike, await page.locator('#errors table').last().locator('tbody tr').count());
    assert.ok(better > 0);
    await page.locator('#errors .group button', { hasText: 'model2' }).click();
    // The other way round.
    assert.equal(await page.locator('#errors caption').textContent(), `${worse} better than model2, ${better} worse, ${alike} that cannot be distinguished.`);
    assert.equal(await page.locator('#errors b').count(), 0, 'nothing is bold');
    assert.ok((await page.locator('#parameters .lanes .interval').count()) > 4);
    assert.match(await page.locator('#parameters .note').first().textContent(), /all on one scale from .*contradict/);
    // The numbers of each bar stand beside it.
    assert.match(await page.locator('.agreement tbody tr').first().locator('td.n').first().textContent(), /^[\d\u2009.]+ \([\d\u2009.]+ \u2026 [\d\u2009.]+\)$/);
    // A change of as many per cent is as long in every row.
    const scales = await page.locator('.agreement tbody tr').evaluateAll((rows) =>
      rows.flatMap((row) => {
        const dots = [...row.querySelectorAll('.lanes .value')].map((dot) => parseFloat(dot.style.left));
        const values = [...row.querySelectorAll('td.n')].map((cell) => parseFloat(cell.textContent.replaceAll('\u2009', '')));
        const change = values[1] / values[0] - 1;
        return Math.abs(change) > 0.05 && dots[1] > 1 && dots[1] < 99 ? [(dots[1] - dots[0]) / change] : [];
      }),
    );
    assert.ok(scales.length > 1 && Math.max(...scales) < 1.03 * Math.min(...scales), `${scales}`);
    assert.deepEqual(page.faults, []);
    assert.deepEqual(await faultsOf(page), []);
    await close(page);
  });
});

describe('another report', () => {
  test('that is dropped on the page is compared at once', async () => {
    const page = await open(report);
    const green = [0x1d, 0x8a, 0x5b];
    const canvas = page.locator('#responses canvas').first();
    const before = await coloured(canvas, green);
    const heading = await page.locator('#responses .chart h3').first().locator('span').first().textContent();
    await page.locator('#responses input[type=file]').setInputFiles([join(fitted('landrover110/model1.yaml'), 'report.html'), join(run, 'study.yaml')]);
    const words = page.locator('#responses details summary', { hasText: /^model1: \d+ channels better than this fit, \d+ worse/ });
    await words.waitFor();
    assert.ok((await coloured(canvas, green)) > before + 100);
    assert.match(await page.locator('#responses [role=status]').textContent(), /^Compared with model1.*study\.yaml is not compared: this is no page/);
    await page.waitForFunction(() => {
      const { top, bottom } = document.querySelector('#responses [role=status]').getBoundingClientRect();
      return top > 0 && bottom < innerHeight;
    });
    // Parameters of both, too.
    assert.match(await page.locator('#responses .dropped .note').textContent(), /Values and intervals/);
    assert.ok((await page.locator('#responses .dropped .lanes').count()) > 5);
    assert.equal(await page.locator('#responses .chart h3').first().locator('span').first().textContent(), heading, 'the figures stay those of the fit');
    await page.locator('#responses .dropped button', { hasText: 'remove model1' }).click();
    assert.equal(await page.locator('#responses .dropped').count(), 0);
    assert.ok((await coloured(canvas, green)) <= before + 20, 'its curves are gone');
    assert.deepEqual(page.faults, []);
    await close(page);
  });
});

describe('a cell of the map of residuals', () => {
  test('leads to its frequencies, and a button back to all', async () => {
    const page = await open(report);
    const back = page.locator('#responses .back');
    assert.ok(await back.isHidden());
    await page.locator('#summary .maps rect').first().click();
    assert.ok(await back.isVisible());
    await back.click();
    assert.ok(await back.isHidden());
    await close(page);
  });
});

describe('pictures of the program', () => {
  test('take the theme', async () => {
    for (const [dark, ground] of [[false, 'rgb(255, 255, 255)'], [true, 'rgb(20, 24, 27)']]) {
      const page = await open(report, { dark });
      const rect = page.locator('#missing-force .picture svg > rect').first();
      assert.equal(await rect.evaluate((one) => getComputedStyle(one).fill), ground);
      await close(page);
    }
  });
});

describe('whoever reads it', () => {
  for (const [name, options] of [['in light', {}], ['in the dark', { dark: true }], ['on a telephone', { width: 390, height: 800 }]])
    test(`finds nothing that axe refuses: ${name}`, async () => {
      const page = await open(report, options);
      await page.locator('#vehicle').scrollIntoViewIfNeeded();
      await page.locator('.viewer .caption', { hasText: /./ }).waitFor();
      await page.locator('#responses .opener').click();
      await page.waitForSelector('.whatif');
      assert.deepEqual(await faultsOf(page), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      await close(page);
    });

  test('has the section in view marked in the contents, also on a telephone', async () => {
    const page = await open(report, { width: 390, height: 800 });
    await page.evaluate(() => document.getElementById('search').scrollIntoView({ behavior: 'instant' }));
    const link = page.locator('#contents a.here', { hasText: 'Search' });
    await link.waitFor();
    const box = await link.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
    await close(page);
  });

  test('sees it soon, and what is not in view later', async (t) => {
    const page = await open(report);
    const ready = await page.evaluate(() => performance.now());
    t.diagnostic(`ready after ${ready.toFixed(0)} ms`);
    assert.equal(await page.locator('.viewer .caption').textContent(), '', 'nothing is drawn yet');
    const below = async () => (await page.locator('#responses').boundingBox()).y - (await page.locator('#vehicle').boundingBox()).y;
    const before = await below();
    await page.locator('#vehicle').scrollIntoViewIfNeeded();
    await page.locator('.viewer .caption', { hasText: /./ }).waitFor();
    assert.equal(await below(), before, 'nothing moves when it is drawn');
    await close(page);
  });
});
