// SPDX-License-Identifier: BSD-3-Clause
// What happened: events that the run logged, and moments that the rows show (loops, lost, found).
import type { LogEvent } from '../wire/messages';
import type { RowStore } from './row_store';

const kMostLogged = 1000;
const kMostMoments = 20000;

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

  /** The same event twice (after a reconnect) counts once. */
  add(events: readonly LogEvent[]): void {
    for (const event of events) {
      const key = `${event.frame} ${event.source} ${event.message}`;
      if (this.seen.has(key)) continue;
      this.seen.add(key);
      this.logged.push(event);
      ++this.edition_;
    }
    if (this.logged.length > kMostLogged) {
      this.logged.splice(0, this.logged.length - kMostLogged);
      this.seen = new Set(this.logged.map((e) => `${e.frame} ${e.source} ${e.message}`));
    }
  }

  /** Reads rows that it has not read yet. */
  scan(rows: RowStore): void {
    for (; this.scanned < rows.count; ++this.scanned) {
      for (const moment of momentsOf(rows, this.scanned)) {
        if (this.moments.length < kMostMoments) this.moments.push(moment);
        ++this.edition_;
      }
    }
  }

  /** The newest `most` at or before `frame`, newest first. */
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
  const note = (level: string, source: string, message: string) =>
    moments.push({ frame, level, source, message });
  const now = rows.value(row, 'tracking');
  const before = rows.value(row - 1, 'tracking');
  if (now === 2 && before !== 2) note('warning', 'odometry', 'tracking lost');
  if (now === 1 && before === 2) note('info', 'odometry', 'tracking again');
  if (rows.value(row, 'action') !== 2) return moments;
  const experience = rows.value(row, 'experience');
  const template = rows.value(row, 'template_id');
  const by = template >= 0 ? ` by template ${template}` : '';
  note('loop', 'cells', `loop to experience ${experience}${by}`);
  return moments;
}
