import { chart, curve, linearAxis, logAxis } from './chart.js';
import { el } from './dom.js';
import { legend } from './legend.js';
import { extent, listOf, shown } from './number.js';
import { tools } from './tools.js';

function drawLog(place, log) {
  const x = log.map((entry) => entry.evaluations);
  const cost = log.map((entry) => (entry.best_cost > 0 ? entry.best_cost : null));
  const diversity = log.map((entry) => entry.diversity);
  const plot = el('div');
  const head = el('h3', {}, 'Cost and diversity');
  const box = el('div', { class: 'chart' }, head, plot);
  place.append(
    legend(['line', 'model', 'best cost'], ['dash', 'measured', 'diversity of the population']),
    box,
    el('p', { class: 'note' }, 'Cost (left) and diversity (right) over evaluations of the search.'),
  );
  const state = chart(
    plot,
    220,
    () => ({
      scales: {
        x: { time: false },
        y: { distr: 3, range: () => { const [low, high] = extent(cost) ?? [1, 10]; return [low / 1.3, high * 1.3]; } },
        // From below zero, so that its 0 stands clear of the axis below.
        d: { range: () => { const most = Math.max(1e-9, ...diversity.map((d) => d ?? 0)); return [-0.08 * most, 1.05 * most]; } },
      },
      axes: [
        linearAxis({ scale: 'x', side: 2, size: 24 }),
        logAxis('model'),
        linearAxis({ scale: 'd', side: 1, grid: false, colour: 'measured' }),
      ],
      series: [
        {},
        curve('best cost', 'model', { scale: 'y', paths: undefined }),
        curve('diversity', 'measured', { scale: 'd', dash: [4, 3], width: 1.2 }),
      ],
      cursor: { y: false },
    }),
    [x, cost, diversity],
    { name: 'best cost and diversity', unit: '', x: ['evaluations', ''] },
  );
  head.append(tools(box, 'search', [state]));
}

/** Where each refinement ended, parameter by parameter, between the bounds. */
export function drawAgreement(place, { result }) {
  const parameters = listOf(result.parameters);
  const runs = listOf(result.starts?.runs).filter((run) => Number.isFinite(run?.cost) && run.values?.length === parameters.length);
  if (runs.length < 2 || !parameters.length) return;
  const share = (parameter, value) => `${(100 * Math.min(1, Math.max(0, (value - parameter.lower) / (parameter.upper - parameter.lower)))).toFixed(2)}%`;
  const rows = parameters.map((parameter, i) =>
    el(
      'tr',
      {},
      el('td', {}, el('code', {}, parameter.name)),
      el(
        'td',
        {},
        el(
          'span',
          { class: 'bar wide' },
          ...runs.map((run, k) =>
            el('i', {
              class: run.agrees === false ? 'value ring other' : 'value ring',
              title: `start ${k + 1}: cost ${shown(run.cost, 6)}`,
              style: { left: share(parameter, run.values[i]) },
            }),
          ),
        ),
      ),
    ),
  );
  const others = runs.filter((run) => run.agrees === false).length;
  place.append(
    el('h3', {}, 'Optima of the refinements'),
    el('div', { class: 'table agreement' }, el('table', {}, el('tbody', {}, ...rows))),
    el(
      'p',
      { class: 'note' },
      `Each ring is one refinement, drawn between the parameter's bounds${others ? `; ${others} in grey ended at a higher cost` : '; all agree'}.`,
    ),
  );
}

/** Best cost and diversity over the search's evaluations. */
export function drawConvergence(place, data) {
  const log = listOf(data.result.search?.log).filter((entry) => entry?.best_cost != null);
  if (log.length > 1) drawLog(place, log);
}
