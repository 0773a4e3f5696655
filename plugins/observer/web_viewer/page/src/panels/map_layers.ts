// SPDX-License-Identifier: BSD-3-Clause
// Lines and dots of the map in buffers that are written in place and grow by doubling. How much of
// a layer is drawn is a count, so going back in time costs nothing.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, InstancedInterleavedBuffer, InterleavedBufferAttribute,
  Points, PointsMaterial,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** World (x right, y down, z forward) to the scene (y up): half a turn about x. */
export function toScene(x: number, y: number, z: number): [number, number, number] {
  return [x, -y, -z];
}

export class SegmentLayer {
  readonly object: LineSegments2;
  private readonly material: LineMaterial;
  private values = new Float32Array(6 * 64);
  private buffer = new InstancedInterleavedBuffer(this.values, 6, 1);

  constructor(width: number, order: number, opacity = 1) {
    this.material = new LineMaterial({
      linewidth: width, transparent: true, opacity, depthTest: false, depthWrite: false,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.bind();
    this.show(0);
  }

  setColour(colour: string): void {
    this.material.color.set(colour);
  }

  /** The ends of a segment, in the scene. Makes room as needed. */
  set(segment: number, a: readonly number[], b: readonly number[]): void {
    if (6 * segment + 6 > this.values.length) this.grow(6 * segment + 6);
    this.values.set(a as number[], 6 * segment);
    this.values.set(b as number[], 6 * segment + 3);
  }

  /** To be called after set(). */
  upload(): void {
    this.buffer.needsUpdate = true;
  }

  show(count: number): void {
    this.object.geometry.instanceCount = Math.max(0, count);
    this.object.visible = count > 0;
  }

  private grow(needed: number): void {
    let length = this.values.length;
    while (length < needed) length *= 2;
    const values = new Float32Array(length);
    values.set(this.values);
    this.values = values;
    this.buffer = new InstancedInterleavedBuffer(values, 6, 1);
    this.bind();
  }

  private bind(): void {
    const old = this.object.geometry;
    const geometry = new LineSegmentsGeometry();
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(this.buffer, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(this.buffer, 3, 3));
    geometry.instanceCount = old.instanceCount;
    this.object.geometry = geometry;
    old.dispose();
  }
}

export class DotLayer {
  readonly object: Points<BufferGeometry, PointsMaterial>;
  private values = new Float32Array(3 * 64);

  constructor(order: number) {
    const material = new PointsMaterial({
      size: 6, sizeAttenuation: false, map: ringTexture(), transparent: true, depthTest: false,
      depthWrite: false,
    });
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
    const positions = this.object.geometry.getAttribute('position');
    positions.needsUpdate = true;
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

/** A small circle, as the paper draws its vertices; white, to be coloured by the material. */
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
