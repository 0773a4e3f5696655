// SPDX-License-Identifier: BSD-3-Clause
// The colour map viridis (matplotlib), readable with colour blindness and in grey. The same anchors as
// in the report.

export type Rgb = readonly [number, number, number];

const kAnchors: readonly Rgb[] = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];

/** Colour of a value, clamped to [0, 1]; NaN is 0. */
export function viridis(value: number): Rgb {
  const clamped = value > 0 ? Math.min(value, 1) : 0;
  const place = clamped * (kAnchors.length - 1);
  const below = Math.min(Math.floor(place), kAnchors.length - 2);
  const part = place - below;
  const a = kAnchors[below] as Rgb;
  const b = kAnchors[below + 1] as Rgb;
  const mix = (i: 0 | 1 | 2) => Math.round((1 - part) * a[i] + part * b[i]);
  return [mix(0), mix(1), mix(2)];
}

export function css([r, g, b]: Rgb): string {
  return `rgb(${r} ${g} ${b})`;
}

/** CSS colours of `steps` values from `from` to 1. */
export function palette(steps: number, from = 0): string[] {
  return Array.from({ length: steps }, (_, i) =>
    css(viridis(from + ((1 - from) * i) / Math.max(1, steps - 1))),
  );
}

/** 256 colours as RGBA bytes, for images. */
export function rgbaTable(): Uint8ClampedArray {
  const table = new Uint8ClampedArray(256 * 4);
  for (let i = 0; i < 256; ++i) table.set([...viridis(i / 255), 255], 4 * i);
  return table;
}

/** A range of depths, on a logarithmic scale. */
export interface DepthRange {
  readonly near: number; // m
  readonly far: number;
}

export function nearness(depth: number, { near, far }: DepthRange): number {
  if (!(depth > 0)) return 0;
  const share = Math.log(far / depth) / Math.log(far / near);
  return Math.max(0, Math.min(1, share));
}
