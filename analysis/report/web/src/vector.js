import { svg } from './dom.js';

/** A path as it is drawn, in numbers of SVG. */
class RecordedPath {
  constructor(path) {
    this.steps = path?.steps ? [...path.steps] : [];
  }

  #add(letter, ...numbers) {
    this.steps.push(letter + numbers.map((number) => Math.round(100 * number) / 100).join(' '));
  }

  moveTo(x, y) {
    this.#add('M', x, y);
  }

  lineTo(x, y) {
    this.#add(this.steps.length ? 'L' : 'M', x, y);
  }

  rect(x, y, width, height) {
    this.#add('M', x, y);
    this.#add('h', width);
    this.#add('v', height);
    this.#add('h', -width);
    this.closePath();
  }

  /** Whole circles alone, as dots are. */
  arc(x, y, radius) {
    this.#add('M', x - radius, y);
    this.#add('a', radius, radius, 0, 1, 0, 2 * radius, 0);
    this.#add('a', radius, radius, 0, 1, 0, -2 * radius, 0);
  }

  closePath() {
    this.steps.push('Z');
  }

  get d() {
    return this.steps.join('');
  }
}

const anchors = { left: 'start', start: 'start', right: 'end', end: 'end', center: 'middle' };
const baselines = { top: 'hanging', middle: 'central', bottom: 'text-after-edge', alphabetic: 'auto' };
let clips = 0;

/** Takes what a canvas is to draw, as far as charts draw, and makes SVG of it. */
class Recorder {
  constructor() {
    this.root = svg('g');
    this.state = { parent: this.root, turn: '', fillStyle: '#000', strokeStyle: '#000', lineWidth: 1, globalAlpha: 1, font: '', textAlign: 'start', textBaseline: 'alphabetic', lineJoin: 'miter', lineCap: 'butt', dash: '' };
    this.past = [];
    this.path = new RecordedPath();
    for (const name of ['fillStyle', 'strokeStyle', 'lineWidth', 'globalAlpha', 'font', 'textAlign', 'textBaseline', 'lineJoin', 'lineCap'])
      Object.defineProperty(this, name, { get: () => this.state[name], set: (value) => (this.state[name] = value) });
  }

  save() {
    this.past.push({ ...this.state });
  }

  restore() {
    if (this.past.length) this.state = this.past.pop();
  }

  beginPath() {
    this.path = new RecordedPath();
  }

  moveTo(x, y) {
    this.path.moveTo(x, y);
  }

  lineTo(x, y) {
    this.path.lineTo(x, y);
  }

  rect(...box) {
    this.path.rect(...box);
  }

  arc(...circle) {
    this.path.arc(...circle);
  }

  closePath() {
    this.path.closePath();
  }

  translate(x, y) {
    this.state.turn += `translate(${x} ${y})`;
  }

  rotate(angle) {
    this.state.turn += `rotate(${(180 / Math.PI) * angle})`;
  }

  setLineDash(dash) {
    this.state.dash = dash.join(' ');
  }

  clearRect() {}

  /** What follows until it is restored lies in a group that is clipped. */
  clip(path = this.path) {
    if (!path.d) return;
    const id = `clip${++clips}`;
    const group = svg('g', { 'clip-path': `url(#${id})` }, svg('clipPath', { id }, svg('path', { d: path.d })));
    this.state.parent.append(group);
    this.state.parent = group;
  }

  #put(tag, attributes, ...children) {
    const { parent, turn, globalAlpha } = this.state;
    parent.append(svg(tag, { ...attributes, ...(turn ? { transform: turn } : {}), ...(globalAlpha < 1 ? { opacity: globalAlpha } : {}) }, ...children));
  }

  stroke(path = this.path) {
    const { strokeStyle, lineWidth, lineJoin, lineCap, dash } = this.state;
    if (!path.d || !lineWidth) return;
    this.#put('path', { d: path.d, fill: 'none', stroke: strokeStyle, 'stroke-width': lineWidth, 'stroke-linejoin': lineJoin, 'stroke-linecap': lineCap, ...(dash ? { 'stroke-dasharray': dash } : {}) });
  }

  fill(path = this.path) {
    if (path.d) this.#put('path', { d: path.d, fill: this.state.fillStyle });
  }

  fillRect(x, y, width, height) {
    if (width > 0 && height > 0) this.#put('rect', { x, y, width, height, fill: this.state.fillStyle });
  }

  fillText(text, x, y) {
    const { fillStyle, font, textAlign, textBaseline } = this.state;
    const [, size, family] = /([\d.]+)px (.*)$/.exec(font) ?? [null, 11, 'sans-serif'];
    this.#put('text', { x, y, fill: fillStyle, 'font-size': size, 'font-family': family, 'text-anchor': anchors[textAlign] ?? 'start', 'dominant-baseline': baselines[textBaseline] ?? 'auto' }, text);
  }

  measureText(text) {
    return { width: 6 * text.length };
  }
}

/** A chart as SVG: `make` makes it anew, and is given a recorder where it asks for a canvas. */
export function vectorOf(make) {
  const recorder = new Recorder();
  const { getContext } = HTMLCanvasElement.prototype;
  const { Path2D } = globalThis;
  let plot;
  try {
    HTMLCanvasElement.prototype.getContext = () => recorder;
    globalThis.Path2D = RecordedPath;
    plot = make();
    // Draws at once.
    plot.batch(() => {});
  } finally {
    HTMLCanvasElement.prototype.getContext = getContext;
    globalThis.Path2D = Path2D;
  }
  const { width, height, ctx } = plot;
  plot.destroy();
  const drawn = ctx.root;
  // The chart draws once more before it learns that it is gone.
  ctx.root = ctx.state.parent = svg('g');
  return svg('svg', { viewBox: `0 0 ${width * devicePixelRatio} ${height * devicePixelRatio}`, width, height }, drawn);
}
