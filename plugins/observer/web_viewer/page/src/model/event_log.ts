// SPDX-License-Identifier: BSD-3-Clause
// Events that the run has logged, and events found in the rows (loop closures, tracking lost).
import { kChoices, type RunEvent } from '../wire/records';
import type { RowStore } from './row_store';

const kMaxLogged = 1000;
const kMaxMoments = 20000;
const kTracking = kChoices['motion.state'].indexOf('tracking');
const kLost = kChoices['motion.state'].indexOf('lost');
const kCloseLoop = kChoices['decision.action'].indexOf('close_loop');

/** An event of the run, or one that was found in the rows (level "loop" for loop closures). */
export type LogEvent = Omit<RunEvent, 'level'> & { readonly level: RunEvent['level'] | 'loop' };

export class EventLog {
  private logged: LogEvent[] = [];
  private moments: LogEvent[] = [];
  private seen = new Set<string>();
  private scanned = 0;
  private edition_ = 0;

  get edition(): number {
    return this.edition_;
  }
  get count(): number {
    return this.logged.length + this.moments.length;
  }

  clear(): void {
    this.logged = [];
    this.moments = [];
    this.seen.clear();
    this.scanned = 0;
    ++this.edition_;
  }

  /** An event that is sent again (after a reconnect) is added once. */
  add(events: readonly LogEvent[]): void {
    for (const event of events) {
      const key = `${event.frame} ${event.source} ${event.message}`;
      if (this.seen.has(key)) continue;
      this.seen.add(key);
      this.logged.push(event);
      ++this.edition_;
    }
    if (this.logged.length > kMaxLogged) {
      this.logged.splice(0, this.logged.length - kMaxLogged);
      this.seen = new Set(this.logged.map((e) => `${e.frame} ${e.source} ${e.message}`));
    }
  }

  /** Finds the events of new rows. */
  scan(rows: RowStore): void {
    for (; this.scanned < rows.count; ++this.scanned) {
      for (const moment of momentsOf(rows, this.scanned)) {
        if (this.moments.length < kMaxMoments) this.moments.push(moment);
        ++this.edition_;
      }
    }
  }

  /** The newest `most` events up to `frame`, newest first. */
  newest(frame: number, most: number): LogEvent[] {
    const past = [...lastUpTo(this.logged, frame, most), ...lastUpTo(this.moments, frame, most)];
    return past.sort((a, b) => b.frame - a.frame).slice(0, most);
  }
}

function lastUpTo(events: readonly LogEvent[], frame: number, most: number): LogEvent[] {
  const last: LogEvent[] = [];
  for (let i = events.length - 1; i >= 0 && last.length < most; --i) {
    const event = events[i] as LogEvent;
    if (event.frame <= frame) last.push(event);
  }
  return last;
}

function momentsOf(rows: RowStore, row: number): LogEvent[] {
  const moments: LogEvent[] = [];
  const frame = rows.frame(row);
  const note = (level: LogEvent['level'], source: string, message: string) =>
    moments.push({ frame, level, source, message });
  const now = rows.value(row, 'motion.state');
  const before = rows.value(row - 1, 'motion.state');
  if (now === kLost && before !== kLost) note('warning', 'odometry', 'tracking lost');
  if (now === kTracking && before === kLost) note('info', 'odometry', 'tracking again');
  if (rows.value(row, 'decision.action') !== kCloseLoop) return moments;
  const experience = rows.value(row, 'decision.experience');
  const template = rows.value(row, 'place.template_id');
  const by = template >= 0 ? ` by template ${template}` : '';
  note('loop', 'cells', `loop to experience ${experience}${by}`);
  return moments;
}
