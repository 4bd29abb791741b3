import { el } from './dom.js';
import { startTheme } from './theme.js';
import { drawBench } from './bench.js';
import { drawAgreement, drawConvergence } from './convergence.js';
import { drawComparedBench, drawComparedHistories, drawComparedResponses } from './compared.js';
import { drawCorrelation } from './correlation.js';
import { drawHistories } from './histories.js';
import { drawPoles } from './poles.js';
import { drawResiduals } from './residuals.js';
import { drawResponses } from './responses.js';
import { drawViewer } from './viewer/viewer.js';

const drawers = {
  viewer: drawViewer,
  responses: drawResponses,
  residuals: drawResiduals,
  histories: drawHistories,
  bench: drawBench,
  correlation: drawCorrelation,
  poles: drawPoles,
  convergence: drawConvergence,
  agreement: drawAgreement,
  compared_responses: drawComparedResponses,
  compared_histories: drawComparedHistories,
  compared_bench: drawComparedBench,
};

/** Links to the sections, the one in view marked. */
function drawContents() {
  const links = new Map();
  for (const section of document.querySelectorAll('main > section'))
    links.set(section, el('a', { href: `#${section.id}` }, section.id[0].toUpperCase() + section.id.slice(1).replaceAll('-', ' ')));
  document.getElementById('contents').append(el('div', {}, ...links.values()));
  const mark = () => {
    let here = null;
    for (const section of links.keys()) if (!here || section.getBoundingClientRect().top < 120) here = section;
    for (const [section, link] of links) link.classList.toggle('here', section === here);
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
startTheme();
for (const place of document.querySelectorAll('[data-draw]')) {
  try {
    drawers[place.dataset.draw](place, data);
  } catch (error) {
    // The rest of the report stays readable.
    console.error(error);
    place.append(el('p', { class: 'note' }, `This part could not be drawn: ${error.message}`));
  }
}
removeEmpty();
drawContents();
