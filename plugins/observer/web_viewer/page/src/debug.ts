// SPDX-License-Identifier: BSD-3-Clause
// window.tolman: the state of the page as numbers, for tests. Read-only.
import type { MapPanel } from './panels/map_panel';
import type { PageState } from './model/page_state';

export interface DebugView {
  readonly rows: number;
  readonly newestFrame: number;
  readonly shownFrame: number;
  readonly imageFrame: number;
  readonly mode: string;
  readonly live: boolean;
  readonly graph: { readonly experiences: number; readonly links: number; readonly loops: number; readonly rejected: number; readonly version: number };
  readonly map: { readonly zoom: number; readonly centre: readonly [number, number]; readonly dimension: string; readonly renders: number };
  readonly fps: number;
  readonly dropped: number;
  readonly nodes: number; // elements of the page
  row(index: number): Readonly<Record<string, number>>;
}

declare global {
  interface Window {
    tolman: DebugView;
  }
}

export function publish(state: () => PageState, map: MapPanel, fps: () => number): void {
  const debug: DebugView = {
    get rows() { return state().rows.count; },
    get newestFrame() { return state().rows.frame(state().rows.count - 1); },
    get shownFrame() { return state().frame; },
    get imageFrame() { return state().picture?.frame ?? NaN; },
    get mode() { return state().mode; },
    get live() { return state().live; },
    get graph() {
      const { experiences, links, loops, rejected, version } = state().graph;
      return { experiences, links, loops, rejected, version };
    },
    get map() {
      return { zoom: map.zoom, centre: map.centre, dimension: map.dimension, renders: map.renders };
    },
    get fps() { return fps(); },
    get dropped() { return state().dropped; },
    get nodes() { return document.getElementsByTagName('*').length; },
    row(index) {
      const { rows } = state();
      return Object.fromEntries(rows.names.map((name) => [name, rows.value(index, name)]));
    },
  };
  Object.defineProperty(window, 'tolman', { value: Object.freeze(debug) });
}
