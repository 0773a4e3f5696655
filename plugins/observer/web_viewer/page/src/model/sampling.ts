// SPDX-License-Identifier: BSD-3-Clause
// Fewer points than rows, for plots: what is kept must look the same.

/** Every n-th of [0, count), so that at most `most` remain; always with the last. */
export function strided(count: number, most: number): number[] {
  const step = Math.max(1, Math.ceil(count / most));
  const kept: number[] = [];
  for (let i = 0; i < count; i += step) kept.push(i);
  if (count > 0 && kept[kept.length - 1] !== count - 1) kept.push(count - 1);
  return kept;
}

/** Of finite values in [from, to); NaN when there are none. */
export function median(values: Float64Array, from: number, to: number): number {
  const known = values.slice(Math.max(0, from), to).filter(Number.isFinite).sort();
  if (known.length === 0) return NaN;
  const middle = known.length >> 1;
  const high = known[middle] as number;
  return known.length % 2 === 1 ? high : ((known[middle - 1] as number) + high) / 2;
}

/** The value below which a share of the (finite, positive) values lies; NaN when there are none. */
export function quantile(values: ArrayLike<number>, share: number): number {
  const known = Float64Array.from(values).filter((v) => Number.isFinite(v) && v > 0).sort();
  if (known.length === 0) return NaN;
  return known[Math.min(known.length - 1, Math.floor(share * known.length))] as number;
}

/** 1, 2 or 5 times a power of ten, at or below a positive value. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  const digit = value / power;
  return power * (digit >= 5 - 1e-9 ? 5 : digit >= 2 - 1e-9 ? 2 : 1);
}

/** The same, at or above. */
export function roundUp(value: number): number {
  const below = roundDown(value);
  if (below >= value * (1 - 1e-9)) return below;
  const digit = Math.round(below / 10 ** Math.floor(Math.log10(below) + 1e-12));
  return below * (digit === 2 ? 2.5 : 2);
}
