// SPDX-License-Identifier: BSD-3-Clause
// Lines and dots of the map, in buffers that grow by doubling. An earlier frame shows a prefix of each
// layer, which needs no new buffers.
import { BufferAttribute, BufferGeometry, CanvasTexture, Mesh, Points, PointsMaterial } from 'three';
import { countBelow, SegmentThinner } from '../model/thinning';
import { LineMaterial, type Fade, type Resolution } from './line_material';

const kFew = 800; // segments that need no thinning

/** World axes (x right, y down, z forward) to scene axes (y up): half a turn about x. */
export function toScene(x: number, y: number, z: number): [number, number, number] {
  return [x, -y, -z];
}

export class SegmentLayer {
  readonly object: Mesh<BufferGeometry, LineMaterial>;
  private raw = new Float32Array(6 * 64);
  private count = 0;
  private thinner = new SegmentThinner(0);
  private stale = true;
  private room = 64;

  constructor(width: number, order: number, resolution: Resolution, fade: Fade) {
    this.object = new Mesh(rectangles(this.room), new LineMaterial(width, resolution, fade));
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
  }

  setColour(colour: string): void {
    this.object.material.setColour(colour);
  }

  /** Sets the ends of a segment, in scene axes. */
  set(segment: number, a: readonly number[], b: readonly number[]): void {
    const end = 6 * segment + 6;
    if (end > this.raw.length) {
      const raw = new Float32Array(Math.max(end, 2 * this.raw.length));
      raw.set(this.raw);
      this.raw = raw;
    }
    this.raw.set(a as number[], end - 6);
    this.raw.set(b as number[], end - 3);
    if (segment < this.thinner.count) this.stale = true;
    this.count = Math.max(this.count, segment + 1);
  }

  /** Removes the segments from `count` on. */
  cut(count: number): void {
    if (count >= this.count) return;
    this.count = count;
    this.stale = true;
  }

  /** Draws the first `count` segments, thinned to cells of size `cell` in m; 0 for all. */
  show(count: number, cell: number): void {
    const wanted = this.count > kFew ? cell : 0;
    if (this.stale || this.thinner.cell !== wanted) this.thinner = new SegmentThinner(wanted);
    this.stale = false;
    const before = this.thinner.kept.length;
    if (this.thinner.take(this.raw, this.count)) this.upload(before);
    const shown = countBelow(this.thinner.kept, count);
    this.object.geometry.setDrawRange(0, 6 * shown);
    this.object.visible = shown > 0;
  }

  /** Writes four corners for each kept segment from `from` on. */
  private upload(from: number): void {
    const { values, kept } = this.thinner;
    if (kept.length > this.room) this.grow(kept.length);
    const [start, end] = this.ends();
    for (let i = from; i < kept.length; ++i) {
      const [a, b] = [values.subarray(6 * i, 6 * i + 3), values.subarray(6 * i + 3, 6 * i + 6)];
      for (let corner = 0; corner < 4; ++corner) {
        (start.array as Float32Array).set(a, 12 * i + 3 * corner);
        (end.array as Float32Array).set(b, 12 * i + 3 * corner);
      }
    }
    start.needsUpdate = end.needsUpdate = true;
  }

  private ends(): [BufferAttribute, BufferAttribute] {
    const { start, end } = this.object.geometry.attributes;
    return [start as BufferAttribute, end as BufferAttribute];
  }

  private grow(needed: number): void {
    while (this.room < needed) this.room *= 2;
    const old = this.object.geometry;
    const [start, end] = this.ends();
    this.object.geometry = rectangles(this.room);
    const [longerStart, longerEnd] = this.ends();
    (longerStart.array as Float32Array).set(start.array);
    (longerEnd.array as Float32Array).set(end.array);
    old.dispose();
  }
}

/** Buffers for rectangles. Of a corner's position, x selects the end and y the side. */
function rectangles(room: number): BufferGeometry {
  const corners = new Float32Array(12 * room);
  const index = new Uint32Array(6 * room);
  for (let i = 0; i < room; ++i) {
    corners.set([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 12 * i);
    index.set([0, 1, 2, 0, 2, 3].map((corner) => 4 * i + corner), 6 * i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setAttribute('start', new BufferAttribute(new Float32Array(12 * room), 3));
  geometry.setAttribute('end', new BufferAttribute(new Float32Array(12 * room), 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

export class DotLayer {
  readonly object: Points<BufferGeometry, PointsMaterial>;
  private values = new Float32Array(3 * 64);

  constructor(order: number, fade: Fade) {
    const material = new PointsMaterial({
      size: 6, sizeAttenuation: false, map: ringTexture(), transparent: true, depthTest: false,
      depthWrite: false,
    });
    fadeDots(material, fade);
    this.object = new Points(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.bind();
    this.show(0);
  }

  setColour(colour: string): void {
    this.object.material.color.set(colour);
  }

  setSize(size: number): void {
    this.object.material.size = size;
  }

  set(dot: number, at: readonly number[]): void {
    if (3 * dot + 3 > this.values.length) {
      const values = new Float32Array(2 * this.values.length);
      values.set(this.values);
      this.values = values;
      this.bind();
    }
    this.values.set(at as number[], 3 * dot);
  }

  upload(): void {
    this.object.geometry.getAttribute('position').needsUpdate = true;
  }

  show(count: number): void {
    this.object.geometry.setDrawRange(0, count);
    this.object.visible = count > 0;
  }

  private bind(): void {
    const { drawRange } = this.object.geometry;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.values, 3));
    geometry.setDrawRange(drawRange.start, drawRange.count);
    this.object.geometry.dispose();
    this.object.geometry = geometry;
  }
}

/** As LineMaterial fades lines. */
function fadeDots(material: PointsMaterial, fade: Fade): void {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, fade);
    shader.vertexShader = shader.vertexShader
      .replace('void main() {', 'uniform float level;\nuniform float reach;\nvarying float away;\nvoid main() {\n' +
        '  away = reach > 0.0 ? smoothstep(reach, 1.5 * reach, abs(position.y - level)) : 0.0;');
    shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', 'varying float away;\nvoid main() {')
      .replace('#include <color_fragment>', '#include <color_fragment>\n  diffuseColor.a *= 1.0 - 0.8 * away;');
  };
}

/** A small white circle, coloured by the material. */
function ringTexture(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d');
  if (context !== null) {
    context.strokeStyle = '#fff';
    context.fillStyle = '#ffffff59';
    context.lineWidth = 13;
    context.beginPath();
    context.arc(32, 32, 23, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
  return new CanvasTexture(canvas);
}
