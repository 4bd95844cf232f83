// SPDX-License-Identifier: Apache-2.0
// Joins the parts of the page: a change of the settings loads frames and draws them.
import * as THREE from 'three';
import { getJson, getPacket, pageData } from './data/api.js';
import { FrameStore } from './data/frame_store.js';
import { MeshStore } from './data/mesh_store.js';
import { Settings } from './data/settings.js';
import { Colouring, fieldsOf, titleOf } from './colouring.js';
import { byId } from './dom.js';
import { ColourBar } from './panels/colour_bar.js';
import { Charts } from './panels/charts.js';
import { Notices } from './panels/notices.js';
import { StatusPanel } from './panels/status_panel.js';
import { TimeBar } from './panels/time_bar.js';
import { ViewPanel } from './panels/view_panel.js';
import { RunWatch } from './run_watch.js';
import { Axes } from './scene/axes.js';
import { cameraLine } from './scene/camera_text.js';
import { Stage } from './scene/stage.js';
import { Selection } from './selection.js';
import { countText } from './text.js';

const AHEAD = 3; // frames that are loaded ahead while playing
const MESH_WAIT = 300; // ms before a surface without its mesh is drawn as discs
const MESH_WAIT_PLAYING = 2000; // the same while playing, where a change of the look flickers

const delay = (time) => new Promise((done) => setTimeout(done, time));

export class App {
  constructor() {
    this.settings = new Settings();
    this.store = new FrameStore();
    this.meshes = new MeshStore();
    this.colouring = new Colouring();
    this.frames = null; // the frames of api/run
    this.scene = null; // the answer of api/scene
    this.notices = new Notices(byId('notices'));
    this.stage = new Stage(byId('canvas'));
    this.axes = new Axes(byId('axes'));
    this.bar = new ColourBar(byId('colour-bar'));
    this.time = new TimeBar(byId('time-bar'), this.settings);
    this.status = new StatusPanel(byId('status'));
    this.charts = new Charts(byId('charts'), (time) => this.goToTime(time));
    this.view = new ViewPanel(byId('view-panel'), this.settings, {
      sceneCamera: () => this.sceneCamera(),
      fit: () => this.fit(),
      copyCamera: () => this.copyCamera(),
      theme: () => this.turnTheme(),
    });
    this.selection = new Selection(this);
    this.stage.onDrawn = () => {
      this.axes.update(this.stage.camera);
      this.selection.place();
    };
    this.settings.listen((changed) => this.settingsChanged(changed));
    this.dark = window.matchMedia('(prefers-color-scheme: dark)');
    this.dark.addEventListener('change', () => this.applyTheme());
    this.applyTheme();
    this.watch = new RunWatch(
      (run, frames) => this.runChanged(run, frames),
      (text) => this.notices.set('server', text, true),
    );
  }

  async start() {
    if (pageData) this.settings.change((await pageData.about()).settings);
    return this.watch.look();
  }

  // ---- state of the run ----

  async runChanged(run, frames) {
    if (!pageData) document.title = `${run.folder} – thaw view`;
    document.body.dataset.preview = String(run.preview ?? false);
    this.notices.set('left-out', run.note ?? '');
    this.view.title.textContent = run.summary.title || this.scene?.title || run.folder;
    this.status.update(run, this.scene?.end ?? null);
    this.live = run.live;
    this.preview = run.preview ?? false;
    if (frames) await this.framesChanged(frames);
    await this.charts.read();
  }

  async framesChanged(frames) {
    const before = this.frames;
    this.frames = frames;
    const repeated = before && before.times.some((time, k) => frames.times[k] !== time);
    // A run that was restarted from an earlier time repeats frames.
    if (repeated) for (const store of [this.store, this.meshes]) store.clear();
    this.time.setTimes(frames.times);
    if (frames.numbers.length === 0) return;
    if (!this.scene || repeated) await this.loadScene();
    const newest = frames.numbers.length - 1,
      { frame, follow } = this.settings;
    if (frame < 0) this.settings.change({ frame: newest, follow: this.settings.follow && this.live });
    else if (follow || frame > newest) this.settings.change({ frame: newest });
    else this.show();
  }

  async loadScene() {
    try {
      this.scene = await getJson('scene');
    } catch (problem) {
      this.notices.set('scene', `the scene cannot be shown: ${problem.message}`, true);
    }
    const { domain } = this.scene ?? {};
    if (!domain) return;
    const box = new THREE.Box3(new THREE.Vector3(...domain.min), new THREE.Vector3(...domain.max));
    this.stage.setDomain(box);
    this.stage.setLighting(this.scene.lighting);
    const problems = this.stage.obstacles.set(await getPacket('obstacles'), box);
    this.stage.marks.set(await getPacket('marks'));
    this.notices.set('obstacles', problems.map((o) => `obstacle ${o.name}: ${o.problem}`).join('; '), true);
    const name = { speed: 'velocity', surface: '', glow: '' }[this.scene.colour] ?? this.scene.colour;
    const all = this.frames.has.reduce((mask, has) => mask | has, 0);
    this.settings.change({
      field: { name, part: -1 },
      range: { min: this.scene.colour_min, max: this.scene.colour_max },
      // A surface hides the particles within.
      layers: { ...this.settings.layers, particles: (all & 2) === 0, camera: this.preview },
    });
    this.showMarks();
    if (this.preview) this.stage.fit(box);
    else if (this.scene.camera) this.sceneCamera();
    else this.fitting = true;
  }

  // ---- the frame that is shown ----

  /// Returns the types of the points of a frame that are switched on.
  typesOf(index) {
    const mask = this.frames.has[index];
    return this.frames.types.filter((type, k) => (mask >> k) & 1 && this.settings.layers[type]);
  }

  queryOf(index, type) {
    const { field, most } = this.settings;
    return {
      number: this.frames.numbers[index],
      type,
      field: field.name || undefined,
      part: field.part,
      most,
    };
  }

  async show() {
    const { frame } = this.settings;
    if (!this.frames || frame < 0 || frame >= this.frames.numbers.length) return;
    const wanted = (this.wanted = {});
    const types = this.typesOf(frame);
    const meshed = types.includes('surface') ? this.loadMesh(frame) : null;
    const loads = await Promise.allSettled(types.map((type) => this.store.load(this.queryOf(frame, type))));
    if (this.wanted !== wanted) return; // a later choice
    const bad = loads.filter((load) => load.status === 'rejected').map((load) => load.reason.message);
    this.notices.set('frame', bad.join('; '), true);
    const packets = new Map(types.map((type, k) => [type, loads[k].value]).filter(([, packet]) => packet));
    const mesh = await this.meshInTime(meshed);
    if (this.wanted !== wanted) return;
    this.draw(packets, mesh, bad.length > 0);
    if (meshed && !mesh)
      meshed.then((late) => late && this.wanted === wanted && this.draw(packets, late, bad.length > 0));
    await this.selection.update(frame);
    document.body.dataset.frame = String(this.frames.numbers[frame]);
    if (this.settings.playing) this.playOn(frame);
  }

  /// Returns a promise of the mesh of a frame's surface: null without one.
  async loadMesh(index) {
    const { look, most } = this.settings;
    if (look !== 'mesh') return null;
    try {
      return await this.meshes.load({ number: this.frames.numbers[index], type: 'surface', most });
    } catch {
      return null; // discs show the surface
    }
  }

  /// Returns null if the mesh takes too long.
  meshInTime(meshed) {
    if (!meshed) return null;
    const wait = this.settings.playing ? MESH_WAIT_PLAYING : MESH_WAIT;
    return Promise.race([meshed, delay(wait).then(() => null)]);
  }

  /// mesh: of the surface, or null. keep: layers without a packet stay as they are, since their frame cannot
  /// be read.
  draw(packets, mesh, keep) {
    const { settings, stage, scene } = this;
    const key = `${settings.field.name} ${settings.field.part}`;
    if (this.colouring.key !== key) this.colouring.reset(key);
    for (const [type, layer] of stage.layers) {
      const packet = packets.get(type);
      if (!packet && keep && settings.layers[type]) continue;
      const own = type === 'surface' ? mesh : null;
      const same = packet === layer.packet && layer.look === settings.look && layer.mesh === own;
      if (packet && same) layer.setVisible(true);
      else layer.show(packet ?? null, scene?.spacing ?? this.guessSpacing(packet), settings.look, own);
    }
    for (const { header } of packets.values()) this.colouring.add(header);
    const first = packets.values().next().value;
    if (first) stage.obstacles.move(first.header.obstacles);
    this.describe(packets);
    this.applyColours(packets);
    if (this.fitting && packets.size > 0) this.fit();
    stage.touch();
    this.charts.setTime(this.frames.times[settings.frame]);
  }

  describe(packets) {
    const { stage } = this;
    const all = this.frames.has.reduce((mask, has) => mask | has, 0);
    const present = this.frames.types.filter((type, k) => (all >> k) & 1);
    const own = [...packets.values()].some((packet) => packet.arrays.colour);
    if (packets.size > 0)
      this.view.describe({
        present: [...present, 'obstacles', 'domain', ...stage.marks.kinds.keys()],
        fields: fieldsOf(packets.values()),
        own,
      });
    const shareOf = (level) => Number((2 ** level).toPrecision(2));
    const thinned = [...packets]
      .filter(([, { header }]) => header.level > 0)
      .map(
        ([type, { header }]) =>
          `${type}: 1 of ${shareOf(header.level)} drawn, of ${countText(header.count)}`,
      );
    this.notices.set('thinned', thinned.join('; '));
    const lost = [...packets]
      .filter(([, { header }]) => header.finite < header.count)
      .map(
        ([type, { header }]) =>
          `${type}: ${countText(header.count - header.finite)} positions are not finite`,
      );
    this.notices.set('finite', lost.join('; '), true);
  }

  applyColours(packets) {
    const { settings, stage } = this;
    const range = this.colouring.range(settings.range);
    stage.setColours(settings.map, range);
    const shown = [...packets.values()];
    const labelled = shown.find((packet) => packet.arrays.label);
    if (labelled) this.bar.showLabels(settings.field.name, new Set(labelled.arrays.label.data));
    else if (shown.some((packet) => packet.arrays.value))
      this.bar.showValues({
        title: titleOf(settings.field),
        unit: this.colouring.unit,
        ...range,
        map: settings.map,
        whole: fieldsOf(shown).find(({ name }) => name === settings.field.name)?.whole,
      });
    else this.bar.hide();
  }

  /// Returns a spacing for frames whose scene is not readable.
  guessSpacing(packet) {
    const size = this.boxOf([packet]).getSize(new THREE.Vector3());
    return Math.cbrt((size.x * size.y * size.z || 1e-6) / Math.max(1, packet?.arrays.position.rows ?? 1));
  }

  async playOn(frame) {
    const { rate } = this.settings,
      count = this.frames.numbers.length;
    for (let k = Math.min(AHEAD, count - 1 - frame); k > 0; k--) {
      const types = this.typesOf(frame + k);
      for (const type of types) this.store.load(this.queryOf(frame + k, type)).catch(() => {});
      if (types.includes('surface')) this.loadMesh(frame + k);
    }
    clearTimeout(this.player);
    this.player = setTimeout(() => {
      if (!this.settings.playing || this.settings.frame !== frame) return;
      if (frame + 1 < count) this.settings.change({ frame: frame + 1 });
      else this.settings.change({ playing: false });
    }, 1000 / rate);
  }

  goToTime(time) {
    if (!this.frames?.times.length) return;
    const distances = this.frames.times.map((t) => Math.abs(t - time));
    this.time.go(distances.indexOf(Math.min(...distances)));
  }

  // ---- settings ----

  settingsChanged(changed) {
    const { settings, stage } = this;
    if (changed.has('theme')) this.applyTheme();
    if (changed.has('cut')) stage.setCut(settings.cut);
    if (changed.has('layers')) this.showMarks();
    const reload = ['frame', 'field', 'most', 'layers', 'look', 'range', 'map'];
    if (reload.some((name) => changed.has(name)) || (changed.has('playing') && settings.playing)) this.show();
  }

  /// Shows or hides obstacles, domain and marks by the chosen layers.
  showMarks() {
    const { stage, settings } = this;
    stage.obstacles.group.visible = settings.layers.obstacles;
    stage.domain.object.visible = settings.layers.domain;
    stage.marks.show(settings.layers);
  }

  turnTheme() {
    this.settings.change({ theme: this.isDark() ? 'light' : 'dark' });
  }

  isDark() {
    const { theme } = this.settings;
    return theme === 'auto' ? this.dark.matches : theme === 'dark';
  }

  applyTheme() {
    document.documentElement.dataset.theme = this.isDark() ? 'dark' : 'light';
    this.stage.setTheme(this.isDark());
    this.charts.restyle();
  }

  // ---- camera ----

  sceneCamera() {
    const camera = this.scene?.camera;
    if (camera) this.stage.setCamera(camera.from, camera.at, camera.field_of_view_deg);
    else this.fit();
  }

  boxOf(packets) {
    const box = new THREE.Box3(),
      point = new THREE.Vector3();
    for (const packet of packets) {
      const data = packet?.arrays.position.data ?? [];
      const stride = 3 * Math.max(1, Math.floor(data.length / 3 / 20000));
      for (let k = 0; k + 2 < data.length; k += stride)
        box.expandByPoint(point.set(data[k], data[k + 1], data[k + 2]));
    }
    return box;
  }

  fit() {
    const box = this.boxOf(
      [...this.stage.layers.values()].filter((l) => l.group.visible).map((l) => l.packet),
    );
    if (box.isEmpty()) return;
    this.fitting = false;
    this.stage.fit(box);
  }

  async copyCamera() {
    const { camera, controls } = this.stage;
    const line = cameraLine(camera.position.toArray(), controls.target.toArray(), camera.fov);
    const copied = await navigator.clipboard?.writeText(line).then(
      () => true,
      () => false,
    );
    this.view.showCamera(line, copied);
  }
}
