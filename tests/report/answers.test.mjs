// Pages of what commands answer of a vehicle: modes, responses, kinematics, histories.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { faultsOf } from './axe.mjs';
import { close, open, root } from './browser.mjs';
import { coloured, modelColour } from './canvas.mjs';
import { fourpost, scratch } from './runs.mjs';
import { alone, saved } from './standing.mjs';


const car = (name) => join(root, 'urdf', `${name}.urdf`);

/** The folder that a command writes. */
function folderOf(name, command, ...words) {
  const folder = join(scratch, name);
  fourpost(command, ...words, '-o', folder);
  return folder;
}

/** Lines of a table as objects. */
function table(folder, name) {
  const [head, ...rows] = readFileSync(join(folder, name), 'utf8').trim().split('\n').map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(row.map((value, i) => [head[i], value])));
}

const dataOf = (folder) => JSON.parse(readFileSync(join(folder, 'report.html'), 'utf8').match(/id="data">(.*?)<\/script>/s)[1]);

/** Opens the page of a folder, checks what every page must be, and gives what `look` finds. */
async function look(folder, act, options = {}) {
  const page = await open(join(folder, 'report.html'), options);
  await act(page);
  assert.deepEqual(page.faults, []);
  assert.deepEqual(await faultsOf(page), []);
  await page.setViewportSize({ width: 390, height: 800 });
  await page.waitForTimeout(200);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it is no wider than a telephone');
  await close(page);
}

/** The vehicle is drawn, and its caption says this. */
async function moves(page, words) {
  await page.locator('#vehicle').scrollIntoViewIfNeeded();
  await page.locator('.viewer .caption', { hasText: words }).waitFor();
}

/** Columns of a chart's CSV. */
async function numbersOf(page, menu) {
  const { bytes } = await saved(page, menu, 'CSV');
  const [head, ...rows] = bytes.toString().trim().split('\n').map((line) => line.split(','));
  return { head, rows: rows.map((row) => row.map(Number)) };
}

describe('the page of modes', () => {
  test('has their map, the moving vehicle, ways of poles, an impulse, and sliders', async () => {
    const folder = folderOf('modes', 'modes', car('quarter_car'), '--vary', 'k');
    await look(folder, async (page) => {
      const sections = await page.locator('main > section').evaluateAll((all) => all.map(({ id }) => id));
      assert.deepEqual(sections, ['modes', 'vehicle', 'poles-k', 'impulse', 'parameters']);
      const { modes } = JSON.parse(readFileSync(join(folder, 'result.json'), 'utf8'));
      assert.deepEqual(await page.locator('#modes tbody tr td:first-child').allTextContents(), modes.map(({ name }) => name));
      await moves(page, /^heave, 1\.3/);
      // As the file beside the page has it, to a step of 32767 of the largest.
      const impulse = await numbersOf(page, page.locator('#impulse .menu').first());
      const told = table(folder, 'impulse.csv').slice(1);
      const name = (await page.locator('#impulse .chart h3 span').first().textContent()).split(',')[0];
      assert.equal(impulse.rows.length, told.length);
      const most = Math.max(...told.map((row) => Math.abs(row[name])));
      told.forEach((row, i) => assert.ok(Math.abs(row[name] - impulse.rows[i][1]) <= (0.51 * most) / 32767, `${name} ${i}`));
      const ways = await saved(page, page.locator('#poles-k .menu').first(), 'SVG');
      assert.equal(ways.bytes.toString().trim().replace(/^<\?xml.*?\?>\s*/, '').slice(0, 4), '<svg');
      await page.locator('#vehicle .opener').click();
      await page.locator('.whatif .row[data-parameter=k] input.number').fill('25');
      await page.locator('.whatif .row[data-parameter=k] input.number').press('Enter');
      await page.locator('#modes .moved path').first().waitFor({ state: 'attached' });
      await page.locator('.viewer .caption', { hasText: /^what if: heave, 1\./ }).waitFor();
    });
  });
});

describe('the page of responses', () => {
  test('has their charts, largest gains, and sliders', async () => {
    const folder = folderOf('responses', 'response', car('quarter_car'), '--frequencies', '0.5Hz:20Hz:30');
    await look(folder, async (page) => {
      const rows = table(folder, 'response.csv').filter(({ channel }) => channel === 'a_sprung');
      const largest = Math.max(...rows.map(({ gain }) => Number(gain)));
      const row = page.locator('#responses tbody tr', { hasText: 'a_sprung' });
      // Four digits are shown.
      assert.ok(Math.abs(Number(await row.locator('td').nth(2).textContent()) / largest - 1) < 1e-3);
      assert.ok((await coloured(page.locator('#responses canvas').first(), modelColour)) > 100);
      const picture = await saved(page, page.locator('#responses .menu').first(), 'SVG');
      assert.ok((await alone(picture.bytes)).words.includes('model'), 'what was not fitted is no fit');
      await moves(page, /./);
      await page.locator('#responses .opener').click();
      await page.waitForSelector('.whatif');
    });
  });

  test('of a study stands beside its recordings, and nothing is called a fit', async () => {
    const folder = folderOf('study', 'response', join(root, 'studies', 'landrover110', 'model2.yaml'), '--engine', 'reduced');
    await look(folder, async (page) => {
      const chart = page.locator('#responses .chart').first();
      assert.match(await chart.locator('h3').textContent(), / dB, .* rms/);
      const { head } = await numbersOf(page, chart.locator('.menu'));
      assert.ok(head.some((name) => /: model/.test(name)) && head.every((name) => !/: fit/.test(name)), `${head}`);
      assert.deepEqual(await page.locator('main > section').evaluateAll((all) => all.map(({ id }) => id)), ['vehicle', 'responses', 'residuals', 'histories', 'modes']);
      await moves(page, /./);
    });
  });
});

describe('the page of kinematics', () => {
  test('has curves over travel, and the vehicle goes through it in full geometry', async () => {
    const folder = folderOf('kinematics', 'kinematics', car('independent_roadster'), '--travel', '-40mm:60mm', '--step', '10mm');
    const { scene } = dataOf(folder);
    const heave = scene.travels.find(({ name }) => name === 'front heave');
    const at = ({ link, xyz: [x, y, z] }, links) => {
      const [px, py, pz, qx, qy, qz, qw] = links[link];
      const [a, b, c] = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)];
      return [px + x + qw * a + qy * c - qz * b, py + y + qw * b + qz * a - qx * c, pz + z + qw * c + qx * b - qy * a];
    };
    const design = heave.stations.find(({ travel }) => travel === 0);
    const front = scene.tyres.filter((tyre) => Math.abs(at(tyre.point, heave.stations[0].links)[2] - at(tyre.point, design.links)[2]) > 0.01);
    assert.equal(front.length, 2);
    for (const { travel, links } of heave.stations) {
      // Six digits of places and turns; poses are solved to 0.01 mm.
      for (const { point } of front) assert.ok(Math.abs(at(point, links)[2] - at(point, design.links)[2] - travel) < 2e-5, `${travel}`);
      for (const { name, ends } of scene.rods) {
        const [now, then] = [links, design.links].map((where) => Math.hypot(...at(ends[0], where).map((value, i) => value - at(ends[1], where)[i])));
        assert.ok(Math.abs(now - then) < 2e-5, `${name} at ${travel}: ${now - then}`);
      }
    }
    await look(folder, async (page) => {
      const rows = table(folder, 'wheels.csv').filter(({ axle, travel, wheel }) => axle === 'front' && travel === 'heave' && wheel === 'front_left');
      const shown = await numbersOf(page, page.locator('#axle-1 .menu').first());
      assert.equal(shown.rows.length, rows.length);
      rows.forEach((row, i) => [row.travel_mm, row.camber_deg].forEach((value, k) => assert.ok(Math.abs(value - shown.rows[i][k]) <= 1e-5 * Math.max(1, Math.abs(value)), `${i}`)));
      assert.equal(await page.locator('#vehicle h2').textContent(), 'Travel of the wheels, chassis held');
      assert.deepEqual((await page.locator('#contents a').allTextContents()).filter((name) => /^Axle/.test(name)), ['Axle front', 'Axle rear']);
      await moves(page, /^front heave 0\.0 mm/);
      const canvas = page.locator('.viewer canvas');
      const picture = () => canvas.evaluate((one) => one.toDataURL());
      const before = await picture();
      await page.locator('#vehicle input[aria-label="travel of the wheels"]').evaluate((slider) => {
        slider.value = slider.max;
        slider.dispatchEvent(new Event('input'));
      });
      await page.locator('.viewer .caption', { hasText: /^front heave 60\.0 mm/ }).waitFor();
      assert.notEqual(await picture(), before);
      await page.locator('#vehicle select').selectOption({ label: 'rear roll' });
      await page.locator('.viewer .caption', { hasText: /^rear roll 0\.0 mm/ }).waitFor();
    }, { webgl: true });
  });
});

describe('the page of a simulation', () => {
  test('has every sample, spectra, and the vehicle through time', async () => {
    const folder = folderOf('simulation', 'simulate', car('quarter_car'), '--road', 'B', '--speed', '60km/h', '--duration', '6s', '--rate', '200Hz');
    await look(folder, async (page) => {
      const lines = readFileSync(join(folder, 'history.csv'), 'utf8').trim().split('\n').map((line) => line.split(','));
      const chart = page.locator('#histories .chart[data-channel=a_sprung]');
      const shown = await numbersOf(page, chart.locator('.menu'));
      const k = lines[0].indexOf('a_sprung');
      assert.equal(shown.head.length, 2, 'nothing was measured');
      assert.equal(shown.rows.length, lines.length - 2);
      const most = Math.max(...lines.slice(2).map((line) => Math.abs(line[k])));
      lines.slice(2).forEach((line, i) => assert.ok(Math.abs(line[k] - shown.rows[i][1]) <= (0.51 * most) / 32767, `${i}`));
      await moves(page, / at 0\.00 s, motion scaled/);
      // Tyre forces over that at rest, as the load cell reads their change.
      const scrub = page.locator('#vehicle input[aria-label="time of the recording"]');
      await scrub.evaluate((slider) => {
        slider.value = 3;
        slider.dispatchEvent(new Event('input'));
      });
      await moves(page, / at 3\.00 s, .* tyre force \d\.\d\d of that at rest/);
      const said = Number(/tyre force ([\d.]+) of/.exec(await page.locator('.viewer .caption').textContent())[1]);
      const { load } = dataOf(folder).scene.tyres[0];
      const force = Number(lines.slice(2).find((line) => Math.abs(line[0] - 3) < 1e-9)[lines[0].indexOf('F_tyre')]);
      // Two decimals are shown, and the slider stands at a frame.
      assert.ok(Math.abs(said - 1 - force / load) < 0.06, `${said} for ${force} of ${load}`);
      await page.locator('#vehicle .play').click();
      await page.locator('.viewer .caption', { hasText: / at (0\.[1-9]|[1-5]\.)/ }).waitFor();
      await page.locator('#vehicle .play').click();
      await page.locator('#histories button', { hasText: 'spectra' }).click();
      await page.locator('#histories .note', { hasText: 'Power spectra' }).waitFor();
      assert.ok((await coloured(page.locator('#histories .chart canvas').first(), modelColour)) > 100);
    });
  });
});

describe('the page of a ride', () => {
  test('has its numbers, weighted spectra, and sliders that both follow', async () => {
    const folder = folderOf('ride', 'ride', car('landrover110_linkage'), '--road', 'B,C', '--speed', '80km/h', '--point', 'seat=chassis:0.1,0.3,0.8');
    await look(folder, async (page) => {
      const sections = await page.locator('main > section').evaluateAll((all) => all.map(({ id }) => id));
      assert.deepEqual(sections.filter((id) => id !== 'findings'), ['ride-1', 'ride-2', 'vehicle', 'modes', 'parameters']);
      const metrics = new Map(table(folder, 'metrics.csv').filter(({ motion }) => motion === 'road C at 80 km/h').map(({ metric, value }) => [metric, Number(value)]));
      const seat = page.locator('#ride-2 tbody tr', { hasText: 'seat' }).first();
      // Three digits are shown.
      assert.ok(Math.abs(Number(await seat.locator('td').nth(2).textContent()) / metrics.get('seat.Wk') - 1) < 0.006);
      const chart = page.locator('#ride-2 .chart', { hasText: /^seat/ });
      const { head, rows } = await numbersOf(page, chart.locator('.menu'));
      assert.ok(head.some((name) => /: weighted/.test(name)), `${head}`);
      const k = head.findIndex((name) => /: weighted/.test(name));
      // By the trapezoidal rule on Gauss's points.
      const square = rows.slice(1).reduce((sum, row, i) => sum + ((row[0] - rows[i][0]) * (row[k] + rows[i][k])) / 2, 0);
      assert.ok(Math.abs(Math.sqrt(square) / metrics.get('seat.Wk') - 1) < 0.02, `${Math.sqrt(square)}`);
      await moves(page, /./);
      await page.locator('#ride-1 .opener').click();
      await page.waitForSelector('.whatif .ride tbody');
      assert.match(await page.locator('.whatif .ride summary').textContent(), /road B at 80 km\/h/);
      // The spectrum of the sliders' car over that of the file, on the road of the sliders alone.
      const purple = [0x8b, 0x3f, 0xb0];
      const first = page.locator('#ride-1 .chart canvas').first();
      await page.locator('.whatif .row[data-parameter=k_front] input.number').fill('+30 %');
      await page.locator('.whatif .row[data-parameter=k_front] input.number').press('Enter');
      await page.waitForTimeout(800);
      assert.ok((await coloured(first, purple)) > 100);
      assert.ok((await coloured(page.locator('#ride-2 .chart canvas').first(), purple)) < 20);
      await page.locator('.whatif .ride select').selectOption('C');
      await page.waitForTimeout(800);
      assert.ok((await coloured(first, purple)) < 20);
    });
  });

  test('of a step has its history, and the usual road beside the sliders', async () => {
    const folder = folderOf('step', 'ride', car('quarter_car'), '--step', '20mm', '--duration', '2s', '--engine', 'reduced');
    await look(folder, async (page) => {
      assert.match(await page.locator('#ride-1 .note').first().textContent(), /Time history|mean heave/i);
      await moves(page, /./);
      await page.locator('#ride-1 .opener').click();
      await page.waitForSelector('.whatif .ride tbody');
      assert.match(await page.locator('.whatif .ride summary').textContent(), /road C at 60 km\/h/);
      // Folded, it has no answer while a slider moves; and closes by a key.
      await page.locator('.whatif .ride summary').click();
      await page.locator('.whatif .row[data-parameter=k] input[type=range]').press('ArrowRight');
      await page.waitForTimeout(300);
      assert.ok(!(await page.locator('.whatif').textContent()).includes('Not possible'));
      await page.keyboard.press('Escape');
      await page.waitForSelector('.whatif', { state: 'detached' });
      assert.ok(await page.locator('#ride-1 .opener').isEnabled());
    });
  });

  test('over time has no curve that would follow, and closes its sliders', async () => {
    const folder = folderOf('road over time', 'ride', car('quarter_car'), '--road', 'C', '--speed', '60km/h', '--time', '--duration', '4s', '--engine', 'reduced');
    await look(folder, async (page) => {
      assert.ok((await page.locator('#ride-1 .legend').allTextContents()).join().includes('what if'));
      assert.ok(!(await page.locator('#ride-2 .legend').allTextContents()).join().includes('what if'));
      await page.locator('#ride-1 .opener').click();
      await page.waitForSelector('.whatif .ride tbody');
      await page.locator('.whatif button[aria-label=close]').click();
      assert.ok(await page.locator('#ride-1 .opener').isEnabled());
    });
  });

  test('of a point that cannot move its way has an empty chart', async () => {
    const file = join(scratch, 'sideways.urdf');
    const sensor = '<fp:sensor name="a_ahead" type="accelerometer" link="sprung" xyz="0 0 0" axis="1 0 0"/>';
    writeFileSync(file, readFileSync(car('quarter_car'), 'utf8').replace('<fp:sensor name="a_unsprung"', `${sensor}\n  $&`).replaceAll('../meshes', join(root, 'meshes')));
    const folder = folderOf('sideways', 'ride', file, '--road', 'C', '--speed', '60km/h');
    await look(folder, async (page) => {
      assert.equal(await page.locator('#ride-1 .chart', { hasText: /^a_ahead/ }).locator('canvas').count(), 1);
    });
  });
});
