import { el, svg } from './dom.js';

/** A line as it is drawn. */
function sample(colour, { width = 2, dash = [] }) {
  const line = svg('line', { x1: 0, y1: 4, x2: 30, y2: 4, 'stroke-width': width, 'stroke-dasharray': dash.join(' ') });
  line.style.stroke = `var(--${colour})`;
  return svg('svg', { width: 30, height: 8, 'aria-hidden': true }, line);
}

/**
 * What marks stand for. `entries`: [mark, colour of the theme, label]; mark: line, dash, dot or patch, or the width and
 * dashes of a line.
 */
export function legend(...entries) {
  return el(
    'div',
    { class: 'legend' },
    ...entries.map(([mark, colour, label]) =>
      el('span', {}, typeof mark === 'string' ? el('i', { class: mark, style: { color: `var(--${colour})` } }) : sample(colour, mark), label),
    ),
  );
}
