import {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight,
  DoubleSide, EdgesGeometry, GridHelper, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial,
  PerspectiveCamera, Quaternion, Scene, SphereGeometry, TorusGeometry, Vector3, WebGLRenderer, CatmullRomCurve3,
  TubeGeometry, Box3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Ghost } from './ghost.js';
import { moveLinks } from './move_links.js';
import { WireRenderer } from './wire.js';

const up = new Vector3(0, 0, 1);
const vector = ([x, y, z]) => new Vector3(x, y, z);

/** A shape of a link as a geometry in link axes. */
function geometryOf(shape, meshes) {
  const [x, y, z] = shape.size;
  if (shape.kind === 'box') return new BoxGeometry(x, y, z);
  if (shape.kind === 'sphere') return new SphereGeometry(x, 24, 16);
  // Along z, as URDF has it.
  if (shape.kind === 'cylinder') return new CylinderGeometry(x, x, z, 32).rotateX(Math.PI / 2);
  const { vertices, triangles } = meshes[shape.mesh];
  const indexed = new BufferGeometry();
  indexed.setAttribute('position', new BufferAttribute(new Float32Array(vertices), 3));
  indexed.setIndex(triangles);
  indexed.scale(x, y, z);
  // Flat faces.
  const flat = indexed.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

function place(object, pose) {
  object.position.fromArray(pose.place);
  object.quaternion.fromArray(pose.turn);
  return object;
}

/** A coil of unit length along z. */
function coilGeometry(radius, wire) {
  const turns = 7;
  const points = [];
  for (let i = 0; i <= 24 * turns; ++i) {
    const t = i / (24 * turns);
    const angle = 2 * Math.PI * turns * t;
    points.push(new Vector3(radius * Math.cos(angle), radius * Math.sin(angle), t));
  }
  return new TubeGeometry(new CatmullRomCurve3(points), 24 * turns, wire, 6);
}

/** A cylinder of unit length from 0 along z. */
const bar = (radius) => new CylinderGeometry(radius, radius, 1, 16).rotateX(Math.PI / 2).translate(0, 0, 0.5);

/** Solid by WebGL; its edges on a plain canvas where there is none. */
function rendererFor(canvas) {
  const probe = document.createElement('canvas');
  if (!probe.getContext('webgl2')) return new WireRenderer(canvas);
  return new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
}

/** The vehicle in three dimensions. */
export class Stage {
  constructor(canvas, scene, palette) {
    this.scene = scene;
    this.renderer = rendererFor(canvas);
    this.world = new Scene();
    this.camera = new PerspectiveCamera(28, 2, 0.05, 200);
    this.camera.up.copy(up);
    this.materials = {
      body: new MeshLambertMaterial({ transparent: true, opacity: 0.3, side: DoubleSide, depthWrite: false }),
      part: new MeshLambertMaterial({ side: DoubleSide }),
      spring: new MeshLambertMaterial(),
      damper: new MeshLambertMaterial(),
      rod: new MeshLambertMaterial(),
      post: new MeshLambertMaterial(),
      sensor: new MeshLambertMaterial(),
      force: new MeshLambertMaterial(),
      edges: new LineBasicMaterial({ transparent: true, opacity: 0.75 }),
      ghost: new LineBasicMaterial({ transparent: true, opacity: 0.95, depthTest: false }),
    };
    this.lights = [new AmbientLight(0xffffff, 1.5), new DirectionalLight(0xffffff, 1.9), new DirectionalLight(0xffffff, 0.7)];
    this.lights[1].position.set(3, 4, 8);
    this.lights[2].position.set(-4, -6, 2);
    this.world.add(...this.lights);
    this.links = [];
    this.moved = [];
    this.sensors = new Group();
    this.world.add(this.sensors);
    this.size = this.#extent();
    this.#addLinks();
    this.#addElements();
    this.#addPosts();
    this.#addForces();
    this.#addSensors();
    this.ghost = new Ghost(scene, this.links, this.materials.ghost);
    this.world.add(this.ghost.group);
    this.setPalette(palette);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = true;
    // The page scrolls by the wheel until the viewer is meant.
    this.controls.enableZoom = false;
    canvas.addEventListener('pointerdown', () => (this.controls.enableZoom = true));
    canvas.addEventListener('pointerleave', () => (this.controls.enableZoom = false));
    this.view('corner');
  }

  /** In ground axes, in the design pose. */
  at({ link, xyz }) {
    const { place: origin, turn } = this.scene.links[link];
    return vector(xyz).applyQuaternion(new Quaternion().fromArray(turn)).add(vector(origin));
  }

  #points() {
    const { springs, dampers, rods, bushings, bars, tyres } = this.scene;
    const lines = [...springs, ...dampers, ...rods, ...bushings, ...bars, ...bars.flatMap((one) => one.drops)];
    return [...lines.flatMap((line) => line.ends), ...tyres.map((tyre) => tyre.point)];
  }

  /** A length that stands for the vehicle. */
  #extent() {
    const box = new Box3();
    for (const point of this.#points()) box.expandByPoint(this.at(point));
    for (const link of this.scene.links) if (link.mass > 0) box.expandByPoint(vector(link.place));
    const size = box.isEmpty() ? 1 : box.getSize(new Vector3()).length();
    return Math.max(size, 0.3);
  }

  #addLinks() {
    const { links, meshes } = this.scene;
    const heaviest = links.reduce((best, link, k) => (link.mass > links[best].mass ? k : best), 0);
    links.forEach((link, k) => {
      const group = place(new Group(), link);
      for (const shape of link.shapes) {
        const geometry = geometryOf(shape, meshes);
        const isBody = k === heaviest;
        const mesh = place(new Mesh(geometry, isBody ? this.materials.body : this.materials.part), shape);
        const edges = place(new LineSegments(new EdgesGeometry(geometry, 25), this.materials.edges), shape);
        mesh.userData.hasEdges = true;
        group.add(edges, mesh);
      }
      if (link.mass > 0 && !(k === heaviest && link.shapes.length)) this.#addSkeleton(k, link, group);
      this.world.add(group);
      this.links.push(group);
    });
    this.world.updateMatrixWorld(true);
  }

  /** From a link's centre of mass to its joint and to what it holds, where no shape hides that. */
  #addSkeleton(k, link, group) {
    const com = vector(link.com);
    const radius = 0.5 * this.#thickness();
    if (!link.shapes.length) {
      const ball = new Mesh(new SphereGeometry(3 * radius, 16, 12), this.materials.part);
      ball.position.copy(com);
      group.add(ball);
    }
    const ends = [new Vector3(), ...this.#points().filter((point) => point.link === k).map((point) => vector(point.xyz))];
    for (const end of ends) {
      const along = end.clone().sub(com);
      const length = along.length();
      if (length < 0.02) continue;
      const arm = new Mesh(bar(radius), this.materials.part);
      arm.position.copy(com);
      arm.quaternion.setFromUnitVectors(up, along.divideScalar(length));
      arm.scale.z = length;
      arm.userData.isArm = true;
      group.add(arm);
    }
  }

  /** Of springs' wire, dampers and rods [m]. */
  #thickness() {
    return Math.min(0.026, 0.014 * this.size);
  }

  #end({ link, xyz }) {
    return this.links[link].localToWorld(vector(xyz));
  }

  /** Something of unit length along z that follows a line between two points. */
  #addStretched(ends, object, from = 0, to = 1) {
    this.world.add(object);
    this.moved.push(() => {
      const a = this.#end(ends[0]);
      const b = this.#end(ends[1]);
      const along = b.clone().sub(a);
      const length = along.length();
      if (length < 1e-9) return;
      along.divideScalar(length);
      object.position.copy(a).addScaledVector(along, from * length);
      object.quaternion.setFromUnitVectors(up, along);
      object.scale.set(1, 1, (to - from) * length);
    });
  }

  #addElements() {
    const { springs, dampers, rods, bushings, bars } = this.scene;
    const thick = this.#thickness();
    for (const spring of springs) {
      const isCoil = spring.kind === 'coil';
      const geometry = isCoil ? coilGeometry(3 * thick, 0.5 * thick) : bar(0.8 * thick);
      this.#addStretched(spring.ends, new Mesh(geometry, this.materials.spring), isCoil ? 0 : 0.3, isCoil ? 1 : 0.7);
    }
    for (const damper of dampers) {
      this.#addStretched(damper.ends, new Mesh(bar(0.55 * thick), this.materials.damper), 0, 0.6);
      this.#addStretched(damper.ends, new Mesh(bar(1.4 * thick), this.materials.damper), 0.45, 1);
    }
    for (const rod of rods) this.#addStretched(rod.ends, new Mesh(bar(0.7 * thick), this.materials.rod));
    for (const one of bars)
      for (const line of [one, ...one.drops]) this.#addStretched(line.ends, new Mesh(bar(0.5 * thick), this.materials.rod));
    for (const bushing of bushings) this.#addBall(bushing.ends[0], 1.3 * thick);
  }

  #addBall(point, radius) {
    const ball = new Mesh(new SphereGeometry(radius, 12, 8), this.materials.rod);
    ball.position.fromArray(point.xyz);
    this.links[point.link].add(ball);
  }

  /** Where the platforms of a tyre stand: under the wheels that its link shows near it, else under its foot. */
  #feet(tyre) {
    const centre = this.at(tyre.point);
    const foot = centre.clone().addScaledVector(up, -tyre.radius);
    const wheels = this.links[tyre.point.link].children
      .filter((child) => child.isMesh && !child.userData.isArm)
      .map((mesh) => new Box3().setFromObject(mesh))
      .filter((box) => box.min.z < centre.z - 0.02 && Math.abs(box.getCenter(new Vector3()).x - centre.x) < 0.3);
    const near = wheels.filter((box) => Math.abs(box.getCenter(new Vector3()).y - centre.y) < 0.3);
    const chosen = near.length ? near : wheels;
    if (!chosen.length) return { feet: [foot], isBare: true, centre };
    return {
      feet: chosen.map((box) => {
        const middle = box.getCenter(new Vector3());
        return new Vector3(centre.x, middle.y, tyre.radius > 0 ? foot.z : Math.min(foot.z, box.min.z));
      }),
      isBare: false,
      centre,
    };
  }

  #addPosts() {
    const { tyres, posts } = this.scene;
    this.platforms = posts.map(() => []);
    this.feet = [];
    let ground = Infinity;
    tyres.forEach((tyre, t) => {
      const { feet, isBare, centre } = this.#feet(tyre);
      this.feet[t] = feet;
      const post = posts.findIndex((one) => one.tyre === t);
      if (isBare && tyre.radius > 0) {
        const ring = new Mesh(new TorusGeometry(tyre.radius * 0.8, tyre.radius * 0.2, 12, 40).rotateX(Math.PI / 2), this.materials.part);
        ring.position.fromArray(tyre.point.xyz);
        this.links[tyre.point.link].add(ring);
      }
      for (const foot of feet) {
        const group = new Group();
        const wide = this.#wide();
        const plate = new Mesh(new BoxGeometry(2.2 * wide, 1.3 * wide, 0.03), this.materials.post);
        plate.position.z = -0.015;
        const piston = new Mesh(new CylinderGeometry(0.22 * wide, 0.22 * wide, 0.5, 24).rotateX(Math.PI / 2).translate(0, 0, -0.28), this.materials.post);
        group.add(plate, piston);
        group.position.copy(foot);
        const sleeve = new Mesh(new CylinderGeometry(0.36 * wide, 0.36 * wide, 0.3, 24).rotateX(Math.PI / 2), this.materials.post);
        sleeve.position.copy(foot).addScaledVector(up, -0.42);
        this.world.add(group, sleeve);
        ground = Math.min(ground, foot.z - 0.57);
        if (post >= 0) this.platforms[post].push({ group, foot });
        if (isBare && !(tyre.radius > 0)) this.#addTyreSpring(tyre, group, foot, centre);
      }
    });
    if (!Number.isFinite(ground)) ground = 0;
    const middle = new Box3().setFromObject(this.world).getCenter(new Vector3());
    const cells = Math.max(4, Math.ceil(1.6 * this.size));
    this.grid = new GridHelper(cells, 2 * cells);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.set(Math.round(middle.x), Math.round(middle.y), ground);
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.7;
    this.box = new Box3().setFromObject(this.world);
    this.world.add(this.grid);
  }

  /** Of a platform. */
  #wide() {
    return Math.min(0.26, 0.16 * this.size);
  }

  /** Arrows beside the feet of each tyre, as long as its force. */
  #addForces() {
    this.arrows = this.scene.tyres.map((_, t) =>
      this.feet[t].map((foot) => {
        const arrow = new Group();
        const thick = 1.6 * this.#thickness();
        // A unit long, drawn as long as the force.
        const shaft = new Mesh(bar(thick), this.materials.force);
        const head = new Mesh(new ConeGeometry(3 * thick, 8 * thick, 16).rotateX(Math.PI / 2), this.materials.force);
        arrow.add(shaft, head);
        arrow.visible = false;
        this.world.add(arrow);
        return { arrow, shaft, head, foot };
      }),
    );
  }

  /** `shares`: of each tyre its force over that at rest, or null; `heights` of the posts. */
  forces(shares, heights) {
    const full = 0.2 * this.size;
    const aside = 0.85 * this.#wide();
    this.arrows.forEach((list, t) => {
      const share = shares?.[t];
      const post = this.scene.posts.findIndex((one) => one.tyre === t);
      for (const { arrow, shaft, head, foot } of list) {
        arrow.visible = share > 0.02;
        if (!arrow.visible) continue;
        // Beside the wheel, away from the car's middle.
        arrow.position.set(foot.x, foot.y + Math.sign(foot.y || 1) * aside, foot.z + (heights[post] ?? 0));
        shaft.scale.set(1, 1, share * full);
        head.position.z = share * full;
      }
    });
  }

  /** A tyre whose wheel nothing shows: a ball where it holds the link. */
  #addTyreSpring(tyre) {
    this.#addBall(tyre.point, 0.02);
  }

  #addSensors() {
    const length = 0.05 * Math.min(3, this.size);
    for (const sensor of this.scene.sensors) {
      if (!sensor.point) continue;
      const cone = new Mesh(new ConeGeometry(0.28 * length, length, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5 * length), this.materials.sensor);
      cone.position.fromArray(sensor.point.xyz);
      cone.quaternion.setFromUnitVectors(up, vector(sensor.axis ?? [0, 0, 1]).normalize());
      const holder = new Group();
      holder.add(cone);
      this.sensors.add(holder);
      const link = this.links[sensor.point.link];
      this.moved.push(() => {
        holder.position.copy(link.position);
        holder.quaternion.copy(link.quaternion);
      });
    }
  }

  setPalette({ raised, text, measured, model, muted, good, whatif, line, dark }) {
    const set = (name, colour) => this.materials[name].color.set(colour);
    this.world.background = new Color(raised);
    set('body', dark ? '#8fa3b3' : '#7d93a6');
    set('part', dark ? '#5d6770' : '#59636c');
    set('spring', model);
    set('damper', measured);
    set('rod', muted);
    set('post', dark ? '#4b555d' : '#b4bdc5');
    set('sensor', good);
    set('force', whatif);
    set('edges', dark ? '#aeb9c2' : text);
    set('ghost', measured);
    const colours = this.grid.geometry.attributes.color;
    const colour = new Color(line);
    for (let i = 0; i < colours.count; ++i) colours.setXYZ(i, colour.r, colour.g, colour.b);
    colours.needsUpdate = true;
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.preset) this.view(this.preset);
  }

  /** corner, side, front or top. */
  view(name) {
    this.preset = name;
    const directions = { corner: [0.75, 1, 0.42], side: [0, 1, 0.0001], front: [1, 0, 0.0001], top: [0, -0.0001, 1] };
    const direction = vector(directions[name]).normalize();
    const centre = this.box.getCenter(new Vector3());
    const span = this.box.getSize(new Vector3());
    const right = new Vector3().crossVectors(name === 'top' ? new Vector3(0, 1, 0) : up, direction).normalize();
    const over = new Vector3().crossVectors(direction, right);
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    const halves = [-0.5, 0.5];
    const corners = halves.flatMap((x) => halves.flatMap((y) => halves.map((z) => new Vector3(x, y, z).multiply(span))));
    // Lower than the middle, for the caption stands above.
    const lift = 0.1 * Math.max(...corners.map((corner) => Math.abs(corner.dot(over))));
    centre.addScaledVector(over, lift);
    // Far enough for every corner of the box.
    let distance = 0;
    for (const corner of corners) {
      const half = Math.max(Math.abs(corner.dot(over)) + lift, Math.abs(corner.dot(right)) / this.camera.aspect);
      distance = Math.max(distance, corner.dot(direction) + (1.08 * half) / tangent);
    }
    this.camera.position.copy(centre).addScaledVector(direction, distance);
    if (this.controls) this.controls.target.copy(centre);
    this.camera.lookAt(centre);
    this.controls?.update();
  }

  /** The camera about what it looks at: around the vertical, over [rad], and so many times as far. */
  orbit(around, over, times) {
    const { target } = this.controls;
    const from = this.camera.position.clone().sub(target);
    const polar = Math.acos(from.z / from.length());
    from.applyAxisAngle(up, around);
    const across = new Vector3().crossVectors(up, from).normalize();
    const to = Math.min(Math.PI - 0.05, Math.max(0.05, polar + over));
    if (across.length()) from.applyAxisAngle(across, to - polar);
    this.camera.position.copy(target).add(from.multiplyScalar(times));
    this.preset = null;
    this.controls.update();
  }

  /** Each link at a place of its own, see stationAt(), and heights of the posts. */
  place(links, heights) {
    links.forEach(({ place, turn }, k) => {
      const group = this.links[k];
      group.position.fromArray(place);
      group.quaternion.fromArray(turn).normalize();
      group.updateMatrixWorld(true);
    });
    this.#follow(heights);
    this.ghost.pose(null);
  }

  /** What stands between links, and the platforms. */
  #follow(heights) {
    for (const move of this.moved) move();
    this.platforms.forEach((list, p) => {
      for (const { group, foot } of list) group.position.z = foot.z + (heights[p] ?? 0);
    });
  }

  /** Coordinates s and heights of the posts, both already exaggerated; `measured`: s of the measured car, or null. */
  pose(s, heights, measured = null) {
    moveLinks(this.scene, this.links, s);
    this.#follow(heights);
    this.ghost.pose(measured);
  }

  render() {
    this.renderer.render(this.world, this.camera);
  }
}
