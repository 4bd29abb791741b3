import { Quaternion, Vector3 } from 'three';
import { linkMotion } from './motion.js';

/** Moves the groups of a scene's links by coordinates s. */
export function moveLinks(scene, groups, s) {
  const turn = new Quaternion();
  const axis = new Vector3();
  scene.links.forEach((link, k) => {
    const m = linkMotion(link, s);
    const group = groups[k];
    group.position.set(link.place[0] + m[0], link.place[1] + m[1], link.place[2] + m[2]);
    axis.set(m[3], m[4], m[5]);
    const angle = axis.length();
    group.quaternion.fromArray(link.turn);
    if (angle > 0) group.quaternion.premultiply(turn.setFromAxisAngle(axis.divideScalar(angle), angle));
    group.updateMatrixWorld(true);
  });
}
