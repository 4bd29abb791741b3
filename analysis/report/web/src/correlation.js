import { el, svg } from './dom.js';
import { fixed, listOf } from './number.js';
import { framed } from './tools.js';

/** Orange for +1, blue for -1, the ground for 0. */
function fill(value) {
  const colour = value >= 0 ? 'var(--model)' : 'var(--measured)';
  return `color-mix(in srgb, ${colour} ${fixed(100 * Math.abs(value), 0)}%, var(--ground))`.replace('\u2212', '-');
}

/** The lower triangle of the correlations; names at the left and, slanted, on the diagonal. */
export function drawCorrelation(place, data) {
  const matrix = listOf(data.result.identifiability?.correlation);
  const names = listOf(data.result.parameters).map((parameter) => String(parameter?.name));
  if (matrix.length !== names.length || names.length < 2 || !matrix.every((row) => row?.length === names.length)) return;
  const n = names.length;
  const side = Math.max(10, Math.min(36, 880 / n));
  const letters = Math.max(...names.map((name) => name.length));
  const size = Math.min(12, side);
  const left = Math.min(220, letters * size * 0.62 + 12);
  const top = 6;
  const width = left + n * side + left * 0.75;
  const picture = svg('svg', { viewBox: `0 0 ${width} ${top + n * side + 8}`, width, role: 'img', 'aria-label': 'correlations of the parameters' });
  for (let i = 0; i < n; ++i) {
    const y = top + i * side;
    picture.append(svg('text', { x: left - 6, y: y + side / 2, 'text-anchor': 'end', 'dominant-baseline': 'central', 'font-size': size }, names[i]));
    for (let j = 0; j < i; ++j) {
      const value = matrix[i][j];
      const box = svg(
        'rect',
        { x: left + j * side + 0.5, y: y + 0.5, width: side - 1, height: side - 1 },
        svg('title', {}, `${names[i]}, ${names[j]}: ${value == null ? 'not determined' : fixed(value, 3)}`),
      );
      box.style.fill = value == null ? 'var(--faint)' : fill(value);
      picture.append(box);
      if (side >= 26 && value != null)
        picture.append(
          svg('text', { x: left + (j + 0.5) * side, y: y + side / 2, 'text-anchor': 'middle', 'dominant-baseline': 'central', 'font-size': 10, 'pointer-events': 'none' }, fixed(value, 2).replace('0.', '.')),
        );
    }
    const at = left + i * side + 4;
    if (i < n - 1) picture.append(svg('text', { x: at, y: y + side / 2, 'dominant-baseline': 'central', 'font-size': size }, names[i]));
  }
  place.append(
    el('p', { class: 'note' }, 'Correlations of the fitted parameters: near +1 or \u22121 the data determine a combination of the two, not each.'),
    framed('correlations', picture, () => [{ name: 'parameter', values: names }, ...names.map((name, j) => ({ name, values: matrix.map((row) => row[j]) }))]),
  );
}
