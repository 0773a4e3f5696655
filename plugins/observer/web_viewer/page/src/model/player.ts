// SPDX-License-Identifier: BSD-3-Clause
// The shown row: the newest one (live), a fixed one (paused), or advancing with data time (playing).

export type Mode = 'live' | 'paused' | 'playing';

export const kSpeeds = [1, 2, 5, 10, 50] as const;

const kLongestGap = 0.25; // s of wall time; limits the step after a tab was hidden

export class Player {
  private mode_: Mode = 'live';
  private row_ = -1;
  private clock = 0; // data time, s, while playing
  private speed_ = 1;

  get mode(): Mode {
    return this.mode_;
  }
  get row(): number {
    return this.row_;
  }
  get speed(): number {
    return this.speed_;
  }

  reset(): void {
    this.mode_ = 'live';
    this.row_ = -1;
  }

  /** Sets the number of rows. True when the shown row changes. */
  grow(count: number): boolean {
    if (this.mode_ !== 'live' || this.row_ === count - 1) return false;
    this.row_ = count - 1;
    return true;
  }

  follow(count: number): void {
    this.mode_ = 'live';
    this.row_ = count - 1;
  }

  pause(): void {
    this.mode_ = 'paused';
  }

  seek(row: number, count: number): void {
    this.mode_ = 'paused';
    this.row_ = Math.max(0, Math.min(count - 1, Math.round(row)));
  }

  play(stamps: Float64Array, count: number): void {
    if (this.row_ >= count - 1) this.row_ = 0;
    this.clock = stamps[this.row_] ?? 0;
    this.mode_ = 'playing';
  }

  cycleSpeed(): void {
    const at = kSpeeds.findIndex((s) => s === this.speed_);
    this.speed_ = kSpeeds[(at + 1) % kSpeeds.length] ?? 1;
  }

  /** Advances by `seconds` of wall time. True when the shown row changes. */
  tick(seconds: number, stamps: Float64Array, count: number): boolean {
    if (this.mode_ !== 'playing') return false;
    this.clock += Math.min(seconds, kLongestGap) * this.speed_;
    const before = this.row_;
    while (this.row_ + 1 < count && (stamps[this.row_ + 1] ?? Infinity) <= this.clock) ++this.row_;
    if (this.row_ >= count - 1) this.mode_ = 'paused';
    return this.row_ !== before || this.mode_ === 'paused';
  }
}
