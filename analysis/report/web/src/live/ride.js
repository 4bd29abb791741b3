// What the car of the sliders is like on a road, beside that of the fit.

import { inAddress, putInAddress } from '../address.js';
import { el } from '../dom.js';
import { fit as fitName } from '../line_name.js';
import { fixed, listOf, shown } from '../number.js';

const classes = [...'ABCDEFGH'];
/** Of ISO 8608 [m^3]: A to H, each four times as rough as the one before. */
const roughnessOf = (road) => 16e-6 * 4 ** classes.indexOf(road);

/** [least, greatest] of the field for the speed [km/h]. */
const speeds = [5, 300];
/** A ride that takes longer [ms] waits until the hand rests. */
const quick = 40;
const often = 0.01;
const coarse = 0.005;
const gaussian = 'these numbers assume Gaussian motion and are rough.';

/** Numbers of a ride as rows: [heading, [[name, value], ...]]. */
function numbersOf({ points, tyres, dampers }, ride) {
  return [
    ['weighted acceleration, m/s\u00b2 rms', points.map(({ name, weighting }, i) => [`${name} ${weighting}`, ride?.points[i].weighted])],
    ['tyre load variation, % rms of static', tyres.map((name, i) => [name, ride && 100 * ride.tyres[i].variation])],
    ['damper travel, mm rms', dampers.map((name, i) => [name, ride && 1e3 * ride.dampers[i].travel])],
  ].filter(([, rows]) => rows.length);
}

/** "+4.2 %", empty without both. */
function changeOf(then, now) {
  if (!(then > 0) || !Number.isFinite(now)) return '';
  const change = 100 * (now / then - 1);
  const text = fixed(change, 1);
  return `${change > 0 && Number(text) !== 0 ? '+' : ''}${text} %`;
}

/** Three digits or more of both, at the same decimals. */
function decimalsOf(...values) {
  const sizes = values.filter((value) => value > 0).map((value) => 2 - Math.floor(Math.log10(value)));
  return Math.min(6, Math.max(0, ...sizes));
}

function bodies(about, fitted, now) {
  const then = numbersOf(about, fitted);
  return numbersOf(about, now).map(([heading, rows], g) =>
    el(
      'tbody',
      {},
      el('tr', {}, el('th', { scope: 'rowgroup', colSpan: 4 }, heading)),
      ...rows.map(([name, value], i) => {
        const before = then[g][1][i][1];
        const change = changeOf(before, value);
        const decimals = decimalsOf(before, value);
        return el('tr', { class: /[1-9]/.test(change) ? 'changed' : '' }, el('th', { scope: 'row' }, el('code', {}, name)), ...[fixed(before, decimals), fixed(value, decimals), change].map((text) => el('td', { class: 'n' }, text)));
      }),
    ),
  );
}

/** What makes the numbers rough, as the program warns of it. */
function doubtsOf({ tyres: names }, { converged, gridError, stopContact, tyres }) {
  const worst = tyres.reduce((most, { offGround }, i) => (offGround > tyres[most].offGround ? i : most), 0);
  return [
    converged ? '' : 'The statistical linearisation does not converge: these numbers are rough.',
    converged && gridError > coarse ? `A mode has next to no damping: halving the steps in frequency still changes a number by ${shown(100 * gridError, 2)} %.` : '',
    tyres[worst]?.offGround > often ? `${names[worst]} is off the ground for ${shown(100 * tyres[worst].offGround, 2)} % of the time: ${gaussian}` : '',
    stopContact > often ? `A stop is in contact for ${shown(100 * stopContact, 2)} % of the time: ${gaussian}` : '',
  ].filter((text) => text);
}

/** Class and speed of an address: "B:80". */
function roadInAddress({ road, speed }) {
  const [name, text] = (inAddress('road') ?? '').split(':');
  const given = Number(text);
  return { road: classes.includes(name) ? name : road, speed: given >= speeds[0] && given <= speeds[1] ? given : Number((3.6 * speed).toPrecision(6)) };
}

/**
 * The part of the panel that has the ride. `vehicle`: of openVehicle(); `fit`: its values, SI; `ask`: called for an answer
 * where the reader wants another road. {box, follow}: follow(values, rests) gives the ride at these values, at which the
 * vehicle is and stays, with its `road` and `speed` [km/h], or null.
 */
export function rideTable(about, vehicle, fit, ask) {
  if (!about) return { box: el('p', { class: 'note' }, 'No ride numbers: no post moves this vehicle.'), follow: () => null };
  const counts = { points: listOf(about.points).length, tyres: listOf(about.tyres).length, dampers: listOf(about.dampers).length };
  const chosen = roadInAddress(about);
  const own = { road: about.road, speed: Number((3.6 * about.speed).toPrecision(6)) };
  let fitted = null;
  let lasts = 0;
  const said = el('p', { class: 'note', role: 'status' });
  const title = el('summary');
  const table = el('table', {}, el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'ride'), ...[fitName, 'now', 'change'].map((head) => el('th', { class: 'n', scope: 'col' }, head)))));

  const over = () => vehicle.ride({ roughness: roughnessOf(chosen.road), speed: chosen.speed / 3.6, band_Hz: about.band_Hz }, counts);
  /** At the values of the fit, once a road. */
  const ofFit = (values) => {
    if (fitted) return;
    fitted = { ride: null };
    try {
      vehicle.set(fit);
      fitted.ride = over();
    } catch {
      // Said of the values now, which are these at first.
    } finally {
      vehicle.set(values);
    }
  };
  const change = () => {
    fitted = null;
    const isOwn = chosen.road === own.road && chosen.speed === own.speed;
    putInAddress('road', isOwn ? null : `${chosen.road}:${chosen.speed}`);
    head();
    ask();
  };
  const road = el('select', { 'aria-label': 'road class of ISO 8608', onchange: () => ((chosen.road = road.value), change()) }, ...classes.map((name) => el('option', { value: name, selected: name === chosen.road }, name)));
  const speed = el('input', {
    type: 'number',
    class: 'number',
    min: speeds[0],
    max: speeds[1],
    step: 'any',
    value: chosen.speed,
    'aria-label': 'speed, km/h',
    onchange: () => {
      const given = Number(speed.value);
      if (given > 0) chosen.speed = Math.min(speeds[1], Math.max(speeds[0], given));
      speed.value = chosen.speed;
      change();
    },
  });
  const head = () => (title.textContent = `ride on road ${chosen.road} at ${shown(chosen.speed, 3)} km/h`);
  const box = el(
    'details',
    { class: 'ride', open: true, ontoggle: () => box.open && ask() },
    title,
    el('p', { class: 'road' }, el('label', {}, 'road ', road), el('label', {}, speed, ' km/h')),
    said,
    table,
    el('p', { class: 'note' }, `ISO 8608, ${about.band_Hz.join(' to ')} Hz, by power spectra, as fourpost ride.`),
  );
  head();

  function follow(values, rests) {
    // Folded, it follows for the charts alone.
    const waits = !rests && (!box.open || lasts > quick);
    table.setAttribute('aria-busy', waits);
    if (waits) return null;
    const begin = performance.now();
    ofFit(values);
    let ride = null;
    try {
      ride = over();
      said.textContent = doubtsOf(about, ride).join(' ');
    } catch (error) {
      said.textContent = `No ride numbers: ${error.message}.`;
    }
    lasts = performance.now() - begin;
    for (const body of [...table.tBodies]) body.remove();
    table.append(...bodies(about, fitted.ride, ride));
    return ride && { ...ride, ...chosen };
  }
  return { box, follow };
}
