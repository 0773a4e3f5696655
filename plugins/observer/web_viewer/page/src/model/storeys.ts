// SPDX-License-Identifier: BSD-3-Clause
// Whether a map has storeys: places that lie above each other.
import type { Graph } from './graph';

const kCell = 3; // m, side of the squares of the plane within which places lie above each other
export const kStorey = 2; // m, least height between two storeys

/** `scale`: metres in one unit of the graph. */
export function hasStoreys(graph: Graph, scale: number): boolean {
  const lowest = new Map<string, number>();
  const highest = new Map<string, number>();
  for (let i = 0; i < graph.experiences; ++i) {
    const [x, y, z] = graph.position(i).map((value) => scale * value) as [number, number, number];
    const cell = `${Math.floor(x / kCell)} ${Math.floor(z / kCell)}`;
    lowest.set(cell, Math.min(lowest.get(cell) ?? y, y));
    highest.set(cell, Math.max(highest.get(cell) ?? y, y));
    if ((highest.get(cell) as number) - (lowest.get(cell) as number) >= kStorey) return true;
  }
  return false;
}
