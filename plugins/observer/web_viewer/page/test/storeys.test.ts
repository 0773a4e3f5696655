// SPDX-License-Identifier: BSD-3-Clause
import { expect, test } from 'vitest';
import { Graph } from '../src/model/graph';
import { hasStoreys } from '../src/model/storeys';

function graphOf(places: readonly (readonly [number, number, number])[]): Graph {
  const graph = new Graph();
  graph.replace({
    header: { type: 'graph', version: 1, frame: 0 },
    experience: Float32Array.from(places.flatMap(([x, y, z]) => [x, y, z, 0])),
    link: new Int32Array(), linkKind: new Uint8Array(), linkRejected: new Uint8Array(),
    loop: new Int32Array(), loopResidual: new Float32Array(),
  });
  return graph;
}

test('a hill has no storeys, a ramp over its own start has', () => {
  const hill = Array.from({ length: 40 }, (_, i) => [0, -i, 4 * i] as const);
  expect(hasStoreys(graphOf(hill), 1)).toBe(false);
  const spiral = Array.from({ length: 40 }, (_, i) => [12 * Math.cos(i / 4), -i / 8, 12 * Math.sin(i / 4)] as const);
  expect(hasStoreys(graphOf(spiral), 1)).toBe(true);
});

test('heights are told apart in metres, not in units of the map', () => {
  const above = [[0, 0, 0], [0, -1, 0]] as const;
  expect(hasStoreys(graphOf(above), 1)).toBe(false);
  expect(hasStoreys(graphOf(above), 3)).toBe(true);
  expect(hasStoreys(new Graph(), 1)).toBe(false);
});
