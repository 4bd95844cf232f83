// SPDX-License-Identifier: Apache-2.0
// Obstacles: bounded ones as glass or solid, planes as floors that fade with the distance from the domain.
import * as THREE from 'three';
import { toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { fragmentCommon, shared, vertexCommon } from './shading.js';

const CREASE = 0.6; // rad: boxes keep sharp edges, balls look smooth

const bodyVertex = /* glsl */ `
${vertexCommon}
in vec3 position, normal;
out vec3 place, direction;
void main() {
  place = (viewMatrix * modelMatrix * vec4(position, 1.0)).xyz;
  direction = mat3(viewMatrix) * mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * vec4(place, 1.0);
}`;
const glassFragment = /* glsl */ `
${fragmentCommon}
in vec3 place, direction;
out vec4 result;
void main() {
  vec3 n = normalize(direction);
  if (dot(n, place) > 0.0) n = -n;
  float rim = 1.0 - abs(dot(n, normalize(place)));
  result = vec4(shaded(plain, n, place), 0.16 + 0.34 * rim * rim);
}`;

const solidFragment = /* glsl */ `
${fragmentCommon}
in vec3 place, direction;
out vec4 result;
void main() {
  vec3 n = normalize(direction);
  if (dot(n, place) > 0.0) n = -n;
  result = vec4(shaded(plain, n, place), 1.0);
}`;

const floorVertex = /* glsl */ `
${vertexCommon}
in vec3 position, normal;
out vec3 place, direction;
out vec2 across;
void main() {
  across = position.xy;
  place = (viewMatrix * modelMatrix * vec4(position, 1.0)).xyz;
  direction = mat3(viewMatrix) * normalize(mat3(modelMatrix) * vec3(0.0, 0.0, 1.0));
  gl_Position = projectionMatrix * vec4(place, 1.0);
}`;
const floorFragment = /* glsl */ `
${fragmentCommon}
in vec3 place, direction;
in vec2 across;
out vec4 result;
void main() {
  vec3 n = normalize(direction);
  if (dot(n, place) > 0.0) discard;
  float fade = 1.0 - smoothstep(0.35, 1.0, length(across));
  result = vec4(shaded(plain, n, place), 0.55 * fade);
}`;

/// colour: red, green and blue, 0 to 255.
function materialOf(vertexShader, fragmentShader, colour, solid = false) {
  return new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader,
    side: THREE.DoubleSide,
    uniforms: { ...shared, plain: { value: new THREE.Color(...colour.map((c) => c / 255)) } },
    transparent: !solid,
    depthWrite: solid,
  });
}

export class Obstacles {
  constructor() {
    this.group = new THREE.Group();
    this.objects = [];
  }

  /// packet: of api/obstacles. box: THREE.Box3 of the domain.
  set(packet, box) {
    this.group.clear();
    this.objects = (packet.header.obstacles ?? []).map((obstacle) => {
      const object = new THREE.Group();
      object.matrixAutoUpdate = false;
      if (obstacle.plane) object.add(this.floorOf(obstacle, box));
      else if (obstacle.triangles > 0) object.add(this.bodyOf(obstacle, packet.arrays));
      this.group.add(object);
      return object;
    });
    return (packet.header.obstacles ?? []).filter((o) => o.problem);
  }

  bodyOf(obstacle, arrays) {
    const whole = new THREE.BufferGeometry();
    whole.setAttribute('position', new THREE.BufferAttribute(arrays.position.data, 3));
    whole.setIndex(
      new THREE.BufferAttribute(
        arrays.triangles.data.slice(3 * obstacle.first, 3 * (obstacle.first + obstacle.triangles)),
        1,
      ),
    );
    const geometry = toCreasedNormals(whole, CREASE);
    const solid = obstacle.look === 'solid';
    const material = materialOf(bodyVertex, solid ? solidFragment : glassFragment, obstacle.colour, solid);
    const mesh = new THREE.Mesh(geometry, material);
    if (solid) return mesh;
    const edges = new THREE.LineSegments(
      new THREE.EdgesGeometry(geometry, 30),
      new THREE.LineBasicMaterial({
        color: 0x8a96a3,
        transparent: true,
        opacity: 0.8,
        depthWrite: false,
      }),
    );
    const both = new THREE.Group();
    both.add(mesh, edges);
    return both;
  }

  floorOf({ plane: { point, normal }, colour }, box) {
    const centre = box.getCenter(new THREE.Vector3()),
      n = new THREE.Vector3(...normal);
    const away = n.dot(centre) - n.dot(new THREE.Vector3(...point));
    const material = materialOf(floorVertex, floorFragment, colour);
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), n);
    mesh.position.copy(centre).addScaledVector(n, -away);
    mesh.scale.setScalar(0.75 * box.getSize(new THREE.Vector3()).length());
    mesh.renderOrder = -1;
    return mesh;
  }

  /// poses: of a frame's header.
  move(poses) {
    this.objects.forEach((object, k) => {
      const pose = poses?.[k];
      object.visible = !pose || pose.present;
      if (!pose) return;
      const [a, b, c, d, e, f, g, h, i] = pose.rotation,
        [x, y, z] = pose.move;
      object.matrix.set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
      object.matrixWorldNeedsUpdate = true;
    });
  }
}
