// SPDX-License-Identifier: BSD-3-Clause
// A periodic sheet as a torus that the pointer can turn. Activity is a translucent texture, so that a
// bump on the far side is visible. Rendered off screen and copied to the canvas of the tile.
import {
  DataTexture, DoubleSide, Mesh, MeshBasicMaterial, NearestFilter, PerspectiveCamera, RepeatWrapping, RGBAFormat,
  Scene, SRGBColorSpace, TorusGeometry, UnsignedByteType, WebGLRenderer,
} from 'three';
import { rgbaTable } from '../look/colour_map';
import type { Surface } from '../look/dom';
import { webGl } from '../look/web_gl';
import type { Colours } from '../look/theme';
import type { Population } from '../model/populations';

const kTable = rgbaTable();
const kDegreesPerPixel = 0.6;

export class TorusScene {
  readonly possible = webGl() !== 'none';
  moved = false;
  private renderer: WebGLRenderer | null = null;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(36, 1, 0.1, 20);
  private readonly material = new MeshBasicMaterial({ transparent: true, side: DoubleSide, depthWrite: false });
  private readonly wire = new MeshBasicMaterial({ wireframe: true, transparent: true, opacity: 0.07, depthWrite: false });
  private readonly mesh = new Mesh(new TorusGeometry(1, 0.48, 40, 80), this.material);
  private canvas: HTMLCanvasElement | null = null;
  private readonly drag = (event: PointerEvent) => this.turn(event);

  constructor(private readonly changed: () => void) {
    this.mesh.add(new Mesh(new TorusGeometry(1, 0.482, 18, 36), this.wire));
    this.scene.add(this.mesh);
    this.camera.position.set(0, -3.5, 3.5);
    this.camera.lookAt(0, 0, 0);
  }

  attach(canvas: HTMLCanvasElement): void {
    this.detach();
    this.canvas = canvas;
    canvas.style.touchAction = 'none';
    canvas.style.cursor = 'grab';
    canvas.addEventListener('pointermove', this.drag);
  }

  detach(): void {
    this.canvas?.removeEventListener('pointermove', this.drag);
    this.canvas = null;
  }

  isOn(canvas: HTMLCanvasElement): boolean {
    return this.canvas === canvas;
  }

  draw(surface: Surface, sheet: Population, colours: Colours): void {
    this.wire.color.set(colours.ink);
    this.moved = false;
    this.renderer ??= new WebGLRenderer({ antialias: true, alpha: true });
    const side = Math.min(surface.canvas.width, surface.canvas.height);
    this.renderer.setSize(side, side, false);
    this.material.map?.dispose();
    this.material.map = texture(sheet);
    this.material.needsUpdate = true;
    this.renderer.render(this.scene, this.camera);
    const context = surface.clear();
    const size = Math.min(surface.width, surface.height);
    context.drawImage(
      this.renderer.domElement, (surface.width - size) / 2, (surface.height - size) / 2, size, size);
  }

  private turn(event: PointerEvent): void {
    if (event.buttons !== 1) return;
    const step = (kDegreesPerPixel * Math.PI) / 180;
    this.mesh.rotation.z += event.movementX * step;
    this.mesh.rotation.x = Math.max(-1, Math.min(1, this.mesh.rotation.x + event.movementY * step));
    this.moved = true;
    this.changed();
  }
}

function texture({ shape, activity }: Population): DataTexture {
  const [rows, columns] = shape as [number, number];
  const greatest = activity.reduce((a, b) => Math.max(a, b), 1e-9);
  const pixels = new Uint8Array(activity.length * 4);
  for (let i = 0; i < activity.length; ++i) {
    const from = 4 * Math.round(255 * Math.max(0, (activity[i] as number) / greatest));
    for (let k = 0; k < 3; ++k) pixels[4 * i + k] = kTable[from + k] as number;
    pixels[4 * i + 3] = 70 + (185 * from) / 1020;
  }
  const made = new DataTexture(pixels, columns, rows, RGBAFormat, UnsignedByteType);
  made.colorSpace = SRGBColorSpace;
  made.magFilter = NearestFilter;
  made.wrapS = made.wrapT = RepeatWrapping;
  made.needsUpdate = true;
  return made;
}
