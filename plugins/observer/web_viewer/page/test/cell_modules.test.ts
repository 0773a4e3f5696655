// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { circularMean, PeriodFinder, sortCells } from '../src/model/cell_modules';
import type { CellArray } from '../src/wire/messages';

const array = (name: string, shape: number[], values: number[]): CellArray => ({
  name, shape, values: Float32Array.from(values),
});

/** A bump on a sheet of 30 x 30 over a period, as the attractor makes it. */
function sheet(x: number, y: number, period: number): CellArray {
  const off = (a: number, b: number) => Math.abs(((a - b + 1.5 * period) % period) - period / 2);
  const values: number[] = [];
  for (let r = 0; r < 30; ++r) {
    for (let c = 0; c < 30; ++c) {
      const [dx, dy] = [off((c * period) / 30, x), off((r * period) / 30, y)];
      values.push(Math.exp(-0.5 * (dx * dx + dy * dy)));
    }
  }
  return array('grid.activity', [30, 30], values);
}

describe('the cells of a frame', () => {
  it('are rings and sheets with their bumps, by name', () => {
    const { rings, sheets } = sortCells([
      array('hd.activity', [4], [0, 1, 0, 0]),
      array('hd.integrator', [2], [1.5, 90]),
      array('hd.estimate', [2], [1.6, 100]),
      sheet(4, 5, 15),
      array('grid.calibration', [3], [4, 5, 0.3]),
    ]);
    expect(rings.map((r) => r.module)).toEqual(['hd']);
    expect(rings[0]?.bumps.map((b) => b.kind)).toEqual(['integrator', 'estimate']);
    expect(sheets[0]?.bumps).toEqual([
      { kind: 'calibration', mean: [4, 5], precision: expect.closeTo(0.3, 6) },
    ]);
  });

  it('may be several modules', () => {
    const modules = ['grid1', 'grid2', 'grid3'].map((m) => array(`${m}.activity`, [2, 2], [1, 0, 0, 0]));
    expect(sortCells(modules).sheets.map((s) => s.module)).toEqual(['grid1', 'grid2', 'grid3']);
  });

  it('show a block of pose cells as two projections', () => {
    const values = new Array<number>(2 * 3 * 4).fill(0);
    values[1 * 12 + 2 * 4 + 3] = 5; // theta 1, y 2, x 3
    const { rings, sheets } = sortCells([array('pose.activity', [2, 3, 4], values)]);
    expect(Array.from(rings[0]?.activity ?? [])).toEqual([0, 5]);
    expect(sheets[0]?.shape).toEqual([3, 4]);
    expect(sheets[0]?.activity[2 * 4 + 3]).toBe(5);
  });

  it('give the estimate of pose cells to ring and sheet, in units', () => {
    const { rings, sheets } = sortCells([
      array('hd.activity', [36], new Array<number>(36).fill(1)),
      array('grid.activity', [2, 2], [1, 0, 0, 0]),
      array('pose.estimate', [3], [7, 8, 9]),
    ]);
    expect(rings[0]?.bumps[0]?.mean).toEqual([9]);
    expect(sheets[0]?.bumps[0]?.mean).toEqual([7, 8]);
    expect(sheets[0]?.inUnits).toBe(true);
  });
});

describe('the period of a sheet', () => {
  it('follows from the activity and the estimate', () => {
    for (const period of [15, 8.5]) {
      const finder = new PeriodFinder();
      for (const [x, y] of [[4, 5], [0.01, 7.3], [6.2, 0]] as const) {
        const arrays = [sheet(x, y, period), array('grid.estimate', [3], [x, y, 1])];
        finder.note(sortCells(arrays).sheets[0]!);
      }
      expect(finder.period).toBeCloseTo(period, 2);
    }
  });

  it('is not known from a bump on the seam', () => {
    const finder = new PeriodFinder();
    finder.note(sortCells([sheet(0, 0, 15), array('grid.estimate', [3], [0, 0, 1])]).sheets[0]!);
    expect(finder.period).toBeNaN();
  });

  it('counts units when the estimate does', () => {
    const finder = new PeriodFinder();
    const cells = [sheet(4, 5, 15), array('pose.estimate', [3], [8, 10, 0])];
    finder.note(sortCells(cells).sheets[0]!);
    expect(finder.period).toBe(30);
  });
});

describe('a circular mean', () => {
  it('crosses the seam', () => {
    const activity = Float32Array.of(1, 0, 0, 0, 0, 0, 0, 1);
    expect(circularMean(activity, 8, (i) => i)).toBeCloseTo(7.5 / 8);
  });
});
