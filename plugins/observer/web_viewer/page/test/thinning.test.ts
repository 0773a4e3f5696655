// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { cellFor, countBelow, SegmentThinner } from '../src/model/thinning';

/** A spiral as segments, each a few tenths of a metre long. */
function spiral(count: number): Float32Array {
  const at = (i: number) => [Math.cos(i / 50) * (5 + i / 200), 0.5, Math.sin(i / 50) * (5 + i / 200)];
  return Float32Array.from(Array.from({ length: count }, (_, i) => [...at(i), ...at(i + 1)]).flat());
}

function distanceToKept(thinner: SegmentThinner, x: number, z: number): number {
  let least = Infinity;
  for (let i = 0; i < thinner.kept.length; ++i) {
    const v = thinner.values.subarray(6 * i, 6 * i + 6) as unknown as number[];
    const [ax, az, bx, bz] = [v[0]!, v[2]!, v[3]!, v[5]!];
    const [dx, dz] = [bx - ax, bz - az];
    const t = Math.max(0, Math.min(1, ((x - ax) * dx + (z - az) * dz) / (dx * dx + dz * dz || 1)));
    least = Math.min(least, Math.hypot(ax + t * dx - x, az + t * dz - z));
  }
  return least;
}

describe('thinning', () => {
  it('keeps few segments, and no point far from them', () => {
    const all = spiral(4000);
    const thinner = new SegmentThinner(1);
    thinner.take(all, 4000);
    expect(thinner.kept.length).toBeLessThan(1500);
    for (let i = 0; i < 4000; i += 37) {
      expect(distanceToKept(thinner, all[6 * i]!, all[6 * i + 2]!)).toBeLessThan(Math.SQRT2);
    }
  });

  it('is the same in one go and bit by bit', () => {
    const all = spiral(1000);
    const [once, often] = [new SegmentThinner(0.7), new SegmentThinner(0.7)];
    once.take(all, 1000);
    for (let n = 3; n < 1000; n += 7) often.take(all, n);
    often.take(all, 1000);
    expect(often.kept).toEqual(once.kept);
    expect(often.values).toEqual(once.values);
  });

  it('keeps everything as it is when the cell is nothing', () => {
    const all = spiral(300);
    const thinner = new SegmentThinner(0);
    thinner.take(all, 300);
    expect(thinner.kept.length).toBe(300);
    expect(thinner.values.slice(0, 1800)).toEqual(all);
  });

  it('leaves out what comes again', () => {
    const there = [0.1, 0, 0.1, 5.1, 0, 0.1];
    const back = [5.2, 0, 0.2, 0.2, 0, 0.2];
    const thinner = new SegmentThinner(1);
    thinner.take(Float32Array.from([...there, ...back]), 2);
    expect(thinner.kept).toEqual([0]);
  });
});

describe('what goes with it', () => {
  it('counts what lies below a limit', () => {
    expect([0, 1, 5, 9, 100].map((limit) => countBelow([1, 4, 8], limit))).toEqual([0, 0, 2, 3, 3]);
  });

  it('has cells of about two pixels', () => {
    for (const zoom of [0.01, 0.5, 3, 700]) {
      expect(cellFor(zoom) * zoom).toBeGreaterThan(1.2);
      expect(cellFor(zoom) * zoom).toBeLessThanOrEqual(2.5);
    }
  });
});
