// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { bestMotion, bestScale, firstDistance, kIdentity, moved } from '../src/model/alignment';

const kCount = 50;

function curve(turn: number, x: number, y: number, z: number) {
  const track = { x: new Float64Array(kCount), y: new Float64Array(kCount), z: new Float64Array(kCount) };
  for (let i = 0; i < kCount; ++i) {
    const [a, b] = [i, (i * i) / 30];
    track.x[i] = Math.cos(turn) * a - Math.sin(turn) * b + x;
    track.z[i] = Math.sin(turn) * a + Math.cos(turn) * b + z;
    track.y[i] = y;
  }
  return track;
}

describe('the alignment of the truth', () => {
  it('finds a turn and a shift', () => {
    const from = curve(0, 0, 2, 0);
    const motion = bestMotion(from, curve(2.5, 30, 3, -7), kCount);
    expect(Math.atan2(motion.sin, motion.cos)).toBeCloseTo(2.5, 9);
    expect(motion.y).toBeCloseTo(1, 9);
    const [x, z] = moved(motion, 0, 0);
    expect([x, z]).toEqual([expect.closeTo(30, 9), expect.closeTo(-7, 9)]);
  });

  it('finds the scale of an estimate, and aligns in metres of the truth', () => {
    const truth = curve(0, 0, 2, 0);
    const estimate = curve(2.5, 30, 3, -7);
    for (const c of [estimate.x, estimate.y, estimate.z]) c.forEach((v, i) => (c[i] = v / 4));
    const scale = bestScale(truth, estimate, kCount);
    expect(scale).toBeCloseTo(4, 9);
    const motion = bestMotion(truth, estimate, kCount, scale);
    const [x, z] = moved(motion, truth.x[20]!, truth.z[20]!);
    expect(x).toBeCloseTo(4 * estimate.x[20]!, 9);
    expect(z).toBeCloseTo(4 * estimate.z[20]!, 9);
    expect(truth.y[20]! + motion.y).toBeCloseTo(4 * estimate.y[20]!, 9);
    expect(bestScale(truth, curve(0, 0, 0, 0), 1)).toBe(1);
  });

  it('looks only where both are known', () => {
    const from = curve(0, 0, 0, 0);
    const to = curve(0.3, 5, 0, 5);
    from.x.fill(NaN, 0, 10);
    to.z.fill(NaN, 40);
    expect(Math.asin(bestMotion(from, to, kCount).sin)).toBeCloseTo(0.3, 9);
    expect(firstDistance(from, to, 10)).toBeNaN();
  });

  it('does nothing without two common rows', () => {
    expect(bestMotion(curve(0, 0, 0, 0), curve(1, 2, 3, 4), 1)).toBe(kIdentity);
  });

  it('measures how far apart the starts are', () => {
    expect(firstDistance(curve(0, 0, 0, 0), curve(0, 3, 9, 4), kCount)).toBeCloseTo(5);
  });
});
