// SPDX-License-Identifier: Apache-2.0
// Directions of the axes, in a corner.
import * as THREE from 'three';

const SIZE = 72,
  REACH = 24;
const NAMESPACE = 'http://www.w3.org/2000/svg';

function draw(name, attributes) {
  const element = document.createElementNS(NAMESPACE, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

export class Axes {
  constructor(parent) {
    const image = draw('svg', {
      viewBox: `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`,
      width: SIZE,
      height: SIZE,
    });
    this.axes = ['x', 'y', 'z'].map((name) => {
      const line = draw('line', { class: `axis ${name}` }),
        text = draw('text', { class: `axis ${name}` });
      text.textContent = name;
      image.append(line, text);
      return { line, text };
    });
    parent.replaceChildren(image);
  }

  update(camera) {
    this.axes.forEach(({ line, text }, k) => {
      const v = new THREE.Vector3().setComponent(k, 1).applyQuaternion(camera.quaternion.clone().invert());
      line.setAttribute('x2', REACH * v.x);
      line.setAttribute('y2', -REACH * v.y);
      text.setAttribute('x', (REACH + 8) * v.x);
      text.setAttribute('y', -(REACH + 8) * v.y);
    });
  }
}
