// SPDX-License-Identifier: BSD-3-Clause
// Activity and bumps of the fake run's head direction ring and grid torus.

const kRing = 36;
const kSheet = 30;
const kPeriod = 15; // cells
const kMetresPerCell = 10;

const axis = (name, unit, period, units) => ({ name, unit, period, first: 0, step: period / units, labels: [] });
const component = (...labels) => ({ name: 'component', unit: '', period: 0, first: 0, step: 1, labels });
const info = (population, what, kind, axes) => ({
  name: `${population}.${what}`, kind, unit: '', doc: `${what} of ${population}`, axes,
  population: kind === 'bump' ? `${population}.activity` : '' });
const kBumps = ['integrator', 'calibration', 'estimate', 'injected'];

/** Descriptions of the arrays, as RunInfo has them. */
export const kArrays = [
  info('hd', 'activity', 'activity', [axis('heading', 'rad', 2 * Math.PI, kRing)]),
  ...kBumps.map((what) => info('hd', what, 'bump', [component('heading', 'concentration')])),
  info('grid', 'activity', 'activity', [axis('y', 'cells', kPeriod, kSheet), axis('x', 'cells', kPeriod, kSheet)]),
  ...kBumps.map((what) => info('grid', what, 'bump', [component('x', 'y', 'precision')])),
  info('pose', 'hypotheses', 'bump', [
    { name: 'hypothesis', unit: '', period: 0, first: 0, step: 1, labels: [] },
    component('heading', 'x', 'y', 'concentration', 'precision', 'energy')]),
];

const wrapped = (value, period) => ((value % period) + period) % period;

function bump(mean, precision, period, units) {
  return Array.from({ length: units }, (_, i) => {
    const off = Math.abs(wrapped((i * period) / units - mean + period / 2, period) - period / 2);
    return Math.exp(-0.5 * precision * off * off);
  });
}

/** The arrays of a frame. */
export function cells(pose, heading, familiar, loops) {
  const share = familiar ? 0.55 : 0.05;
  const x = wrapped(pose.z / kMetresPerCell, kPeriod);
  const y = wrapped(-pose.x / kMetresPerCell, kPeriod);
  const off = loops % 3 === 0 ? 0.4 : 0.2;
  const along = bump(x, 1, kPeriod, kSheet);
  const across = bump(y, 1, kPeriod, kSheet);
  const grid = (dx, dy, precision) =>
    Float32Array.of(wrapped(x + dx, kPeriod), wrapped(y + dy, kPeriod), precision);
  const ring = (d, precision) => Float32Array.of(wrapped(heading + d, 2 * Math.PI), precision);
  return {
    'cells.hd.activity': Float32Array.from(bump(heading, 100, 2 * Math.PI, kRing)),
    'cells.hd.integrator': ring(-0.12 * share, 100 * (1 - share)),
    'cells.hd.calibration': ring(0.12, 100 * share),
    'cells.hd.estimate': ring(0, 100),
    'cells.hd.injected': ring(0.15, familiar ? 40 : 0),
    'cells.grid.activity': {
      shape: [kSheet, kSheet],
      values: Float32Array.from(across.flatMap((a) => along.map((b) => a * b))),
    },
    'cells.grid.integrator': grid(-off, off, 1 - share),
    'cells.grid.calibration': grid(off, -off, share),
    'cells.grid.estimate': grid(0, 0, 1),
    'cells.grid.injected': grid(1.5 * off, -off, familiar ? 0.4 : 0),
    'cells.pose.hypotheses': {
      shape: [2, 6],
      values: Float32Array.of(heading, x, y, 100, 1, 6, heading + 0.8, x + 4, y - 3, 40, 0.5, familiar ? 2 : 0),
    },
    'cells.odometry.errors': Float32Array.from({ length: 20 }, (_, i) => Math.sin(i + x)), // not described
  };
}
