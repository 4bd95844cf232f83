// SPDX-License-Identifier: Apache-2.0
// The picture: camera, layers of points, obstacles. It is drawn only when something has changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { DepthShade } from './depth_shade.js';
import { DomainBox } from './domain.js';
import { Layer } from './layers.js';
import { Lighting } from './lighting.js';
import { Marks } from './marks.js';
import { Obstacles } from './obstacles.js';
import { FULL, Pace } from './pace.js';
import { Picking } from './picking.js';
import { PictureClock } from './picture_clock.js';
import { setPalette, shared } from './shading.js';
import { Splats } from './splats.js';

const REST = 250; // ms without a change: the view is at rest
const SPARE = 25; // ms for a picture at rest: below it, one with twice as many pixels a side follows

const ownScale = () => Math.min(2, window.devicePixelRatio || 1);

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    THREE.ColorManagement.enabled = false; // shaders return sRGB
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: false,
      powerPreference: 'high-performance',
    });
    this.renderer.autoClear = false;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // nor does the renderer convert
    this.camera = new THREE.PerspectiveCamera(34, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.touch());
    this.scene = new THREE.Scene();
    this.scene.matrixWorldAutoUpdate = true;
    this.layers = new Map(
      ['particles', 'surface', 'sheet', 'oriented'].map((type) => [type, new Layer(type)]),
    );
    this.splats = new Splats();
    for (const { discs } of this.layers.values()) if (discs) this.splats.add(discs);
    this.obstacles = new Obstacles();
    this.domain = new DomainBox();
    this.marks = new Marks();
    this.lighting = new Lighting();
    this.scene.add(
      ...[...this.layers.values()].map((layer) => layer.group),
      this.obstacles.group,
      this.domain.object,
      this.domain.cut,
      this.marks.group,
      this.splats.mesh,
      this.lighting.object,
    );
    this.box = new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
    this.background = new THREE.Color(0xffffff);
    this.shade = new DepthShade();
    this.picking = new Picking(this.renderer);
    this.onDrawn = () => {};
    this.pace = new Pace();
    this.clock = new PictureClock(this.renderer.getContext());
    this.quality = FULL;
    this.scale = 1; // pixels of the picture per pixel of the page
    this.due = false;
    this.drawn = 0; // pictures
    this.pixels = new THREE.Vector2(); // of the picture
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.size = { width, height };
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.setQuality(this.quality, this.scale, true);
    this.draw(); // at once: the canvas is empty after a change of its size
    this.touch();
  }

  /// quality: of pace.js. scale: pixels of the picture per pixel of the page.
  setQuality(quality, scale, resized = false) {
    this.quality = quality;
    if (scale === this.scale && !resized) return;
    this.scale = scale;
    this.renderer.setPixelRatio(scale);
    this.renderer.setSize(this.size.width, this.size.height, false);
  }

  /// Requests a new picture.
  touch() {
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.rest(), REST);
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => this.move());
  }

  /// Draws a picture in motion with a quality that keeps it fluid.
  move() {
    if (this.clock.full) {
      requestAnimationFrame(() => this.move());
      return;
    }
    this.due = false;
    const { quality } = this.pace;
    this.drawTimed(quality, ownScale() * quality.share, (cost) => {
      if (quality === this.pace.quality) this.pace.add(cost, performance.now());
    });
  }

  /// Draws the last picture of a motion with all pixels of the page, and with more if that is cheap.
  rest() {
    if (this.due) {
      this.resting = setTimeout(() => this.rest(), REST); // a picture in motion is still to come
      return;
    }
    const own = ownScale(),
      { drawn } = this;
    this.drawTimed(FULL, own, (cost) => {
      if (cost > SPARE || own === 2 || this.drawn !== drawn + 1) return;
      this.setQuality(FULL, 2);
      this.draw();
    });
  }

  /// Calls done with the cost of the picture (ms) once it is finished.
  drawTimed(quality, scale, done) {
    const begin = performance.now();
    this.setQuality(quality, scale);
    this.draw();
    this.clock.add(begin, done);
  }

  /// Passes the quality to all that is drawn.
  prepare() {
    const { renderer, quality } = this,
      { quick } = quality;
    const { x: width, y: height } = renderer.getDrawingBufferSize(this.pixels);
    for (const layer of this.layers.values()) layer.prepare(quality, height);
    this.splats.prepare(quick, this.scene);
    if (!quick) this.splats.resize(width, height);
    this.shade.prepare(quick, width, height);
  }

  draw() {
    const { renderer, camera, shade } = this;
    this.prepare();
    this.setPlanes();
    camera.updateMatrixWorld();
    shared.up.value.set(0, 0, 1).transformDirection(camera.matrixWorldInverse);
    this.lighting.follow(camera);
    this.splats.draw(renderer, camera);
    renderer.setRenderTarget(shade.target);
    renderer.setClearColor(this.background, 1);
    renderer.clear();
    renderer.render(this.scene, camera);
    shade.draw(renderer, camera, this.scale);
    this.onDrawn();
    this.drawn++;
  }

  /// Sets near and far plane around all that may be seen.
  setPlanes() {
    const centre = this.box.getCenter(new THREE.Vector3());
    const radius = 2 * this.box.getSize(new THREE.Vector3()).length();
    const distance = this.camera.position.distanceTo(centre);
    this.camera.far = distance + radius;
    this.camera.near = Math.max(distance - radius, 2e-4 * this.camera.far);
    this.camera.updateProjectionMatrix();
  }

  setLighting(lighting) {
    this.lighting.set(lighting);
    this.setTheme(this.dark);
  }

  setTheme(dark) {
    this.dark = dark;
    this.background.set(dark ? 0x14171b : 0xf4f6f8);
    shared.bright.value = (dark ? 0.8 : 1) * this.lighting.ambient;
    const line = dark ? 0x5d6975 : 0x8a96a3;
    this.domain.material.color.set(line);
    this.touch();
  }

  /// box: THREE.Box3 of the domain, finite.
  setDomain(box) {
    this.box = box;
    this.domain.set(box);
    this.touch();
  }

  setColours(map, range) {
    setPalette(map);
    shared.range.value.set(range.min ?? 0, range.max ?? 1);
    this.touch();
  }

  setCut(cut) {
    shared.cut.value.copy(this.domain.showCut(cut, this.box));
    this.touch();
  }

  /// from, at: three numbers, m; angle: vertical, in degrees.
  setCamera(from, at, angle) {
    this.camera.fov = angle;
    this.camera.position.set(...from);
    this.controls.target.set(...at);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.touch();
  }

  /// Shows a box (THREE.Box3) from the front (against y), the right and above, as thaw render does.
  fit(box) {
    const centre = box.getCenter(new THREE.Vector3()),
      radius = 0.5 * box.getSize(new THREE.Vector3()).length();
    const angle = 34,
      half = (angle * Math.PI) / 360;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.camera.aspect));
    const from = new THREE.Vector3(0.55, -1, 0.5)
      .normalize()
      .multiplyScalar((1.02 * radius) / Math.sin(narrow));
    this.setCamera(from.add(centre).toArray(), centre.toArray(), angle);
  }

  pick(x, y) {
    for (const layer of this.layers.values()) layer.prepare(FULL, 1); // quick shaders write no indices
    const layers = [...this.layers.values()].map((layer) => layer.pickable()).filter(Boolean);
    const found = this.picking.pick(this.camera, { x, y, ...this.size }, layers);
    this.touch();
    if (found) found.index = this.layers.get(found.type).pointOf(found.index);
    return found;
  }

  /// Place of a point (THREE.Vector3) on the page, or null behind the camera.
  onPage(point) {
    const p = point.clone().project(this.camera);
    if (p.z < -1 || p.z > 1) return null;
    return { x: 0.5 * (p.x + 1) * this.size.width, y: 0.5 * (1 - p.y) * this.size.height };
  }
}
