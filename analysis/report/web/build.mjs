// Bundles src/ and its libraries into ../bundle, which the C++ build takes into the program. The stage of the viewer, which
// is three.js for the most part, is packed: a page unpacks it when the vehicle comes into view.
// `--check` compares with what is there instead: exit code 1 where it differs.
import { readFileSync, writeFileSync, existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createHash } from 'node:crypto';
import { gunzipSync, gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { shadersOf } from './shaders.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const bundle = join(here, '..', 'bundle');
const limit = 420_000;

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

/** Whether a file has this text, packed or not: packers differ by version, what they pack does not. */
function holds(file, text, isPacked) {
  if (!existsSync(file)) return false;
  const held = readFileSync(file, 'utf8');
  return (isPacked ? gunzipSync(Buffer.from(held, 'base64')).toString() : held) === text;
}

const scripts = { format: 'iife', target: 'es2020' };
const stage = await bundled('viewer/stage.js', { ...scripts, globalName: 'fourpostStage' });
const texts = {
  // The licences stand where they can be read.
  'report.js': licence('three', 'LICENSE') + licence('uplot', 'LICENSE') + (await bundled('report.js', scripts)),
  'report.css': licence('uplot', 'LICENSE') + (await bundled('report.css', { target: ['chrome90', 'firefox90', 'safari14'] })),
  'stage.base64': stage,
  // By which a page's policy names it.
  'stage.sha256': createHash('sha256').update(stage).digest('base64'),
};

let size = 0;
let stale = false;
for (const [name, text] of Object.entries(texts)) {
  // The text stands in a script or style element and in a C++ literal.
  if (/<\/(script|style)|\)bundle"/i.test(text)) throw new Error(`${name} holds text that would end its element`);
  const file = join(bundle, name);
  const isPacked = name.endsWith('.base64');
  const held = isPacked ? gzipSync(text, { level: 9 }).toString('base64') : text;
  size += Buffer.byteLength(held);
  if (holds(file, text, isPacked)) continue;
  if (process.argv.includes('--check')) {
    console.error(`${file} is not what src/ makes: run \`npm run build\``);
    stale = true;
  } else {
    writeFileSync(file, held);
  }
}
console.log(`${size} bytes of ${limit}`);
if (size > limit) throw new Error('the bundle is too large');
if (stale) process.exit(1);
