// SPDX-License-Identifier: BSD-3-Clause
// What the panels draw: the state at one moment, for reading only.
import type { Colours } from '../look/theme';
import type { LinkState } from '../wire/connection';
import type { FrameMessage, RunInfo } from '../wire/messages';
import type { EventLog } from './event_log';
import type { Graph } from './graph';
import type { Mode } from './player';
import type { RowStore } from './row_store';

export interface Picture {
  readonly frame: number;
  readonly bitmap: ImageBitmap;
}

export interface View {
  readonly info: RunInfo | null;
  readonly rows: RowStore;
  readonly row: number; // shown; -1: none
  readonly frame: number; // of that row; NaN: none
  readonly message: FrameMessage | null; // image, points and arrays that are shown
  readonly picture: Picture | null; // the decoded image of `message`
  readonly graph: Graph;
  readonly events: EventLog;
  readonly mode: Mode;
  readonly speed: number;
  readonly live: boolean; // the run goes on
  readonly loading: boolean;
  readonly link: LinkState;
  readonly rate: number; // frames/s that arrive
  readonly dropped: number;
  readonly colours: Colours;
}

/** True when the panel wants to be asked again soon, because it has put work off. */
export type Unfinished = boolean;

export interface Panel {
  update(view: View, now: number): Unfinished;
}

/** At most one go in `interval` ms. */
export class Pace {
  private last = -Infinity;
  constructor(private readonly interval: number) {}

  due(now: number): boolean {
    if (now - this.last < this.interval) return false;
    this.last = now;
    return true;
  }
}
