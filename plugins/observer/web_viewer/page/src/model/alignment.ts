// SPDX-License-Identifier: BSD-3-Clause
// Alignment of the true path with the map: the rigid motion in the plane (x, z) with the least sum of
// squared distances, without scale (Umeyama 1991 in two dimensions).

export interface PlanarMotion {
  readonly cos: number;
  readonly sin: number;
  readonly x: number;
  readonly y: number; // downwards: offset only
  readonly z: number;
}

export const kIdentity: PlanarMotion = { cos: 1, sin: 0, x: 0, y: 0, z: 0 };

export interface Track {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
}

export function moved(m: PlanarMotion, x: number, z: number): readonly [number, number] {
  return [m.cos * x - m.sin * z + m.x, m.sin * x + m.cos * z + m.z];
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

/** The motion that aligns `from` with `to`; the identity when fewer than two rows are common. */
export function bestMotion(from: Track, to: Track, count: number): PlanarMotion {
  let n = 0;
  const mean = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < count; ++i) {
    if (!isKnown(from, i) || !isKnown(to, i)) continue;
    ++n;
    [from.x, from.y, from.z, to.x, to.y, to.z].forEach((c, k) => {
      mean[k] = (mean[k] as number) + at(c, i);
    });
  }
  if (n < 2) return kIdentity;
  const [fx, fy, fz, tx, ty, tz] = mean.map((sum) => sum / n) as [number, number, number, number, number, number];
  let along = 0;
  let across = 0;
  for (let i = 0; i < count; ++i) {
    if (!isKnown(from, i) || !isKnown(to, i)) continue;
    const [ax, az] = [at(from.x, i) - fx, at(from.z, i) - fz];
    const [bx, bz] = [at(to.x, i) - tx, at(to.z, i) - tz];
    along += ax * bx + az * bz;
    across += ax * bz - az * bx;
  }
  const angle = Math.atan2(across, along);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return { cos, sin, x: tx - (cos * fx - sin * fz), y: ty - fy, z: tz - (sin * fx + cos * fz) };
}

function at(column: Float64Array, i: number): number {
  return column[i] as number;
}

function isKnown(track: Track, i: number): boolean {
  return Number.isFinite(track.x[i]) && Number.isFinite(track.z[i]);
}
