// SPDX-License-Identifier: BSD-3-Clause
// What the panels draw: the run at the shown frame. Read-only.
import type { Colours } from '../look/theme';
import type { LinkState } from '../wire/connection';
import type { FrameMessage } from '../wire/messages';
import type { RunInfo } from '../wire/records';
import type { EventLog } from './event_log';
import type { Graph } from './graph';
import type { Mode } from './player';
import type { RowStore } from './row_store';

export interface DecodedImage {
  readonly frame: number;
  readonly bitmap: ImageBitmap;
}

export interface PageState {
  readonly info: RunInfo | null;
  readonly rows: RowStore;
  readonly row: number; // shown; -1: none
  readonly frame: number; // of that row; NaN: none
  readonly message: FrameMessage | null; // its image, points and arrays are shown
  readonly picture: DecodedImage | null; // the decoded image of `message`
  readonly graph: Graph;
  readonly events: EventLog;
  readonly mode: Mode;
  readonly speed: number;
  readonly live: boolean; // the run is not over
  readonly loading: boolean; // the past is still coming
  readonly recorded: boolean; // the run had ended before it was shown
  readonly link: LinkState;
  readonly rate: number; // frames/s received
  readonly dropped: number;
  readonly colours: Colours;
}

/** True when the panel has put work off and must be updated again soon. */
export type Unfinished = boolean;

export interface Panel {
  update(state: PageState, now: number): Unfinished;
}

/** Limits work to once in `interval` ms. */
export class Pace {
  private last = -Infinity;
  constructor(private readonly interval: number) {}

  due(now: number): boolean {
    if (now - this.last < this.interval) return false;
    this.last = now;
    return true;
  }
}
