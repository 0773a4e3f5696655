// SPDX-License-Identifier: BSD-3-Clause
// Rendering of the map: renderer, ground grid, and two cameras, one from above and one in space.
import {
  Box3, BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments, MOUSE, type Object3D,
  OrthographicCamera, PerspectiveCamera, Scene, TOUCH, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { webGl } from '../look/web_gl';
import { roundDown } from '../model/sampling';

export type Dimension = '2d' | '3d';

const kHeight = 5000; // m of the camera from above

export class MapStage {
  readonly scene = new Scene();
  dimension: Dimension = '2d';
  /** With software rendering: full resolution, used while nothing moves. */
  readonly software = webGl() === 'software';
  fine = false;
  untouched = true; // nobody has moved the view yet: it may fit itself
  gridStep = 0; // m
  private readonly renderer: WebGLRenderer;
  private readonly flat = new OrthographicCamera(-1, 1, 1, -1, 1, 4 * kHeight);
  private readonly space = new PerspectiveCamera(45, 1, 0.05, 100000);
  private readonly flatControls: OrbitControls;
  private readonly spaceControls: OrbitControls;
  private readonly gridMaterial = new LineBasicMaterial({ transparent: true, depthWrite: false });
  private readonly grid = new LineSegments(new BufferGeometry(), this.gridMaterial);
  private gridKey = '';
  readonly resolution = { value: new Vector2(1, 1) }; // CSS px
  private width = 1;
  private height = 1;

  constructor(private readonly canvas: HTMLCanvasElement, changed: () => void) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.software, alpha: false });
    this.flat.up.set(0, 0, -1);
    this.flat.position.set(0, kHeight, 0);
    this.space.position.set(40, 60, 80);
    this.flatControls = new OrbitControls(this.flat, canvas);
    this.spaceControls = new OrbitControls(this.space, canvas);
    this.setUpControls(changed);
    this.grid.renderOrder = 0;
    this.grid.frustumCulled = false;
    this.scene.add(this.grid);
    this.choose('2d');
  }

  private setUpControls(changed: () => void): void {
    this.flatControls.enableRotate = false;
    this.flatControls.zoomToCursor = true;
    this.flatControls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.flatControls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    [this.flatControls.minZoom, this.flatControls.maxZoom] = [1e-3, 1e4];
    this.spaceControls.enableDamping = true;
    this.spaceControls.dampingFactor = 0.12;
    this.spaceControls.maxPolarAngle = 0.49 * Math.PI;
    for (const controls of [this.flatControls, this.spaceControls]) {
      controls.enabled = false;
      controls.addEventListener('change', changed);
      controls.addEventListener('start', () => (this.untouched = false));
    }
  }

  add(object: Object3D): void {
    this.scene.add(object);
  }

  choose(dimension: Dimension): void {
    this.dimension = dimension;
    this.flatControls.enabled = dimension === '2d';
    this.spaceControls.enabled = dimension === '3d';
  }

  setColours(ground: string, grid: string): void {
    this.renderer.setClearColor(ground);
    this.gridMaterial.color.set(grid);
  }

  /** True when the size on the screen has changed. */
  resize(): boolean {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ratio = this.software ? (this.fine ? 2 : 1) : Math.min(window.devicePixelRatio, 2);
    if (width === this.width && height === this.height && ratio === this.renderer.getPixelRatio()) {
      return false;
    }
    [this.width, this.height] = [Math.max(1, width), Math.max(1, height)];
    this.resolution.value.set(this.width, this.height);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
    // In pixels: zoom is pixels a metre.
    [this.flat.left, this.flat.right] = [-this.width / 2, this.width / 2];
    [this.flat.top, this.flat.bottom] = [this.height / 2, -this.height / 2];
    this.flat.updateProjectionMatrix();
    this.space.aspect = this.width / this.height;
    this.space.updateProjectionMatrix();
    return true;
  }

  /** Pixels per metre at the centre. */
  get zoom(): number {
    if (this.dimension === '2d') return this.flat.zoom;
    const away = this.space.position.distanceTo(this.spaceControls.target);
    return this.height / (2 * away * Math.tan((this.space.fov * Math.PI) / 360));
  }

  get centre(): Vector3 {
    return (this.dimension === '2d' ? this.flatControls : this.spaceControls).target;
  }

  zoomBy(factor: number): void {
    this.untouched = false;
    if (this.dimension === '2d') {
      this.flat.zoom *= factor;
      this.flat.updateProjectionMatrix();
      this.flatControls.update();
      return;
    }
    const arm = this.space.position.clone().sub(this.spaceControls.target).divideScalar(factor);
    this.space.position.copy(this.spaceControls.target).add(arm);
    this.spaceControls.update();
  }

  centreOn(point: Vector3): void {
    for (const controls of [this.flatControls, this.spaceControls]) {
      const shift = point.clone().sub(controls.target);
      if (shift.lengthSq() < 1e-8) continue;
      controls.object.position.add(shift);
      controls.target.add(shift);
      controls.update();
    }
  }

  fit(bounds: Box3): void {
    if (bounds.isEmpty()) return;
    const middle = bounds.getCenter(new Vector3());
    const size = bounds.getSize(new Vector3());
    const zoom = 0.84 * Math.min(this.width / Math.max(size.x, 4), this.height / Math.max(size.z, 4));
    this.flat.zoom = zoom;
    this.flat.updateProjectionMatrix();
    this.flatControls.target.copy(middle).setY(0);
    this.flat.position.set(middle.x, kHeight, middle.z);
    this.flatControls.update();
    const away = (0.46 * this.height) / zoom / Math.tan((this.space.fov * Math.PI) / 360);
    const direction = new Vector3(-0.35, 0.75, 0.8).normalize();
    this.spaceControls.target.copy(middle);
    this.space.position.copy(middle).addScaledVector(direction, away);
    this.spaceControls.update();
  }

  /** Renders once. True while the camera still moves by inertia. */
  render(bounds: Box3): boolean {
    const gliding = this.dimension === '3d' && this.spaceControls.update();
    this.layGrid(bounds);
    this.renderer.render(this.scene, this.dimension === '2d' ? this.flat : this.space);
    return gliding;
  }

  /** The ground grid at the height of the start; round steps, about seven over the width. */
  private layGrid(bounds: Box3): void {
    const across = Math.min(this.width, this.height) / this.zoom;
    const step = roundDown(Math.max(across / 3.5, 1e-3));
    const middle = this.dimension === '2d' || bounds.isEmpty() ? this.centre : bounds.getCenter(new Vector3());
    const snap = (v: number) => Math.round(v / step) * step;
    const [x, z] = [snap(middle.x), snap(middle.z)];
    const key = `${this.dimension} ${step} ${x} ${z}`;
    if (key === this.gridKey) return;
    this.gridKey = key;
    this.gridStep = step;
    // Long lines that pass behind the camera are lost by some drivers: in space square by square.
    const [half, pieces] = this.dimension === '2d' ? [8, 1] : [16, 32];
    const values: number[] = [];
    for (let i = -half; i <= half; ++i) {
      for (let j = 0; j < pieces; ++j) {
        const from = (-half + (2 * half * j) / pieces) * step;
        const to = from + ((2 * half) / pieces) * step;
        values.push(x + i * step, 0, z + from, x + i * step, 0, z + to);
        values.push(x + from, 0, z + i * step, x + to, 0, z + i * step);
      }
    }
    this.grid.geometry.setAttribute('position', new BufferAttribute(new Float32Array(values), 3));
  }
}
