// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { Graph } from '../src/model/graph';
import type { GraphMessage } from '../src/wire/messages';

/** A chain of three experiences with two loop links, of which the map has rejected the second. */
const at = (frame: number, version: number): GraphMessage => ({
  header: { type: 'graph', version, frame },
  experience: new Float32Array(12),
  link: Int32Array.of(0, 1, 1, 2, 2, 0, 2, 1),
  linkKind: Uint8Array.of(0, 0, 1, 1),
  linkRejected: Uint8Array.of(0, 0, 0, 1),
  loop: Int32Array.of(2, 20, 20, 0, 3, 21, 20, 10),
  loopResidual: Float32Array.of(1.5, -1),
});

describe('the graph', () => {
  it('counts rejected loop links apart from the others', () => {
    const graph = new Graph();
    graph.replace(at(20, 1));
    expect([graph.links, graph.loops, graph.rejected]).toEqual([4, 1, 1]);
    expect([graph.isRejected(2), graph.isRejected(3)]).toEqual([false, true]);
    expect([...graph.loopLinks()]).toEqual([[2, 20, 20, 0, 1.5], [3, 21, 20, 10, -1]]);
  });

  it('ignores an older graph, and takes the final one, whose frame is -1', () => {
    const graph = new Graph();
    graph.replace(at(20, 2));
    graph.replace(at(10, 1));
    expect(graph.version).toBe(2);
    graph.replace(at(-1, 3));
    expect(graph.version).toBe(3);
    graph.replace(at(20, 2));
    expect(graph.version).toBe(3);
  });
});
