import { choice, el, tick } from '../dom.js';
import { fixed, listOf, shown } from '../number.js';
import { inAddress, putInAddress } from '../address.js';
import { colours, isDark, onPaper, onTheme } from '../theme.js';
import { movePlayhead } from '../playhead.js';
import { onAnswer } from '../live/answers.js';
import { cellsOf, forcesOf } from './forces.js';
import { between, coordinatesAt, followed, framesOf, greatestMotion, greatestOf, motionsOf, phasors, stationAt } from './motion.js';
import { openStage } from './packed.js';

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

const modeWords = ({ name, mode }) => `${name}, ${shown(mode.frequency_Hz, 3)} Hz, damping ratio ${shown(mode.damping_ratio, 2)}`;

function optionsOf(motions) {
  const groups = { travel: el('optgroup', { label: 'Travels of the wheels' }), mode: el('optgroup', { label: 'Modes' }), response: el('optgroup', { label: 'Responses to the posts' }), history: el('optgroup', { label: 'Time histories' }) };
  for (const motion of motions) {
    const words =
      motion.kind === 'mode'
        ? modeWords(motion)
        : motion.kind === 'history'
          ? `${motion.name}, ${shown(lastOf(motion.motion) - motion.motion.start_s, 3)} s`
          : motion.name;
    groups[motion.kind].append(el('option', { value: motion.id }, words));
  }
  return Object.values(groups).filter((group) => group.children.length);
}

/** Time of the last frame [s]. */
const lastOf = ({ start_s, rate_Hz, frames }) => start_s + (frames - 1) / rate_Hz;

class Viewer {
  /** Without a stage, which comes later: it has its size and its controls at once. `recordings`: over time, as packed. */
  constructor(place, scene, recordings) {
    this.scene = scene;
    this.recordings = recordings;
    this.hasForces = true;
    this.shares = null;
    this.motions = motionsOf(scene);
    // What the page is about; of modes not the slowest, which may be fore and aft.
    const wanted = this.motions.find(({ kind }) => kind === scene.first);
    this.first = wanted ?? this.motions.find(({ kind, name }) => kind === 'mode' && name === 'heave') ?? this.motions[0];
    this.chosen = this.first;
    this.at = 0;
    this.phase = 0;
    this.time = 0;
    this.strength = 1;
    this.playing = false;
    this.hasGhost = true;
    this.hasSensors = true;
    this.wantedView = 'corner';
    this.stage = null;
    this.canvas = el('canvas', { tabIndex: 0, role: 'img', 'aria-label': 'the vehicle on its posts; drag or arrow keys turn it, plus and minus come nearer', onkeydown: (event) => this.#turn(event) });
    this.caption = el('div', { class: 'caption' });
    this.frame = el('div', { class: 'viewer' }, this.canvas, this.caption);
    place.append(this.#controls(), this.frame, this.#transport());
    onTheme(() => {
      this.stage?.setPalette(this.#palette());
      this.#fit();
    });
    new ResizeObserver(() => this.#fit()).observe(this.frame);
    new IntersectionObserver(([entry]) => (this.visible = entry.isIntersecting)).observe(this.frame);
    this.#fit();
    this.choose(this.motions.find(({ id }) => id === inAddress('motion')) ?? this.chosen);
    onAnswer((answer) => this.#follow(answer));
  }

  #palette() {
    return { ...colours(), dark: isDark() };
  }

  /** From here on the vehicle is drawn. */
  open(Stage) {
    if (this.stage) return;
    this.stage = new Stage(this.canvas, this.scene, this.#palette());
    this.stage.sensors.visible = this.hasSensors;
    this.stage.view(this.wantedView);
    this.points = pointsOf(this.stage, this.scene);
    this.stage.controls.addEventListener('change', () => this.draw());
    this.#measure();
    this.#fit();
  }

  /** The car of the sliders in place of the fitted one, drawn as much larger as that. */
  #follow(answer) {
    const now = followed(this.chosen, answer);
    this.moved = now === this.chosen ? null : now;
    this.answer = answer;
    // The list has the modes of the car that moves.
    for (const motion of this.motions) {
      const option = motion.kind === 'mode' ? [...this.select.options].find(({ value }) => value === motion.id) : null;
      if (option) option.textContent = modeWords(followed(motion, answer));
    }
    this.draw();
  }

  /** The motion as it is drawn: of the sliders' car where there is one. */
  get drawn() {
    return this.moved ?? this.chosen;
  }

  /** By arrow keys an eighth of a quarter, by plus and minus a tenth. */
  #turn(event) {
    const { key } = event;
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key];
    const nearer = { '+': 0.9, '=': 0.9, '-': 1 / 0.9 }[key];
    if (!turns && !nearer) return;
    event.preventDefault();
    this.stage?.orbit(...(turns ?? [0, 0]).map((steps) => (steps * Math.PI) / 16), nearer ?? 1);
    this.draw();
  }

  #fit() {
    const width = this.frame.clientWidth;
    const height = Math.round(Math.min(460, Math.max(260, 0.52 * width)));
    this.canvas.style.height = `${height}px`;
    this.stage?.resize(width, height);
    this.draw();
  }

  #controls() {
    const select = el('select', { 'aria-label': 'motion', onchange: () => {
      putInAddress('motion', select.value === this.first.id ? null : select.value);
      this.choose(this.motions.find((motion) => motion.id === select.value));
    } }, ...optionsOf(this.motions));
    this.select = select;
    const views = [['corner', 'corner'], ['side', 'side'], ['front', 'front'], ['top', 'top']];
    select.value = inAddress('motion') ?? this.first?.id;
    if (!select.value && this.first) select.value = this.first.id;
    const view = choice('view', views, 'corner', (name) => {
      this.wantedView = name;
      this.stage?.view(name);
      this.draw();
    });
    this.scale = el('input', { type: 'range', min: -1, max: 1, step: 0.01, value: 0, 'aria-label': 'exaggeration', oninput: () => {
      this.strength = 4 ** Number(this.scale.value);
      this.draw();
    } });
    return el(
      'div',
      { class: 'controls' },
      this.motions.length ? el('label', {}, 'motion', select) : null,
      view,
      el('label', {}, 'scale', this.scale),
      this.#ghostTick(),
      this.scene.histories.length && cellsOf(this.scene).length
        ? tick('tyre forces', true, (on) => {
            this.hasForces = on;
            this.draw();
          })
        : null,
      tick('sensors', true, (on) => {
        this.hasSensors = on;
        if (this.stage) this.stage.sensors.visible = on;
        this.draw();
      }),
    );
  }

  /** A box for the measured car, where some motion has one; for the others it is dead, and says why. */
  #ghostTick() {
    if (!this.scene.motions.some(({ measured }) => measured)) return null;
    const label = tick('measured car', true, (on) => {
      this.hasGhost = on;
      this.draw();
    });
    this.ghost = { label, box: label.querySelector('input'), why: el('span', { class: 'why' }) };
    label.append(this.ghost.why);
    return label;
  }

  #setGhost() {
    if (!this.ghost) return;
    const reason = this.#whyNoGhost();
    this.ghost.box.disabled = reason !== '';
    this.ghost.label.classList.toggle('dead', reason !== '');
    this.ghost.why.textContent = reason && `(${reason})`;
  }

  /** Why no measured motion is drawn; empty where it is. */
  #whyNoGhost() {
    if (this.chosen?.kind === 'response' && this.chosen.motion.measured) return '';
    const why = { mode: 'a mode is a shape of the model, not measured', history: 'no measured motion here: only steady responses have one', travel: 'travels are not measured', response: 'no sensor saw this response' };
    return why[this.chosen?.kind] ?? '';
  }

  #transport() {
    this.button = el('button', { type: 'button', class: 'play', onclick: () => this.play(!this.playing) }, 'play');
    this.scrub = el('input', { type: 'range', class: 'scrub', oninput: () => {
      this.play(false);
      if (this.overTime) this.time = Number(this.scrub.value);
      else if (this.isTravel) this.station = Number(this.scrub.value);
      else this.phase = (Number(this.scrub.value) * Math.PI) / 180;
      this.draw();
    } });
    this.frequency = el('input', { type: 'range', min: 0, step: 1, value: 0, 'aria-label': 'frequency', oninput: () => {
      this.at = Number(this.frequency.value);
      this.#measure();
      this.draw();
    } });
    this.hertz = el('output');
    this.frequencies = el('label', {}, 'frequency', this.frequency, this.hertz);
    this.scrubName = el('span');
    return el('div', { class: 'controls' }, this.button, el('label', { class: 'scrub' }, this.scrubName, this.scrub), this.frequencies);
  }

  get overTime() {
    return this.chosen?.kind === 'history';
  }

  get isTravel() {
    return this.chosen?.kind === 'travel';
  }

  /** The slider goes over a cycle, over a recording, or over the stations of a travel. */
  #setScrub() {
    const { motion } = this.chosen ?? {};
    const [name, label, min, max, step] = this.overTime
      ? ['time', 'time of the recording', motion.start_s, lastOf(motion), 1 / motion.rate_Hz]
      : this.isTravel
        ? ['travel', 'travel of the wheels', 0, motion.stations.length - 1, 0.02]
        : ['phase', 'phase of the cycle', 0, 360, 1];
    this.scrubName.textContent = name;
    this.scrub.setAttribute('aria-label', label);
    Object.assign(this.scrub, { min, max, step });
    this.#moveScrub();
  }

  #moveScrub() {
    this.scrub.value = this.overTime ? this.time : this.isTravel ? this.station : (this.phase * 180) / Math.PI;
    const { motion } = this.chosen ?? {};
    this.scrub.setAttribute('aria-valuetext', this.overTime ? `${fixed(this.time, 2)} s` : this.isTravel ? `station ${fixed(this.station + 1, 1)} of ${motion.stations.length}` : `${fixed(Number(this.scrub.value), 0)} degrees`);
    this.scale.setAttribute('aria-valuetext', `${fixed(this.strength, 2)} times the usual size`);
    if (this.chosen?.kind === 'response') this.frequency.setAttribute('aria-valuetext', `${shown(motion.frequency_Hz[this.at], 3)} Hz`);
  }

  choose(motion) {
    this.chosen = motion;
    this.moved = null;
    if (this.overTime) {
      this.frames = framesOf(motion.motion);
      this.time = motion.motion.start_s;
      this.#fetchForces(motion);
    } else movePlayhead(null, 0);
    if (this.isTravel) {
      // From the design pose to bump.
      this.phase = 0;
      this.station = Math.max(0, motion.motion.stations.findIndex(({ travel }) => travel === 0));
    }
    this.#setGhost();
    // A travel is as large as it is.
    this.scale.disabled = this.isTravel;
    this.#setScrub();
    this.frequencies.hidden = motion?.kind !== 'response';
    this.frequencies.style.display = this.frequencies.hidden ? 'none' : '';
    if (motion?.kind === 'response') {
      const last = motion.motion.frequency_Hz.length - 1;
      this.at = Math.min(this.at || Math.floor(last / 3), last);
      this.frequency.max = last;
      this.frequency.value = this.at;
    }
    this.#measure();
    this.#follow(this.answer);
  }

  /** Forces of the tyres in a recording, which are unpacked when it is chosen. */
  async #fetchForces(motion) {
    this.shares = null;
    const shares = await forcesOf(this.scene, this.recordings.find(({ recording }) => recording === motion.name));
    if (this.chosen !== motion) return;
    this.shares = shares;
    this.draw();
  }

  /** Of each tyre its force over that at rest, now; null where they are not known or not wanted. */
  #sharesNow() {
    return this.overTime && this.hasForces && this.shares ? this.shares(this.time) : null;
  }

  #forcesText() {
    const shares = this.#sharesNow();
    if (!shares) return '';
    const known = shares.filter((share) => share != null);
    const lifted = this.scene.tyres.filter((_, t) => shares[t] != null && shares[t] <= 0.02).map(({ name }) => name);
    const range = known.length > 1 ? `forces ${fixed(Math.min(...known), 2)} to ${fixed(Math.max(...known), 2)} of those` : `force ${fixed(known[0], 2)} of that`;
    return `, tyre ${range} at rest${lifted.length ? `, ${lifted.join(' and ')} off the ground` : ''}`;
  }

  /** By how much the motion is drawn larger than it is, at a strength of 1. */
  #measure() {
    if (!this.chosen || !this.stage) return;
    if (this.isTravel) {
      this.factor = 1;
      return;
    }
    const greatest = this.overTime ? this.#greatestOverTime() : this.#greatestOfCycle();
    this.factor = greatest > 0 ? (share * this.stage.size) / greatest : 1;
  }

  #greatestOfCycle() {
    const { coordinates, posts } = phasors(this.scene, this.chosen, this.at);
    return Math.max(greatestMotion(this.scene, coordinates, this.points), ...posts.map(([re, im]) => Math.hypot(re, im)));
  }

  #greatestOverTime() {
    const { coordinates, posts } = this.frames;
    return posts.reduce((most, row) => Math.max(most, ...row.map(Math.abs)), greatestOf(this.scene, coordinates, this.points));
  }

  #captionText() {
    if (!this.chosen) return 'Design pose.';
    const missing = this.scene.missing.length ? ' Some meshes could not be read.' : '';
    if (this.chosen.kind === 'mode') {
      // A mode has a shape and no size.
      const size = `scaled to ${shown(1000 * share * this.stage.size * this.strength, 2)} mm`;
      const { name, frequency_Hz, kind } = this.drawn.mode;
      const words = kind === 'oscillating' ? '' : `, ${kind}`;
      return `${name}, ${shown(frequency_Hz, 3)} Hz${words}, ${size}${this.#slower(frequency_Hz)}${missing}`;
    }
    if (this.isTravel) return `${this.chosen.name} ${fixed(1000 * stationAt(this.chosen.motion, this.station).travel, 1)} mm, full geometry, as large as it is${missing}`;
    const larger = `motion scaled by ${shown(this.factor * this.strength, 2)}`;
    if (this.overTime) return `${this.chosen.name} at ${fixed(this.time, 2)} s, ${this.playing ? 'in real time, ' : ''}${larger}${this.#forcesText()}${missing}`;
    const frequency = this.chosen.motion.frequency_Hz[this.at];
    const amplitude = 1000 * this.chosen.motion.amplitude_m[this.at];
    return `${this.chosen.name}, ${shown(frequency, 3)} Hz, posts \u00b1${shown(amplitude, 2)} mm, ${larger}${this.hasGhost && this.chosen.motion.measured ? ', blue lines the measured car' : ''}${this.#slower(frequency)}${missing}`;
  }

  #slower(frequency) {
    const times = frequency * cycle_s;
    return times > 1.1 ? `, ${shown(times, 2)} times slower than real time` : '';
  }

  play(on) {
    if (on === this.playing || !this.chosen) return;
    this.playing = on;
    this.button.textContent = on ? 'pause' : 'play';
    if (!on) {
      // The caption says what moves.
      this.draw();
      return;
    }
    let last = null;
    const step = (now) => {
      if (!this.playing) return;
      if (last != null && this.visible !== false) {
        this.#advance((now - last) / 1000);
        this.draw();
      }
      last = now;
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** By seconds on the screen; at its end a recording begins anew. */
  #advance(seconds) {
    const { motion } = this.chosen;
    if (this.isTravel) {
      // To and fro.
      const last = motion.stations.length - 1;
      this.phase = (this.phase + seconds * (Math.PI / 2)) % (2 * Math.PI);
      this.station = (last * (1 - Math.cos(this.phase))) / 2;
    } else if (!this.overTime) this.phase = (this.phase + seconds * ((2 * Math.PI) / cycle_s)) % (2 * Math.PI);
    else this.time = this.time + seconds > lastOf(motion) ? motion.start_s : this.time + seconds;
    this.#moveScrub();
  }

  /** s and heights of the posts now, as large as they are. */
  #now() {
    if (this.overTime) {
      const { start_s, rate_Hz } = this.chosen.motion;
      return Object.values(this.frames).map((rows) => between(rows, this.time - start_s, rate_Hz));
    }
    const { coordinates, posts, measured } = phasors(this.scene, this.drawn, this.at);
    const heights = posts.map(([re, im]) => re * Math.cos(this.phase) - im * Math.sin(this.phase));
    return [coordinatesAt(coordinates, this.phase), heights, ...(measured && this.hasGhost ? [coordinatesAt(measured, this.phase)] : [])];
  }

  draw() {
    if (!this.stage) return;
    if (this.isTravel) {
      const { links, posts } = stationAt(this.chosen.motion, this.station);
      this.stage.place(links, posts);
      this.stage.forces(null, posts);
    } else if (this.chosen && this.factor) {
      const size = this.factor * this.strength;
      const [s, heights, measured] = this.#now().map((values) => values.map((value) => value * size));
      this.stage.pose(s, heights, measured);
      this.stage.forces(this.#sharesNow(), heights);
      if (this.overTime) movePlayhead(this.chosen.name, this.time);
    }
    if (this.hertz && this.chosen?.kind === 'response') this.hertz.textContent = `${fixed(this.chosen.motion.frequency_Hz[this.at], 2)} Hz`;
    this.caption.textContent = `${this.moved ? 'what if: ' : ''}${this.#captionText()}`;
    this.stage.render();
  }
}

/** The vehicle, moving; drawn from when it comes into view or is printed, for what draws it takes a second to begin. */
export function drawViewer(place, data) {
  const viewer = new Viewer(place, data.scene, [...listOf(data.histories), ...listOf(data.validation)]);
  let stage = null;
  const fetched = async () => {
    try {
      stage ??= await openStage();
    } catch (error) {
      viewer.caption.textContent = `The vehicle could not be drawn: ${error.message}`;
    }
  };
  const open = () => stage && viewer.open(stage);
  const watch = new IntersectionObserver(
    ([entry]) => {
      if (!entry.isIntersecting) return;
      watch.disconnect();
      fetched().then(open);
    },
    { rootMargin: '300px' },
  );
  watch.observe(viewer.frame);
  (window.requestIdleCallback ?? setTimeout)(fetched);
  onPaper((isOn) => isOn && open());
}
