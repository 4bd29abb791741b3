import { keepAddress } from './address.js';
import { el } from './dom.js';
import { onPaper, startTheme } from './theme.js';
import { drawBench } from './bench.js';
import { drawAgreement, drawConvergence } from './convergence.js';
import { drawComparedBench, drawComparedHistories, drawComparedResponses } from './compared.js';
import { drawCorrelation } from './correlation.js';
import { drawCurves } from './curves.js';
import { drawComparedErrors, drawComparedParameters } from './paired.js';
import { drawHistories } from './histories.js';
import { asking } from './live/asking.js';
import { canFollow } from './live/whatif.js';
import { nameFit } from './line_name.js';
import { drawOverview } from './overview.js';
import { drawPoles } from './poles.js';
import { drawResiduals } from './residuals.js';
import { drawResponses } from './responses.js';
import { drawSliders } from './sliders.js';
import { readTables } from './tables.js';
import { saveStills } from './tools.js';
import { drawViewer } from './viewer/viewer.js';

const drawers = {
  overview: drawOverview,
  viewer: drawViewer,
  responses: drawResponses,
  residuals: drawResiduals,
  histories: drawHistories,
  bench: drawBench,
  correlation: drawCorrelation,
  curves: drawCurves,
  sliders: drawSliders,
  poles: drawPoles,
  convergence: drawConvergence,
  agreement: drawAgreement,
  compared_errors: drawComparedErrors,
  compared_parameters: drawComparedParameters,
  compared_responses: drawComparedResponses,
  compared_histories: drawComparedHistories,
  compared_bench: drawComparedBench,
};

/** A word for the menu: its id, or its heading where there are several of a kind, as axles are. */
function nameOf(section) {
  const heading = section.querySelector('h2')?.textContent;
  if (/\d$/.test(section.id) && heading) return heading;
  return section.id[0].toUpperCase() + section.id.slice(1).replaceAll('-', ' ');
}

/** Links to the sections, the one in view marked. */
function drawContents() {
  const links = new Map();
  for (const section of document.querySelectorAll('main > section'))
    links.set(section, el('a', { href: `#${section.id}` }, nameOf(section)));
  const list = el('div', {}, ...links.values());
  const nav = document.getElementById('contents');
  nav.setAttribute('aria-label', 'contents');
  nav.append(list);
  if (canFollow(data) && document.querySelector('.opener')) {
    list.className = 'beside-asking';
    nav.append(asking());
  }
  let marked = null;
  const mark = () => {
    let here = null;
    for (const section of links.keys()) if (!here || section.getBoundingClientRect().top < 120) here = section;
    if (here === marked) return;
    marked = here;
    for (const [section, link] of links) {
      link.classList.toggle('here', section === here);
      if (section === here) link.setAttribute('aria-current', 'true');
      else link.removeAttribute('aria-current');
    }
    // In view where the list is wider than the screen.
    const link = links.get(here);
    if (link) list.scrollLeft = link.offsetLeft - list.offsetLeft - (list.clientWidth - link.offsetWidth) / 2;
  };
  addEventListener('scroll', mark, { passive: true });
  mark();
}

/** Sections in which neither the program nor the scripts had anything to show. */
function removeEmpty() {
  const isEmpty = (element) => element.matches('h2, noscript') || (element.matches('.drawn') && [...element.children].every(isEmpty));
  for (const section of document.querySelectorAll('main > section')) if ([...section.children].every(isEmpty)) section.remove();
}

const data = JSON.parse(document.getElementById('data').textContent);

if (data.line) nameFit(data.line);

/** What is named after a colon, as in `curves:impulse`, is one of several. The rest stays readable where a part cannot be drawn. */
async function draw(place) {
  try {
    const [drawer, ...named] = place.dataset.draw.split(':');
    await drawers[drawer](place, data, named.join(':'));
  } catch (error) {
    console.error(error);
    place.append(el('p', { class: 'note' }, `This part could not be drawn: ${error.message}`));
  }
}

/** Terms that the page explains say what they mean where the pointer rests on them. */
function explainTerms() {
  for (const term of document.querySelectorAll('.terms dt')) {
    const word = term.textContent;
    for (const cell of term.closest('section').querySelectorAll('th, td:nth-child(2)'))
      if (!cell.title && new RegExp(`(^|\\W)${word}(\\W|$)`).test(cell.textContent.replaceAll('\u00a0', ' '))) {
        cell.title = `${word}: ${term.nextElementSibling.textContent}`;
        cell.classList.add('explained');
      }
  }
}

/** On paper nothing is folded. */
function unfoldOnPaper() {
  let shut = [];
  onPaper((isOn) => {
    if (isOn) shut = [...document.querySelectorAll('details.folded:not([open])')];
    for (const details of shut) details.open = isOn;
  });
}

startTheme();
unfoldOnPaper();
Promise.all([...document.querySelectorAll('[data-draw]')].map(draw)).then(() => {
  removeEmpty();
  readTables();
  explainTerms();
  saveStills();
  drawContents();
  keepAddress();
  document.documentElement.dataset.ready = '';
});
