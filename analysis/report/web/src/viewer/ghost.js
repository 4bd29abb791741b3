import { BufferAttribute, BufferGeometry, EdgesGeometry, Group, LineSegments, Vector3 } from 'three';
import { moveLinks } from './move_links.js';

/** The measured car over the modelled one: the edges of each link once more, and lines where springs and dampers hold. */
export class Ghost {
  constructor(scene, links, material) {
    this.scene = scene;
    this.group = new Group();
    this.group.visible = false;
    this.links = links.map((link) => this.#edgesOf(link, material));
    this.lines = [...scene.springs, ...scene.dampers].map(({ ends }) => {
      const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
      const line = new LineSegments(geometry, material);
      line.frustumCulled = false;
      this.group.add(line);
      return { ends, geometry };
    });
  }

  #edgesOf(link, material) {
    const group = new Group();
    for (const child of link.children) {
      if (!child.isMesh) continue;
      const lines = new LineSegments(new EdgesGeometry(child.geometry, 35), material);
      lines.position.copy(child.position);
      lines.quaternion.copy(child.quaternion);
      lines.scale.copy(child.scale);
      // Over what is solid.
      lines.renderOrder = 2;
      group.add(lines);
    }
    this.group.add(group);
    return group;
  }

  /** Coordinates of the measured motion; null: none is shown. */
  pose(s) {
    this.group.visible = s != null;
    if (!s) return;
    moveLinks(this.scene, this.links, s);
    for (const { ends, geometry } of this.lines) {
      const { position } = geometry.attributes;
      ends.forEach(({ link, xyz }, i) => position.setXYZ(i, ...this.links[link].localToWorld(new Vector3(...xyz)).toArray()));
      position.needsUpdate = true;
    }
  }
}
