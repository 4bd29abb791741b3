// Bundles src/ and its libraries into ../bundle, which the C++ build takes into the program.
// `--check` compares with what is there instead: exit code 1 where it differs.
import { readFileSync, writeFileSync, existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { shadersOf } from './shaders.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const bundle = join(here, '..', 'bundle');
const limit = 700_000;

/** The licence of a library as a comment that minifying leaves. */
function licence(name, file) {
  const { version } = JSON.parse(readFileSync(join(here, 'node_modules', name, 'package.json'), 'utf8'));
  const text = readFileSync(join(here, 'node_modules', name, file), 'utf8').trim();
  return `/*! ${name} ${version}\n\n${text}\n*/\n`;
}

async function bundled(entry, options) {
  const { outputFiles } = await build({
    entryPoints: [join(here, 'src', entry)],
    bundle: true,
    minify: true,
    charset: 'ascii',
    legalComments: 'none',
    write: false,
    absWorkingDir: here,
    // Of MeshLambertMaterial and LineBasicMaterial.
    plugins: [shadersOf('lambert', 'basic')],
    ...options,
  });
  return outputFiles[0].text;
}

const licences = licence('three', 'LICENSE') + licence('uplot', 'LICENSE');
const texts = {
  'report.js': licences + (await bundled('report.js', { format: 'iife', target: 'es2020' })),
  'report.css': licence('uplot', 'LICENSE') + (await bundled('report.css', { target: ['chrome90', 'firefox90', 'safari14'] })),
};

let size = 0;
let stale = false;
for (const [name, text] of Object.entries(texts)) {
  // The text stands in a script or style element and in a C++ literal.
  if (/<\/(script|style)|\)bundle"/i.test(text)) throw new Error(`${name} holds text that would end its element`);
  size += Buffer.byteLength(text);
  const file = join(bundle, name);
  if (process.argv.includes('--check')) {
    if (existsSync(file) && readFileSync(file, 'utf8') === text) continue;
    console.error(`${file} is not what src/ makes: run \`npm run build\``);
    stale = true;
  } else {
    writeFileSync(file, text);
  }
}
console.log(`${size} bytes of ${limit}`);
if (size > limit) throw new Error('the bundle is too large');
if (stale) process.exit(1);
