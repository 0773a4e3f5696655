// SPDX-License-Identifier: BSD-3-Clause
// Reduces rows to few points for plots; medians, quantiles and round numbers.

/** Every n-th index of [0, count), `most` at most, and the last one. */
export function strided(count: number, most: number): number[] {
  const step = Math.max(1, Math.ceil(count / most));
  const kept: number[] = [];
  for (let i = 0; i < count; i += step) kept.push(i);
  if (count > 0 && kept[kept.length - 1] !== count - 1) kept.push(count - 1);
  return kept;
}

/** Median of the finite values in [from, to); NaN when there are none. */
export function median(values: Float64Array, from: number, to: number): number {
  const known = values.slice(Math.max(0, from), to).filter(Number.isFinite).sort();
  if (known.length === 0) return NaN;
  const middle = known.length >> 1;
  const high = known[middle] as number;
  return known.length % 2 === 1 ? high : ((known[middle - 1] as number) + high) / 2;
}

/** Quantile of the finite, positive values; NaN when there are none. */
export function quantile(values: ArrayLike<number>, share: number): number {
  const known = Float64Array.from(values).filter((v) => Number.isFinite(v) && v > 0).sort();
  if (known.length === 0) return NaN;
  return known[Math.min(known.length - 1, Math.floor(share * known.length))] as number;
}

/** The greatest 1, 2 or 5 times a power of ten up to a positive value. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  const digit = value / power;
  return power * (digit >= 5 - 1e-9 ? 5 : digit >= 2 - 1e-9 ? 2 : 1);
}

/** The least 1, 2 or 5 times a power of ten from a positive value on. */
export function roundUp(value: number): number {
  const below = roundDown(value);
  if (below >= value * (1 - 1e-9)) return below;
  const digit = Math.round(below / 10 ** Math.floor(Math.log10(below) + 1e-12));
  return below * (digit === 2 ? 2.5 : 2);
}
