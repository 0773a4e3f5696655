// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { HistoryLoader } from '../src/model/history_loader';
import { RowStore } from '../src/model/row_store';
import type { RowBlock } from '../src/wire/messages';

const kNames = ['frame.frame', 'place.template_id', 'motion.v'] as const;

/** Rows [from, to): frame = 2 * row, template = row / 10, v = row + 0.5. */
function block(from: number, to: number): RowBlock {
  const values: number[] = [];
  for (let r = from; r < to; ++r) values.push(2 * r, Math.floor(r / 10), r + 0.5);
  return { from, columns: kNames.length, values: Float64Array.from(values) };
}

function expectDense(store: RowStore, count: number): void {
  expect(store.count).toBe(count);
  for (let r = 0; r < count; ++r) expect(store.value(r, 'motion.v')).toBe(r + 0.5);
}

describe('the row store', () => {
  it('keeps rows in order, over many growths', () => {
    const store = new RowStore(kNames);
    for (let r = 0; r < 5000; r += 7) store.add(block(r, Math.min(5000, r + 7)));
    expectDense(store, 5000);
  });

  it('takes overlapping and repeated blocks once', () => {
    const store = new RowStore(kNames);
    store.add(block(0, 10));
    expect(store.add(block(0, 10))).toBe(false);
    expect(store.add(block(5, 15))).toBe(true);
    expectDense(store, 15);
  });

  it('holds back what comes early until the gap is filled', () => {
    const store = new RowStore(kNames);
    store.add(block(20, 25));
    store.add(block(10, 20));
    expect([store.count, store.gap]).toEqual([0, 0]);
    store.add(block(0, 12));
    expectDense(store, 25);
    expect(store.gap).toBe(-1);
  });

  it('finds the row of a frame, also between rows', () => {
    const store = new RowStore(kNames);
    store.add(block(0, 100));
    expect(store.rowOfFrame(0)).toBe(0);
    expect(store.rowOfFrame(51)).toBe(25);
    expect(store.rowOfFrame(1e9)).toBe(99);
    expect(store.rowOfFrame(-1)).toBe(-1);
  });

  it('counts templates and knows where each began', () => {
    const store = new RowStore(kNames);
    store.add(block(0, 35));
    expect([store.templates(0), store.templates(34)]).toEqual([1, 4]);
    expect(store.frameOfTemplate(2)).toBe(40);
    expect(store.frameOfTemplate(9)).toBeNaN();
  });

  it('says NaN for what it does not have', () => {
    const store = new RowStore(kNames);
    store.add(block(0, 3));
    expect(store.value(3, 'motion.v')).toBeNaN();
    expect(store.value(-1, 'motion.v')).toBeNaN();
    expect(store.value(0, 'place.score')).toBeNaN();
  });

  it('refuses rows with other columns', () => {
    expect(() => new RowStore(kNames).add({ ...block(0, 1), columns: 2 })).toThrow('other columns');
  });
});

describe('the history loader', () => {
  it('fetches what is missing while the stream goes on', async () => {
    const store = new RowStore(kNames);
    const asked: number[][] = [];
    const loader = new HistoryLoader(store, (from, count) => {
      asked.push([from, count]);
      store.add(block(40, 45)); // comes by the stream in the meantime
      return Promise.resolve(block(from, Math.min(from + count, from + 15))); // a stingy server
    }, () => undefined);
    await loader.catchUp(40);
    expectDense(store, 45);
    expect(asked).toEqual([[0, 40], [15, 25], [30, 10]]);
  });

  it('gives up when the server has no more', async () => {
    const store = new RowStore(kNames);
    let calls = 0;
    const loader = new HistoryLoader(store, () => (++calls, Promise.resolve(null)), () => undefined);
    await loader.catchUp(10);
    expect([calls, store.count, loader.loading]).toEqual([1, 0, false]);
  });
});
