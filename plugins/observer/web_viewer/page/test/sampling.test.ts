// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { median, quantile, roundDown, roundUp, strided } from '../src/model/sampling';
import { RateMeter } from '../src/model/rate';

describe('sampling', () => {
  it('strides so that few remain, with both ends', () => {
    expect(strided(5, 10)).toEqual([0, 1, 2, 3, 4]);
    const kept = strided(4541, 1000);
    expect(kept.length).toBeLessThanOrEqual(1001);
    expect([kept[0], kept[kept.length - 1]]).toEqual([0, 4540]);
    expect(strided(0, 10)).toEqual([]);
  });

  it('takes medians of what is known', () => {
    const values = Float64Array.of(9, NaN, 1, 5, 3, 100);
    expect(median(values, 0, 5)).toBe(4);
    expect(median(values, 2, 5)).toBe(3);
    expect(median(values, -7, 1)).toBe(9);
    expect(median(values, 1, 2)).toBeNaN();
  });

  it('orders numbers as numbers', () => {
    expect(median(Float64Array.of(10, 9, 100), 0, 3)).toBe(10);
    expect(quantile([10, 9, 100, -1, NaN], 0)).toBe(9);
    expect(quantile([10, 9, 100], 0.99)).toBe(100);
    expect(quantile([], 0.5)).toBeNaN();
  });

  it('rounds to 1, 2 and 5', () => {
    expect([1, 1.9, 2, 4.99, 5, 9.9, 10, 0.03].map(roundDown)).toEqual([1, 1, 2, 2, 5, 5, 10, 0.02]);
    expect([1, 1.1, 2.1, 5.1, 99].map(roundUp)).toEqual([1, 2, 5, 10, 100]);
  });
});

describe('the rate', () => {
  it('is that of the last seconds', () => {
    const meter = new RateMeter(5);
    for (let t = 0; t <= 10; t += 0.1) meter.note(Math.round(20 * t), t);
    expect(meter.rate(10)).toBeCloseTo(20, 0);
  });

  it('falls when nothing comes', () => {
    const meter = new RateMeter(5);
    meter.note(0, 0);
    meter.note(10, 1);
    expect(meter.rate(1)).toBe(10);
    expect(meter.rate(4)).toBe(2.5);
    expect(meter.rate(60)).toBe(0);
  });
});
