// SPDX-License-Identifier: BSD-3-Clause
// window.tolman: the state as numbers, for tests and for the curious. For reading only.
import type { MapPanel } from './panels/map_panel';
import type { View } from './model/view';

export interface DebugView {
  readonly rows: number;
  readonly newestFrame: number;
  readonly shownFrame: number;
  readonly imageFrame: number;
  readonly mode: string;
  readonly live: boolean;
  readonly graph: { readonly experiences: number; readonly links: number; readonly loops: number; readonly version: number };
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

export function publish(view: () => View, map: MapPanel, fps: () => number): void {
  const debug: DebugView = {
    get rows() { return view().rows.count; },
    get newestFrame() { return view().rows.frame(view().rows.count - 1); },
    get shownFrame() { return view().frame; },
    get imageFrame() { return view().picture?.frame ?? NaN; },
    get mode() { return view().mode; },
    get live() { return view().live; },
    get graph() {
      const { experiences, links, loops, version } = view().graph;
      return { experiences, links, loops, version };
    },
    get map() {
      return { zoom: map.zoom, centre: map.centre, dimension: map.dimension, renders: map.renders };
    },
    get fps() { return fps(); },
    get dropped() { return view().dropped; },
    get nodes() { return document.getElementsByTagName('*').length; },
    row(index) {
      const { rows } = view();
      return Object.fromEntries(rows.names.map((name) => [name, rows.value(index, name)]));
    },
  };
  Object.defineProperty(window, 'tolman', { value: Object.freeze(debug) });
}
