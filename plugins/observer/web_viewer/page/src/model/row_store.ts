// SPDX-License-Identifier: BSD-3-Clause
// All history rows, a typed array per column. Blocks may come in any order and overlap; a row
// counts when all rows before it are there, so there are no gaps and no duplicates.
import type { RowBlock } from '../wire/messages';

const kFirstCapacity = 1024;

export class RowStore {
  private columns = new Map<string, Float64Array>();
  private early: RowBlock[] = []; // blocks that wait for rows before them
  private capacity = kFirstCapacity;
  private length = 0;
  /** Greatest template id up to each row, plus one. */
  private templates_ = new Int32Array(kFirstCapacity);
  private firstRows: number[] = []; // row at which each template appeared

  constructor(readonly names: readonly string[]) {
    for (const name of names) this.columns.set(name, new Float64Array(kFirstCapacity));
  }

  get count(): number {
    return this.length;
  }

  /** The first row that is missing although later ones are here, or -1. */
  get gap(): number {
    return this.early.length > 0 ? this.length : -1;
  }

  /** Rows beyond `count` are spare room. */
  column(name: string): Float64Array {
    return this.columns.get(name) ?? kNoColumn;
  }

  /** NaN when there is no such row or column. */
  value(row: number, name: string): number {
    if (row < 0 || row >= this.length) return NaN;
    return this.columns.get(name)?.[row] ?? NaN;
  }

  templates(row: number): number {
    return row >= 0 && row < this.length ? (this.templates_[row] ?? 0) : 0;
  }

  /** The frame at which a template was first seen; NaN when it was not. */
  frameOfTemplate(template: number): number {
    return this.frame(this.firstRows[template] ?? -1);
  }

  frame(row: number): number {
    return this.value(row, 'frame');
  }

  /** The last row whose frame is at or before `frame`; -1 when there is none. */
  rowOfFrame(frame: number): number {
    const frames = this.column('frame');
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
    const ids = this.column('template_id');
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
