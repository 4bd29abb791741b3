// A Chromium without a window, and reports opened in it from disk.
import { createRequire } from 'node:module';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
// The packages are those of the report's sources.
export const require = createRequire(join(root, 'analysis', 'report', 'web', 'package.json'));

const { chromium } = require('playwright-core');

function executable() {
  const known = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
  const found = known.find((file) => file && existsSync(file));
  if (!found) throw new Error('there is no Chromium: install the package chromium, or name one in CHROMIUM');
  return found;
}

/** `webgl`: by software, so that no graphics card is needed; it takes twice the time for every page. */
function launch(webgl) {
  const gl = webgl
    ? ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
    : ['--disable-gpu', '--disable-webgl', '--disable-3d-apis', '--disable-software-rasterizer'];
  return chromium.launch({
    executablePath: executable(),
    // Chromium's own sandbox refuses to run as root.
    chromiumSandbox: process.getuid?.() !== 0,
    args: ['--hide-scrollbars', '--force-color-profile=srgb', ...gl],
  });
}

/** Browsers that have been started, and their pages that are closed: a page is opened again in a third of the time. */
const browsers = new Map();
const idle = new Map();
after(async () => {
  for (const browser of browsers.values()) await (await browser).close();
});

async function newPage(webgl, javaScript) {
  if (!browsers.has(webgl)) browsers.set(webgl, launch(webgl));
  const context = await (await browsers.get(webgl)).newContext({ javaScriptEnabled: javaScript, offline: true });
  // A busy machine may take long; what hangs takes for ever.
  context.setDefaultTimeout(180_000);
  const page = await context.newPage();
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(message.text());
  });
  page.on('pageerror', (error) => page.faults.push(error.message));
  page.on('request', (request) => {
    if (!request.url().startsWith(page.own) && !request.url().startsWith('data:')) page.faults.push(`asked for ${request.url()}`);
  });
  return page;
}

/**
 * Opens a file, offline. The page has `faults`: what it wrote to its console as an error, exceptions, and requests for
 * anything but itself.
 */
export async function open(file, { width = 1280, height = 900, dark = false, javaScript = true, webgl = false, whenReady = javaScript } = {}) {
  const kind = `${webgl} ${javaScript}`;
  const page = idle.get(kind)?.pop() ?? (await newPage(webgl, javaScript));
  page.kind = kind;
  page.faults = [];
  page.own = pathToFileURL(file).href;
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ media: null, colorScheme: dark ? 'dark' : 'light' });
  await page.goto(page.own);
  // Numbers are unpacked before they are drawn.
  if (whenReady) await page.waitForSelector('html[data-ready]', { state: 'attached' });
  return page;
}

/** Leaves nothing of a page but what is quick to open again: reports store nothing in the browser. */
export async function close(page) {
  await page.mouse.move(-1, -1);
  await page.goto('about:blank');
  if (!idle.has(page.kind)) idle.set(page.kind, []);
  idle.get(page.kind).push(page);
}
