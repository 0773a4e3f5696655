// SPDX-License-Identifier: BSD-3-Clause
// Reduces the number of line segments where many fall on the same pixels. Space is divided into
// cells, and each end is replaced by the first end in its cell, so lines stay connected. Segments
// within a cell and repeated segments are left out.

const kBits = 2 ** 17; // cells along an axis before keys repeat

export class SegmentThinner {
  /** Both ends (x, y, z) of the kept segments. */
  values: Float32Array<ArrayBuffer> = new Float32Array(6 * 256);
  /** Number of each kept segment among all, ascending. */
  readonly kept: number[] = [];
  private seen = 0;
  private readonly places = new Map<number, number>(); // cell to the number of its point
  private readonly points: number[] = [];
  private readonly pairs = new Set<number>();

  /** `cell` 0 keeps everything. */
  constructor(readonly cell: number) {}

  /** Number of segments processed. */
  get count(): number {
    return this.seen;
  }

  /** Processes the segments from `count` to `to`. True when a new one is kept. */
  take(segments: Float32Array, to: number): boolean {
    const before = this.kept.length;
    for (; this.seen < to; ++this.seen) this.takeOne(segments, 6 * this.seen);
    return this.kept.length > before;
  }

  private takeOne(segments: Float32Array, at: number): void {
    if (this.cell <= 0) {
      this.keep(segments, at, segments, at + 3);
      return;
    }
    const a = this.place(segments, at);
    const b = this.place(segments, at + 3);
    if (a === b) return;
    const pair = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
    if (this.pairs.has(pair)) return;
    this.pairs.add(pair);
    this.keep(this.points, 3 * a, this.points, 3 * b);
  }

  private place(segments: Float32Array, at: number): number {
    let key = 0;
    for (let k = 0; k < 3; ++k) {
      const cell = Math.floor((segments[at + k] as number) / this.cell) % kBits;
      key = key * kBits + (cell < 0 ? cell + kBits : cell);
    }
    const known = this.places.get(key);
    if (known !== undefined) return known;
    const made = this.points.length / 3;
    for (let k = 0; k < 3; ++k) this.points.push(segments[at + k] as number);
    this.places.set(key, made);
    return made;
  }

  private keep(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): void {
    const end = 6 * this.kept.length;
    if (end + 6 > this.values.length) {
      const values = new Float32Array(2 * this.values.length);
      values.set(this.values);
      this.values = values;
    }
    for (let k = 0; k < 3; ++k) {
      this.values[end + k] = a[i + k] as number;
      this.values[end + 3 + k] = b[j + k] as number;
    }
    this.kept.push(this.seen);
  }
}

/** Number of values of an ascending list that are less than `limit`. */
export function countBelow(ascending: readonly number[], limit: number): number {
  let low = 0;
  let high = ascending.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((ascending[middle] as number) < limit) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Cell size in m for a zoom in pixels/m: about two pixels, a power of two so that it seldom changes. */
export function cellFor(zoom: number): number {
  return 2 ** Math.floor(Math.log2(2.5 / zoom));
}
