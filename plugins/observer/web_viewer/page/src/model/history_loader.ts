// SPDX-License-Identifier: BSD-3-Clause
// Fetches the rows that the stream has not brought: those before the connection, and gaps.
import type { RowBlock } from '../wire/messages';
import { kHistoryLimit } from '../wire/api';
import type { RowStore } from './row_store';

export type FetchRows = (from: number, count: number) => Promise<RowBlock | null>;

export class HistoryLoader {
  private busy = false;
  private wanted = 0;

  constructor(
    private readonly store: RowStore,
    private readonly fetchRows: FetchRows,
    private readonly loaded: () => void,
  ) {}

  get loading(): boolean {
    return this.busy;
  }

  /** Fetches missing rows. The server has `total` rows. */
  async catchUp(total: number): Promise<void> {
    this.wanted = Math.max(this.wanted, total);
    if (this.busy) return;
    this.busy = true;
    try {
      while (this.store.count < this.wanted) {
        const before = this.store.count;
        const block = await this.fetchRows(before, Math.min(this.wanted - before, kHistoryLimit));
        if (block !== null) this.store.add(block);
        this.loaded();
        if (this.store.count === before) break; // the server has no more rows
      }
    } finally {
      this.busy = false;
    }
  }
}
