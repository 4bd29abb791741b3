import { inAddress } from './address.js';
import { el } from './dom.js';
import { canFollow, openWhatIf } from './live/whatif.js';

/** A button for the panel of sliders, on a page without responses, beside which it stands otherwise; beside what follows. */
export function drawSliders(place, data) {
  if (!canFollow(data) || data.responses?.length) return;
  const opener = el('button', { type: 'button', class: 'opener' }, 'what if \u2026');
  opener.addEventListener('click', async () => {
    opener.disabled = true;
    try {
      const follows = place.parentElement.querySelector('.follows');
      const { panel, answer } = await openWhatIf(data, () => null, () => {
        opener.disabled = false;
        follows?.classList.remove('beside');
        opener.focus();
      });
      follows?.classList.add('beside');
      if (follows) follows.prepend(panel);
      else place.append(panel);
      answer();
      panel.querySelector('input[type=range]').focus({ preventScroll: true });
    } catch (error) {
      // The page stays what it is without.
      opener.replaceWith(el('span', { class: 'note' }, `This browser does not follow other values: ${error.message}`));
    }
  });
  place.append(el('div', { class: 'controls' }, opener));
  if (inAddress('whatif')) opener.click();
}
