import { EdgesGeometry, Vector3 } from 'three';

/** Draws a scene's edges on a plain canvas, in the place of three.js's renderer where there is no WebGL. */
export class WireRenderer {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.edges = new Map();
  }

  setPixelRatio(ratio) {
    this.ratio = ratio;
  }

  setSize(width, height) {
    this.canvas.width = width * this.ratio;
    this.canvas.height = height * this.ratio;
  }

  /** Ends of lines, three numbers each, in the object's own axes. */
  #linesOf(object) {
    const { geometry } = object;
    if (object.isLineSegments) return geometry.attributes.position;
    if (!this.edges.has(geometry)) this.edges.set(geometry, new EdgesGeometry(geometry, 20).attributes.position);
    return this.edges.get(geometry);
  }

  render(world, camera) {
    const { context, canvas } = this;
    world.updateMatrixWorld();
    camera.updateMatrixWorld();
    context.fillStyle = world.background.getStyle();
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.lineWidth = this.ratio;
    const point = new Vector3();
    world.traverseVisible((object) => {
      if (!object.isMesh && !object.isLineSegments) return;
      // Of what has edges drawn apart, those are enough.
      if (object.isMesh && object.userData.hasEdges) return;
      const lines = this.#linesOf(object);
      context.strokeStyle = object.material.vertexColors ? '#8888' : object.material.color.getStyle();
      context.beginPath();
      for (let i = 0; i < lines.count; ++i) {
        point.fromBufferAttribute(lines, i).applyMatrix4(object.matrixWorld).project(camera);
        const x = (0.5 + 0.5 * point.x) * canvas.width;
        const y = (0.5 - 0.5 * point.y) * canvas.height;
        if (i % 2) context.lineTo(x, y);
        else context.moveTo(x, y);
      }
      context.stroke();
    });
  }
}
