import { choice, el, tick } from '../dom.js';
import { fixed, shown } from '../number.js';
import { colours, isDark, onTheme } from '../theme.js';
import { coordinatesAt, greatestMotion, motionsOf, phasors } from './motion.js';
import { Stage } from './stage.js';

/** How long a cycle is on the screen [s]; a fast motion is shown slower. */
const cycle_s = 1.6;
/** What the largest motion is drawn as, in sizes of the vehicle. */
const share = 0.045;

/** Points of each link whose motion counts, from its origin in ground axes. */
function pointsOf(stage, scene) {
  const points = scene.links.map((link) => (link.mass > 0 ? [[0, 0, 0]] : []));
  const lines = [...scene.springs, ...scene.dampers, ...scene.rods];
  for (const end of [...lines.flatMap((line) => line.ends), ...scene.tyres.map((tyre) => tyre.point)]) {
    const at = stage.at(end);
    const { place } = scene.links[end.link];
    points[end.link].push([at.x - place[0], at.y - place[1], at.z - place[2]]);
  }
  return points;
}

function optionsOf(motions) {
  const groups = { mode: el('optgroup', { label: 'Modes' }), response: el('optgroup', { label: 'Responses to the posts' }) };
  for (const motion of motions) {
    const words =
      motion.kind === 'mode'
        ? `${motion.name}, ${shown(motion.mode.frequency_Hz, 3)} Hz, damping ratio ${shown(motion.mode.damping_ratio, 2)}`
        : motion.name;
    groups[motion.kind].append(el('option', { value: motion.id }, words));
  }
  return Object.values(groups).filter((group) => group.children.length);
}

class Viewer {
  constructor(place, scene) {
    this.scene = scene;
    this.motions = motionsOf(scene);
    this.chosen = this.motions[0];
    this.at = 0;
    this.phase = 0;
    this.strength = 1;
    this.playing = false;
    this.canvas = el('canvas', { 'aria-label': 'the vehicle on its posts; drag to turn' });
    this.caption = el('div', { class: 'caption' });
    this.frame = el('div', { class: 'viewer' }, this.canvas, this.caption);
    const palette = () => ({ ...colours(), dark: isDark() });
    this.stage = new Stage(this.canvas, scene, palette());
    this.points = pointsOf(this.stage, scene);
    place.append(this.#controls(), this.frame, this.#transport());
    onTheme(() => {
      this.stage.setPalette(palette());
      this.#fit();
    });
    this.stage.controls.addEventListener('change', () => this.draw());
    new ResizeObserver(() => this.#fit()).observe(this.frame);
    new IntersectionObserver(([entry]) => (this.visible = entry.isIntersecting)).observe(this.frame);
    this.#fit();
    this.choose(this.chosen);
  }

  #fit() {
    const width = this.frame.clientWidth;
    const height = Math.round(Math.min(460, Math.max(260, 0.52 * width)));
    this.canvas.style.height = `${height}px`;
    this.stage.resize(width, height);
    this.draw();
  }

  #controls() {
    const select = el('select', { 'aria-label': 'motion', onchange: () => this.choose(this.motions.find((motion) => motion.id === select.value)) }, ...optionsOf(this.motions));
    const views = [['corner', 'corner'], ['side', 'side'], ['front', 'front'], ['top', 'top']];
    const view = choice('view', views, 'corner', (name) => {
      this.stage.view(name);
      this.draw();
    });
    const strength = el('input', { type: 'range', min: -1, max: 1, step: 0.01, value: 0, 'aria-label': 'exaggeration', oninput: () => {
      this.strength = 4 ** Number(strength.value);
      this.draw();
    } });
    return el(
      'div',
      { class: 'controls' },
      this.motions.length ? el('label', {}, 'motion', select) : null,
      view,
      el('label', {}, 'size of motion', strength),
      tick('sensors', true, (on) => {
        this.stage.sensors.visible = on;
        this.draw();
      }),
    );
  }

  #transport() {
    this.button = el('button', { type: 'button', class: 'play', onclick: () => this.play(!this.playing) }, 'play');
    this.scrub = el('input', { type: 'range', class: 'scrub', min: 0, max: 360, step: 1, value: 0, 'aria-label': 'phase of the cycle', oninput: () => {
      this.play(false);
      this.phase = (Number(this.scrub.value) * Math.PI) / 180;
      this.draw();
    } });
    this.frequency = el('input', { type: 'range', min: 0, step: 1, value: 0, 'aria-label': 'frequency', oninput: () => {
      this.at = Number(this.frequency.value);
      this.#measure();
      this.draw();
    } });
    this.hertz = el('output');
    this.frequencies = el('label', {}, 'frequency', this.frequency, this.hertz);
    return el('div', { class: 'controls' }, this.button, el('label', { class: 'scrub' }, 'phase', this.scrub), this.frequencies);
  }

  choose(motion) {
    this.chosen = motion;
    this.frequencies.hidden = motion?.kind !== 'response';
    this.frequencies.style.display = this.frequencies.hidden ? 'none' : '';
    if (motion?.kind === 'response') {
      const last = motion.motion.frequency_Hz.length - 1;
      this.at = Math.min(this.at || Math.floor(last / 3), last);
      this.frequency.max = last;
      this.frequency.value = this.at;
    }
    this.#measure();
    this.draw();
  }

  /** By how much the motion is drawn larger than it is, at a strength of 1. */
  #measure() {
    if (!this.chosen) return;
    const { coordinates, posts } = phasors(this.scene, this.chosen, this.at);
    const greatest = Math.max(greatestMotion(this.scene, coordinates, this.points), ...posts.map(([re, im]) => Math.hypot(re, im)));
    this.factor = greatest > 0 ? (share * this.stage.size) / greatest : 1;
  }

  #captionText() {
    if (!this.chosen) return 'In its design pose.';
    const missing = this.scene.missing.length ? ' Some meshes could not be read.' : '';
    if (this.chosen.kind === 'mode') {
      const { name, frequency_Hz, kind } = this.chosen.mode;
      const words = kind === 'oscillating' ? '' : `, ${kind}`;
      return `${name}, ${shown(frequency_Hz, 3)} Hz${words}${this.#slower(frequency_Hz)}${missing}`;
    }
    const frequency = this.chosen.motion.frequency_Hz[this.at];
    const amplitude = 1000 * this.chosen.motion.amplitude_m[this.at];
    return `${this.chosen.name}, ${shown(frequency, 3)} Hz, posts \u00b1${shown(amplitude, 2)} mm, motion drawn ${shown(this.factor * this.strength, 2)} times as large${this.#slower(frequency)}${missing}`;
  }

  #slower(frequency) {
    const times = frequency * cycle_s;
    return times > 1.1 ? `, ${shown(times, 2)} times slower than real` : '';
  }

  play(on) {
    if (on === this.playing || !this.chosen) return;
    this.playing = on;
    this.button.textContent = on ? 'pause' : 'play';
    if (!on) return;
    let last = null;
    const step = (now) => {
      if (!this.playing) return;
      if (last != null && this.visible !== false) {
        this.phase = (this.phase + ((now - last) / 1000) * ((2 * Math.PI) / cycle_s)) % (2 * Math.PI);
        this.scrub.value = (this.phase * 180) / Math.PI;
        this.draw();
      }
      last = now;
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  draw() {
    if (this.chosen && this.factor) {
      const { coordinates, posts } = phasors(this.scene, this.chosen, this.at);
      const size = this.factor * this.strength;
      const s = coordinatesAt(coordinates, this.phase).map((value) => value * size);
      const heights = posts.map(([re, im]) => size * (re * Math.cos(this.phase) - im * Math.sin(this.phase)));
      this.stage.pose(s, heights);
    }
    if (this.hertz && this.chosen?.kind === 'response') this.hertz.textContent = `${fixed(this.chosen.motion.frequency_Hz[this.at], 2)} Hz`;
    this.caption.textContent = this.#captionText();
    this.stage.render();
  }
}

/** The vehicle, moving. */
export function drawViewer(place, data) {
  new Viewer(place, data.scene);
}
