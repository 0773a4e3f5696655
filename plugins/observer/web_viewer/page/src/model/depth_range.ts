// SPDX-License-Identifier: BSD-3-Clause
// The range of depths of the colour scale, in m. It has round ends and only grows, so that the colour
// of a depth seldom changes.
import type { DepthRange } from '../look/colour_map';
import { quantile, roundDown, roundUp } from './sampling';

export class GrowingDepthRange {
  private range_: DepthRange | null = null;

  get range(): DepthRange | null {
    return this.range_;
  }

  clear(): void {
    this.range_ = null;
  }

  /** `points`: u, v, inverse depth, variance of each. */
  include(points: Float32Array): void {
    const inverse = new Float32Array(points.length / 4);
    for (let i = 0; i < inverse.length; ++i) inverse[i] = points[4 * i + 2] as number;
    const near = roundDown(1 / quantile(inverse, 0.98));
    const far = roundUp(1 / quantile(inverse, 0.04));
    if (!Number.isFinite(near) || !Number.isFinite(far) || near >= far) return;
    const old = this.range_;
    this.range_ = old
      ? { near: Math.min(old.near, near), far: Math.max(old.far, far) }
      : { near, far };
  }

  /** Round depths from the near to the far end, in m. */
  ticks(): number[] {
    if (this.range_ === null) return [];
    const { near, far } = this.range_;
    const ticks: number[] = [];
    for (let tick = near; tick <= far * 1.001; tick = roundUp(tick * 1.01)) ticks.push(tick);
    return ticks;
  }
}
