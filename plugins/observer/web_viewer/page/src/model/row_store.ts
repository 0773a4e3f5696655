// SPDX-License-Identifier: BSD-3-Clause
// All history rows, a typed array per column. Blocks may arrive in any order and overlap. `count` is
// the number of rows without a gap from the first on.
import type { RowBlock } from '../wire/messages';
import type { ColumnName } from '../wire/records';

const kFirstCapacity = 1024;

export class RowStore {
  private columns = new Map<ColumnName, Float64Array>();
  private early: RowBlock[] = []; // blocks after a gap
  private capacity = kFirstCapacity;
  private length = 0;
  /** Number of templates up to each row: the greatest id plus one. */
  private templates_ = new Int32Array(kFirstCapacity);
  private firstRows: number[] = []; // row at which each template appeared

  constructor(readonly names: readonly ColumnName[]) {
    for (const name of names) this.columns.set(name, new Float64Array(kFirstCapacity));
  }

  get count(): number {
    return this.length;
  }

  /** The first missing row before rows that have arrived; -1 when there is none. */
  get gap(): number {
    return this.early.length > 0 ? this.length : -1;
  }

  /** Values beyond `count` are unused memory. */
  column(name: ColumnName): Float64Array {
    return this.columns.get(name) ?? kNoColumn;
  }

  /** NaN when there is no such row. */
  value(row: number, name: ColumnName): number {
    if (row < 0 || row >= this.length) return NaN;
    return this.columns.get(name)?.[row] ?? NaN;
  }

  templates(row: number): number {
    return row >= 0 && row < this.length ? (this.templates_[row] ?? 0) : 0;
  }

  /** The frame that a template was made at; NaN for an unknown template. */
  frameOfTemplate(template: number): number {
    return this.frame(this.firstRows[template] ?? -1);
  }

  frame(row: number): number {
    return this.value(row, 'frame.frame');
  }

  /** The last row whose frame is at or before `frame`; -1 when there is none. */
  rowOfFrame(frame: number): number {
    const frames = this.column('frame.frame');
    let low = 0;
    let high = this.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((frames[middle] ?? Infinity) <= frame) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** True when `count` grew. */
  add(block: RowBlock): boolean {
    if (block.columns !== this.names.length) throw new Error('rows with other columns');
    const before = this.length;
    this.early.push(block);
    this.early.sort((a, b) => a.from - b.from);
    while (this.early.length > 0 && (this.early[0] as RowBlock).from <= this.length) {
      this.append(this.early.shift() as RowBlock);
    }
    return this.length > before;
  }

  private append(block: RowBlock): void {
    const rows = Math.floor(block.values.length / block.columns);
    const known = this.length - block.from;
    if (known >= rows) return;
    this.reserve(block.from + rows);
    this.names.forEach((name, c) => {
      const column = this.column(name);
      for (let r = known; r < rows; ++r) {
        column[block.from + r] = block.values[r * block.columns + c] as number;
      }
    });
    const first = this.length;
    this.length = block.from + rows;
    this.countTemplates(first);
  }

  private countTemplates(first: number): void {
    const ids = this.column('place.template_id');
    let most = first > 0 ? (this.templates_[first - 1] as number) : 0;
    for (let row = first; row < this.length; ++row) {
      const id = ids[row];
      if (id !== undefined && id + 1 > most) {
        most = id + 1;
        this.firstRows[id] = row;
      }
      this.templates_[row] = most;
    }
  }

  private reserve(rows: number): void {
    if (rows <= this.capacity) return;
    while (this.capacity < rows) this.capacity *= 2;
    for (const [name, old] of this.columns) {
      const column = new Float64Array(this.capacity);
      column.set(old);
      this.columns.set(name, column);
    }
    const templates = new Int32Array(this.capacity);
    templates.set(this.templates_);
    this.templates_ = templates;
  }
}

const kNoColumn = new Float64Array();
