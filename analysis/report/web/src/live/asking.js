import { el } from '../dom.js';

/** Opens the panel of sliders, wherever on the page its own button is, and shows it. */
function ask() {
  const opener = document.querySelector('.opener');
  const show = () => document.querySelector('.whatif')?.scrollIntoView({ block: 'nearest' });
  if (!opener) return;
  opener.scrollIntoView({ block: 'start' });
  if (opener.disabled) {
    show();
    document.querySelector('.whatif input[type=range]')?.focus({ preventScroll: true });
  } else opener.click();
}

/** A further button for the panel, beside what a reader sees first. */
export const asking = () => el('button', { type: 'button', class: 'asking', title: 'sliders for all parameters; curves, misfit, modes and vehicle follow', onclick: ask }, 'what if \u2026');
