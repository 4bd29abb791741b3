import { el } from './dom.js';
import { canFollow, openWhatIf } from './live/whatif.js';

/** A button for the panel of sliders, where the page has no responses beside which it would stand. */
export function drawSliders(place, data) {
  if (!canFollow(data)) return;
  const opener = el('button', { type: 'button', class: 'opener' }, 'what if \u2026');
  opener.addEventListener('click', async () => {
    opener.disabled = true;
    try {
      const { panel, answer } = await openWhatIf(data, () => null, () => {
        opener.disabled = false;
        opener.focus();
      });
      place.append(panel);
      answer();
    } catch (error) {
      // The page stays what it is without.
      opener.replaceWith(el('span', { class: 'note' }, `This browser does not follow other values: ${error.message}`));
    }
  });
  place.append(el('div', { class: 'controls' }, opener));
}
