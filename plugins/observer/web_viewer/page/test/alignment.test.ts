// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { bestMotion, firstDistance, kIdentity, moved } from '../src/model/alignment';

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
