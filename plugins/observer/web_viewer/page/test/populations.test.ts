// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { meanInUnits, sortArrays, type Population } from '../src/model/populations';
import type { FrameArray } from '../src/wire/messages';
import type { ArrayAxis, ArrayInfo } from '../src/wire/records';

const array = (name: string, shape: number[], values: number[]): FrameArray => ({
  name, shape, values: Float32Array.from(values),
});
const zeros = (n: number) => new Array<number>(n).fill(0);

const axis = (name: string, unit: string, period: number, first = 0): ArrayAxis => ({
  name, unit, period, first, step: 0, labels: [],
});
const components = (...labels: string[]): ArrayAxis => ({
  name: 'component', unit: '', period: 0, first: 0, step: 1, labels,
});
const info = (name: string, kind: ArrayInfo['kind'], population: string, ...axes: ArrayAxis[]): ArrayInfo => ({
  name, kind, unit: '', doc: '', population, axes,
});

const kHeading = axis('heading', 'rad', 2 * Math.PI);
const kRing = info('hd.activity', 'activity', '', kHeading);
const kSheet = info('grid.activity', 'activity', '', axis('y', 'm', 20), axis('x', 'm', 20));

function only(populations: readonly Population[]): Population {
  expect(populations.length).toBe(1);
  return populations[0] as Population;
}

describe('described arrays', () => {
  it('are rings and sheets with the bumps of their population', () => {
    const { rings, sheets, others } = sortArrays(
      [
        array('hd.activity', [4], [0, 1, 0, 0]),
        array('hd.estimate', [2], [Math.PI, 100]),
        array('grid.activity', [2, 2], [1, 0, 0, 0]),
        array('grid.estimate', [3], [5, 10, 0.25]),
      ],
      [
        kRing, kSheet,
        info('hd.estimate', 'bump', 'hd.activity', components('heading', 'concentration')),
        info('grid.estimate', 'bump', 'grid.activity', components('x', 'y', 'precision')),
      ],
    );
    expect(others).toEqual([]);
    const onRing = only(rings).bumps[0];
    expect(onRing?.label).toBe('estimate');
    expect(onRing?.mean[0]).toBeCloseTo(0.5);
    expect(onRing?.sigma[0]).toBeCloseTo(0.1 / (2 * Math.PI));
    const onSheet = only(sheets).bumps[0];
    expect(onSheet?.mean).toEqual([0.5, 0.25]); // rows (y) first
    expect(onSheet?.sigma).toEqual([0.1, 0.1]); // a standard deviation of 2 m
    expect(meanInUnits(only(sheets), onSheet!)).toEqual([10, 5]);
  });

  it('have the means of bumps first when labels do not name the axes', () => {
    const { sheets } = sortArrays(
      [array('grid.activity', [2, 2], zeros(4)), array('grid.estimate', [3], [10, 5, 1])],
      [kSheet, info('grid.estimate', 'bump', 'grid.activity', components('row', 'column', 'precision'))],
    );
    expect(only(sheets).bumps[0]?.mean).toEqual([0.5, 0.25]);
  });

  it('count phases from that of unit 0', () => {
    const shifted = info('hd.activity', 'activity', '', axis('heading', 'rad', 2 * Math.PI, -Math.PI));
    const { rings } = sortArrays(
      [array('hd.activity', [4], zeros(4)), array('hd.estimate', [2], [0, 1])],
      [shifted, info('hd.estimate', 'bump', 'hd.activity', components('heading', 'precision'))],
    );
    const ring = only(rings);
    expect(ring.bumps[0]?.mean[0]).toBeCloseTo(0.5);
    expect(meanInUnits(ring, ring.bumps[0]!)[0]).toBeCloseTo(0);
  });

  it('show several hypotheses with their energies on every population that has their axes', () => {
    const { rings, sheets } = sortArrays(
      [
        array('hd.activity', [4], zeros(4)),
        array('grid.activity', [2, 2], zeros(4)),
        array('hypotheses', [3, 5], [1, 3, 4, 9, 6, 2, 23, 4, 9, 1.5, 0, 0, 0, 0, 0]),
      ],
      [
        kRing, kSheet,
        info('hypotheses', 'bump', '', axis('hypothesis', '', 0), components('heading', 'x', 'y', 'precision', 'energy')),
      ],
    );
    for (const population of [only(rings), only(sheets)]) {
      expect(population.bumps.map((b) => [b.energy, b.weight])).toEqual([[6, 1], [1.5, 0.25]]);
      expect(population.bumps.every((b) => b.isHypothesis)).toBe(true);
    }
    // 23 m is 3 m, one period of 20 m further.
    expect(only(sheets).bumps[1]?.mean[1]).toBeCloseTo(only(sheets).bumps[0]?.mean[1] as number);
  });

  it('may have several modules', () => {
    const names = ['grid', 'grid2', 'grid3'];
    const { sheets } = sortArrays(
      names.map((n) => array(`${n}.activity`, [2, 2], zeros(4))),
      names.map((n) => ({ ...kSheet, name: `${n}.activity` })),
    );
    expect(sheets.map((s) => s.title)).toEqual(names);
  });

  it('of unknown kind are shown as they are', () => {
    const odd = info('error.history', 'values', '', axis('step', '', 0));
    const { rings, others } = sortArrays([array('error.history', [30], zeros(30))], [odd]);
    expect(rings).toEqual([]);
    expect(others.map((o) => o.info)).toEqual([odd]);
  });
});

describe('arrays of a run without descriptions', () => {
  it('are rings and sheets by their shapes', () => {
    const { rings, sheets, others } = sortArrays(
      [
        array('hd.activity', [36], zeros(36)),
        array('grid.activity', [5, 6], zeros(30)),
        array('hd.estimate', [2], [1, 2]),
        array('block', [2, 3, 4], zeros(24)),
      ],
      [],
    );
    expect(only(rings).title).toBe('hd');
    expect(only(sheets).shape).toEqual([5, 6]);
    expect(others.map((o) => o.info.name)).toEqual(['hd.estimate', 'block']);
  });
});
