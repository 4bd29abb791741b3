import { svg } from './dom.js';
import { onAnswer } from './live/answers.js';
import { extent, multiples, niceStep, shown } from './number.js';
import { framed } from './tools.js';

const margin = { left: 46, right: 18, top: 26, bottom: 40 };
/** Of a label of damping ratio. */
const ratioWidth = 34;

/** [{name, re, im}] of the upper half plane. */
function polesOf(modes) {
  return modes.flatMap((mode) => {
    const list = [];
    for (let i = 0; i + 1 < mode.poles.length; i += 2) list.push({ name: mode.name, re: mode.poles[i], im: Math.abs(mode.poles[i + 1]) });
    return list;
  });
}

/** Beside the pole first, then above and below, further off with a line to it. */
function places(isLeft) {
  const sides = [isLeft, !isLeft];
  return [...sides.map((side) => [side, 0]), ...[-13, 13, -26, 26, -39, 39, -52, 52, -65, 65, -78, 78, -91, -104, -117].flatMap((shift) => sides.map((side) => [side, shift]))];
}

/** What a reader looks for first: motions of the whole body. */
const isBodys = (name) => /^(heave|pitch|roll|yaw|bounce|warp|lateral|fore)/.test(name);

const areApart = (a, b) => Math.abs(a.y - b.y) > 11 || a.x > b.x + b.length || b.x > a.x + a.length;

/** Labels moved apart downwards and upwards from their poles, and off boxes where others stand. */
function placed(points, { width, height }, others) {
  const taken = [...others, ...points.map(({ x, y }) => ({ x: x - 6, y: y - 6, length: 12 }))];
  return points
    .sort((a, b) => isBodys(b.name) - isBodys(a.name) || a.y - b.y || a.x - b.x)
    .map((point) => {
      const length = 6.4 * point.name.length + 8;
      for (const [toLeft, shift] of places(point.x + length > width - margin.right)) {
        const box = { x: toLeft ? point.x - length - 6 : point.x + 7, y: point.y + shift - 6, length };
        const inside = box.y > margin.top - 8 && box.y < height - margin.bottom - 4 && box.x > 0 && box.x + length < width;
        const free = taken.every((other) => areApart(box, other));
        if (!inside || !free) continue;
        taken.push(box);
        return { ...point, labelX: toLeft ? point.x - 7 : point.x + 7, labelY: point.y + shift, anchor: toLeft ? 'end' : 'start' };
      }
      return point;
    });
}

/** Rays of constant damping ratio with their labels, at the left or above; those that would cover another have none. */
function rays({ x, y, low, top }) {
  const list = [];
  for (const ratio of [0.1, 0.2, 0.4, 0.7]) {
    // im = -re sqrt(1 - ratio^2) / ratio
    const slope = Math.sqrt(1 - ratio * ratio) / ratio;
    const re = Math.max(low, (-top * 2 * Math.PI) / slope);
    const f = (-re * slope) / (2 * Math.PI);
    const isLeft = re === low && y(f) > margin.top + 14;
    const left = isLeft ? x(low) + 3 : Math.max(margin.left - 4, x(re) - ratioWidth / 2);
    const baseline = isLeft ? y(f) - 3 : margin.top - 7;
    const box = { x: left, y: baseline - 10, length: ratioWidth };
    list.push({ ratio, re, f, box, baseline, isLabelled: list.every((ray) => !ray.isLabelled || areApart(ray.box, box)) });
  }
  return list;
}

/** The pole of a mode of the sliders' car, and the way from that of the fit. */
function movedPole({ name, pole: [re, im], of }, { x, y }) {
  const hz = (value) => Math.abs(value) / (2 * Math.PI);
  const at = [x(re), y(hz(im))];
  const stroke = 'var(--whatif)';
  const cross = svg('path', { d: `M${at[0] - 4} ${at[1] - 4}l8 8m0-8l-8 8`, 'stroke-width': 1.8, fill: 'none' }, svg('title', {}, `what if, ${name || 'new'}: ${shown(re, 4)} + ${shown(Math.abs(im), 4)}i 1/s`));
  cross.style.stroke = stroke;
  if (!of?.poles) return [cross];
  const way = svg('line', { x1: x(of.poles[0]), y1: y(hz(of.poles[1])), x2: at[0], y2: at[1], 'stroke-width': 1 });
  way.style.stroke = stroke;
  return [way, cross];
}

/** The s plane, imaginary parts in Hz, with rays of constant damping ratio. */
export function drawPoles(place, data) {
  const poles = polesOf(data.scene?.modes ?? []).filter((pole) => Number.isFinite(pole.re));
  if (!poles.length) return;
  const width = Math.max(300, Math.min(560, place.clientWidth || 560));
  const height = Math.round(0.4 * width) + 120;
  const hz = (im) => im / (2 * Math.PI);
  const [least, greatest] = extent(poles.map((pole) => pole.re), [0]);
  const low = least * 1.08 || -1;
  const high = Math.max(greatest * 1.1, -0.04 * low);
  const top = Math.max(1, 1.12 * Math.max(...poles.map((pole) => hz(pole.im))));
  const x = (re) => margin.left + ((re - low) / (high - low)) * (width - margin.left - margin.right);
  const y = (f) => height - margin.bottom - (f / top) * (height - margin.top - margin.bottom);
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, width, role: 'img', 'aria-label': 'pole map' });
  const line = (x1, y1, x2, y2, dash) => {
    const path = svg('line', { x1, y1, x2, y2, 'stroke-width': 0.8, ...(dash ? { 'stroke-dasharray': '3 4' } : {}) });
    path.style.stroke = 'var(--line)';
    return path;
  };
  const text = (at, options, words) => svg('text', { x: at[0], y: at[1], 'font-size': 11, ...options }, words);
  for (const re of multiples(low, high, niceStep(high - low, width / 80)))
    picture.append(line(x(re), y(0), x(re), y(top)), text([x(re), y(0) + 15], { 'text-anchor': 'middle', class: 'dim' }, shown(re, 3)));
  for (const f of multiples(0, top, niceStep(top, 6)))
    picture.append(line(x(low), y(f), x(high), y(f)), text([margin.left - 7, y(f) + 4], { 'text-anchor': 'end', class: 'dim' }, shown(f, 3)));
  const lines = rays({ x, y, low, top });
  for (const { ratio, re, f, box, baseline, isLabelled } of lines) {
    picture.append(line(x(0), y(0), x(re), y(f), true));
    if (isLabelled) picture.append(text([box.x + 2, baseline], { class: 'dim' }, `\u03b6 ${ratio}`));
  }
  const axis = line(x(0), y(0), x(0), y(top));
  axis.style.stroke = 'var(--muted)';
  picture.append(axis);
  for (const pole of placed(poles.map((pole) => ({ ...pole, x: x(pole.re), y: y(hz(pole.im)) })), { width, height }, lines.filter((ray) => ray.isLabelled).map((ray) => ray.box))) {
    const cross = svg('path', { d: `M${pole.x - 4} ${pole.y - 4}l8 8m0-8l-8 8`, 'stroke-width': 1.8, fill: 'none' });
    cross.style.stroke = 'var(--model)';
    cross.append(svg('title', {}, `${pole.name}: ${shown(pole.re, 4)} + ${shown(pole.im, 4)}i 1/s`));
    picture.append(cross);
    if (pole.labelX && Math.abs(pole.labelY - pole.y) > 13) {
      const way = line(pole.x, pole.y, pole.labelX, pole.labelY);
      way.style.stroke = 'var(--muted)';
      picture.append(way);
    }
    if (pole.labelX) picture.append(text([pole.labelX, pole.labelY + 4], { 'text-anchor': pole.anchor }, pole.name));
  }
  const moved = svg('g', { class: 'moved' });
  picture.append(moved);
  onAnswer((answer) => moved.replaceChildren(...(answer?.modes ?? []).filter(({ kind }) => kind !== 'free').flatMap((mode) => movedPole(mode, { x, y }))));
  picture.append(
    text([(margin.left + width) / 2, height - 6], { 'text-anchor': 'middle', class: 'dim' }, 'real part, 1/s'),
    text([margin.left - 7, margin.top - 14], { class: 'dim', 'text-anchor': 'end' }, 'Hz'),
  );
  const columns = () => [
    { name: 'mode', values: poles.map(({ name }) => name) },
    { name: 'real part [1/s]', values: poles.map(({ re }) => re) },
    { name: 'imaginary part [Hz]', values: poles.map(({ im }) => hz(im)) },
  ];
  place.append(framed('pole map', picture, columns));
}
