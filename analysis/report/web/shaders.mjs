// three.js brings the shaders of all its materials as text; a page needs those of a few.
import { readFileSync } from 'node:fs';

/** A text of the library: a line `var NAME = "...";`, or with `const`. */
const literal = /^(var|const) ([\w$]+) = (".*");$/gm;
/** How a shader takes in another. */
const include = /#include +<([\w.]+)>/g;

/** By name the texts that a shader may include. */
function chunksOf(source) {
  const texts = new Map([...source.matchAll(literal)].map(([, , name, text]) => [name, JSON.parse(text)]));
  const list = /^const ShaderChunk = \{$(.*?)^\};$/ms.exec(source)?.[1];
  if (!list) throw new Error('three.js keeps its shaders elsewhere: see shaders.mjs');
  const chunks = new Map([...list.matchAll(/(\w+): ([\w$]+)/g)].map(([, chunk, name]) => [chunk, { name, text: texts.get(name) }]));
  for (const [chunk, { text }] of chunks) if (text == null) throw new Error(`three.js has no text for its shader '${chunk}': see shaders.mjs`);
  return chunks;
}

/** Names of what these shaders are made of. */
function partsOf(chunks, wanted) {
  const parts = new Set();
  const take = (chunk) => {
    if (parts.has(chunk)) return;
    if (!chunks.has(chunk)) throw new Error(`three.js has no shader '${chunk}'`);
    parts.add(chunk);
    for (const [, other] of chunks.get(chunk).text.matchAll(include)) take(other);
  };
  for (const chunk of wanted) take(chunk);
  return parts;
}

/** Without comments, indents and empty lines. */
function bare(text) {
  const lines = text.replace(/\/\*.*?\*\//gs, '').split('\n').map((line) => line.replace(/\/\/.*/, '').trim());
  return lines.filter((line) => line).join('\n');
}

/** An esbuild plugin: the shaders of these materials of three.js, by their names in ShaderLib, and no others. */
export function shadersOf(...materials) {
  return {
    name: 'shaders',
    setup(build) {
      build.onLoad({ filter: /three\.module\.js$/ }, ({ path }) => {
        const source = readFileSync(path, 'utf8');
        const chunks = chunksOf(source);
        const taken = [...source.matchAll(/ShaderChunk\[ '(\w+)' \]/g)].map(([, chunk]) => chunk);
        const parts = partsOf(chunks, [...materials.flatMap((name) => [`mesh${name}_vert`, `mesh${name}_frag`]), ...taken]);
        const text = new Map([...chunks].map(([chunk, { name, text: all }]) => [name, parts.has(chunk) ? bare(all) : '']));
        const contents = source.replace(literal, (line, kind, name) => (text.has(name) ? `${kind} ${name} = ${JSON.stringify(text.get(name))};` : line));
        return { contents, loader: 'js' };
      });
    },
  };
}
