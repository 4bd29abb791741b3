// A Chromium without a window, and reports opened in it from disk.
import { createRequire } from 'node:module';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
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

/** `webgl`: by software, so that no graphics card is needed. */
export function launch({ webgl = true } = {}) {
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

/**
 * Opens a file, offline. The page has `faults`: what it wrote to its console as an error, exceptions, and requests for
 * anything but itself.
 */
export async function open(browser, file, { width = 1280, height = 900, dark = false, javaScript = true } = {}) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? 'dark' : 'light',
    javaScriptEnabled: javaScript,
    offline: true,
  });
  // A busy machine may take long; what hangs takes for ever.
  context.setDefaultTimeout(180_000);
  const page = await context.newPage();
  page.faults = [];
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(message.text());
  });
  page.on('pageerror', (error) => page.faults.push(error.message));
  const url = pathToFileURL(file).href;
  page.on('request', (request) => {
    if (!request.url().startsWith(url) && !request.url().startsWith('data:')) page.faults.push(`asked for ${request.url()}`);
  });
  await page.goto(url);
  // Numbers are unpacked before they are drawn.
  if (javaScript) await page.waitForSelector('html[data-ready]', { state: 'attached' });
  return page;
}
