// SPDX-License-Identifier: BSD-3-Clause
// Alignment of the true path with the map: the rigid motion in the plane (x, z) with the least sum of
// squared distances (Umeyama 1991 in two dimensions). Of a single camera the scale is found as well; it
// is applied to the estimate, so that all is drawn in metres of the truth.

export interface PlanarMotion {
  readonly cos: number;
  readonly sin: number;
  readonly x: number;
  readonly y: number; // downwards: offset only
  readonly z: number;
  readonly scale: number; // applied first
}

export const kIdentity: PlanarMotion = { cos: 1, sin: 0, x: 0, y: 0, z: 0, scale: 1 };

export interface Track {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
}

export function moved(m: PlanarMotion, x: number, z: number): readonly [number, number] {
  return [m.scale * (m.cos * x - m.sin * z) + m.x, m.scale * (m.sin * x + m.cos * z) + m.z];
}

/** The first row at which both tracks are known; -1 when there is none. */
export function firstCommon(a: Track, b: Track, count: number): number {
  for (let i = 0; i < count; ++i) if (isKnown(a, i) && isKnown(b, i)) return i;
  return -1;
}

/** Distance of the tracks at the first row where both are known, in m; NaN when there is none. */
export function firstDistance(a: Track, b: Track, count: number): number {
  const i = firstCommon(a, b, count);
  return i < 0 ? NaN : Math.hypot(at(a.x, i) - at(b.x, i), at(a.z, i) - at(b.z, i));
}

/** Metres of `truth` in one unit of `estimate`; 1 when fewer than two rows are common or nothing moves. */
export function bestScale(truth: Track, estimate: Track, count: number): number {
  const { n, along, across, spread } = sums(truth, estimate, count);
  const scale = Math.hypot(along, across) / spread;
  return n >= 2 && Number.isFinite(scale) && scale > 0 ? scale : 1;
}

/** The motion that aligns `from` with `scale` times `to`; the identity when fewer than two rows are common. */
export function bestMotion(from: Track, to: Track, count: number, scale = 1): PlanarMotion {
  const { n, along, across, means } = sums(from, to, count);
  if (n < 2) return kIdentity;
  const [fx, fy, fz, tx, ty, tz] = means;
  const angle = Math.atan2(across, along);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return {
    cos, sin, x: scale * tx - (cos * fx - sin * fz), y: scale * ty - fy,
    z: scale * tz - (sin * fx + cos * fz), scale: 1,
  };
}

type Means = [number, number, number, number, number, number];

/** Over the rows where both are known: means, and sums of products of the centred positions. */
function sums(from: Track, to: Track, count: number) {
  let n = 0;
  const mean = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < count; ++i) {
    if (!isKnown(from, i) || !isKnown(to, i)) continue;
    ++n;
    [from.x, from.y, from.z, to.x, to.y, to.z].forEach((c, k) => {
      mean[k] = (mean[k] as number) + at(c, i);
    });
  }
  const means = mean.map((sum) => sum / n) as Means;
  const [fx, , fz, tx, , tz] = means;
  let [along, across, spread] = [0, 0, 0];
  for (let i = 0; i < count; ++i) {
    if (!isKnown(from, i) || !isKnown(to, i)) continue;
    const [ax, az] = [at(from.x, i) - fx, at(from.z, i) - fz];
    const [bx, bz] = [at(to.x, i) - tx, at(to.z, i) - tz];
    along += ax * bx + az * bz;
    across += ax * bz - az * bx;
    spread += bx * bx + bz * bz;
  }
  return { n, along, across, spread, means };
}

function at(column: Float64Array, i: number): number {
  return column[i] as number;
}

function isKnown(track: Track, i: number): boolean {
  return Number.isFinite(track.x[i]) && Number.isFinite(track.z[i]);
}
