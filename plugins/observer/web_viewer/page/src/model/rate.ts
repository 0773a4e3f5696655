// SPDX-License-Identifier: BSD-3-Clause
// Rate of events over the last few seconds.

export class RateMeter {
  private times: number[] = [];
  private counts: number[] = [];

  constructor(private readonly window: number) {} // s

  /** `count`: all events so far; `now` in s. */
  note(count: number, now: number): void {
    this.times.push(now);
    this.counts.push(count);
    this.forget(now);
  }

  /** Events per second; 0 when there was none in the window. */
  rate(now: number): number {
    this.forget(now);
    if (this.times.length < 2) return 0;
    const time = Math.max(now, this.times[this.times.length - 1] as number) - (this.times[0] as number);
    const count = (this.counts[this.counts.length - 1] as number) - (this.counts[0] as number);
    return time > 0 ? count / time : 0;
  }

  private forget(now: number): void {
    let old = 0;
    while (old < this.times.length && (this.times[old] as number) < now - this.window) ++old;
    if (old > 0) {
      this.times.splice(0, old);
      this.counts.splice(0, old);
    }
  }
}
