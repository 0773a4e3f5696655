// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { EventLog } from '../src/model/event_log';
import { RowStore } from '../src/model/row_store';

const kNames = ['frame.frame', 'motion.state', 'decision.action', 'decision.experience', 'place.template_id'] as const;

function rows(...values: number[][]): RowStore {
  const store = new RowStore(kNames);
  store.add({ from: 0, columns: kNames.length, values: Float64Array.from(values.flat()) });
  return store;
}

const logged = (frame: number, message: string) => ({ frame, level: 'warning' as const, source: 'map', message });

describe('the log of events', () => {
  it('reads loops and lost tracking from the rows, once', () => {
    const log = new EventLog();
    const store = rows([0, 1, 1, 0, 0], [1, 2, 0, 0, -1], [2, 2, 0, 0, -1], [3, 1, 2, 0, 4]);
    log.scan(store);
    log.scan(store);
    expect(log.newest(3, 10).map((e) => e.message)).toEqual([
      'loop to experience 0 by template 4',
      'tracking again',
      'tracking lost',
    ]);
  });

  it('names the loop that was closed', () => {
    const log = new EventLog();
    log.scan(rows([0, 1, 1, 0, 0], [1, 1, 2, 12, 4], [2, 1, 2, 13, -1]));
    expect(log.newest(9, 10).map((e) => e.message)).toEqual([
      'loop to experience 13',
      'loop to experience 12 by template 4',
    ]);
  });

  it('mixes both kinds by frame and shows the past only', () => {
    const log = new EventLog();
    log.scan(rows([0, 1, 1, 0, 0], [5, 1, 2, 0, 0], [9, 1, 2, 0, 0]));
    log.add([logged(7, 'slow')]);
    expect(log.newest(8, 10).map((e) => e.frame)).toEqual([7, 5]);
    expect(log.newest(100, 2).map((e) => e.frame)).toEqual([9, 7]);
  });

  it('takes an event again after a reconnect once, and forgets the oldest', () => {
    const log = new EventLog();
    log.add([logged(1, 'slow')]);
    log.add([logged(1, 'slow'), logged(2, 'slow')]);
    expect(log.count).toBe(2);
    log.add(Array.from({ length: 3000 }, (_, i) => logged(i + 3, 'slow')));
    expect(log.count).toBe(1000);
  });
});
