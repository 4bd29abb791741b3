import { el } from './dom.js';

/** What marks stand for. `entries`: [mark, colour of the theme, label]; mark: line, dash, dot or patch. */
export function legend(...entries) {
  return el(
    'div',
    { class: 'legend' },
    ...entries.map(([mark, colour, label]) =>
      el('span', {}, el('i', { class: mark, style: { color: `var(--${colour})` } }), label),
    ),
  );
}
