// SPDX-License-Identifier: BSD-3-Clause
// Activity and bumps of the fake run's head direction ring and grid torus.

const kRing = 36;
const kSheet = 30;
const kPeriod = 15; // cells
const kMetresPerCell = 10;

const wrapped = (value, period) => ((value % period) + period) % period;

function bump(mean, precision, period, units) {
  return Array.from({ length: units }, (_, i) => {
    const off = Math.abs(wrapped((i * period) / units - mean + period / 2, period) - period / 2);
    return Math.exp(-0.5 * precision * off * off);
  });
}

/** In the names of the wire. `share`: of the energy that the calibration holds. */
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
  };
}
