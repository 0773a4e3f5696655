// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { nearness, palette, rgbaTable, viridis } from '../src/look/colour_map';
import { GrowingDepthRange } from '../src/model/depth_range';

/** Relative luminance by the definition of the web's contrast rules. */
function luminance(rgb: readonly number[]): number {
  const [r, g, b] = rgb.map((c) => {
    const share = c / 255;
    return share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

describe('the colour map', () => {
  it('has the ends and the middle of the report', () => {
    expect(viridis(0)).toEqual([68, 1, 84]);
    expect(viridis(0.5)).toEqual([33, 144, 141]);
    expect(viridis(1)).toEqual([253, 231, 37]);
  });

  it('grows brighter all the way, so that it reads without hue', () => {
    let before = -1;
    for (let i = 0; i <= 100; ++i) {
      const now = luminance(viridis(i / 100));
      expect(now).toBeGreaterThan(before);
      before = now;
    }
  });

  it('clamps, and takes NaN as nothing', () => {
    expect(viridis(-3)).toEqual(viridis(0));
    expect(viridis(7)).toEqual(viridis(1));
    expect(viridis(NaN)).toEqual(viridis(0));
  });

  it('comes as a palette and as a table', () => {
    expect(palette(2)).toEqual(['rgb(68 1 84)', 'rgb(253 231 37)']);
    const table = rgbaTable();
    expect(Array.from(table.slice(255 * 4))).toEqual([253, 231, 37, 255]);
  });
});

describe('depths', () => {
  it('are near 1 and far 0 on a logarithmic scale', () => {
    const range = { near: 1, far: 100 };
    expect(nearness(1, range)).toBe(1);
    expect(nearness(10, range)).toBeCloseTo(0.5);
    expect(nearness(100, range)).toBe(0);
    expect(nearness(1e6, range)).toBe(0);
    expect(nearness(-1, range)).toBe(0);
  });

  const points = (...depths: number[]) => Float32Array.from(depths.flatMap((d) => [0, 0, 1 / d, 0]));

  it('span round numbers that only grow apart', () => {
    const range = new GrowingDepthRange();
    expect(range.ticks()).toEqual([]);
    range.include(points(6, 7, 8, 20, 45));
    expect(range.range).toEqual({ near: 5, far: 50 });
    range.include(points(9, 10, 11));
    expect(range.range).toEqual({ near: 5, far: 50 });
    range.include(points(3, 10, 80));
    expect(range.ticks()).toEqual([2, 5, 10, 20, 50, 100]);
  });

  it('ignore points without depth', () => {
    const range = new GrowingDepthRange();
    range.include(Float32Array.of(0, 0, 0, 0, 1, 1, NaN, 0));
    expect(range.range).toBeNull();
  });
});
