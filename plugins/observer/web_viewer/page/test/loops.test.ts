// SPDX-License-Identifier: BSD-3-Clause
// Against runs whose loops are known: 10 m a frame out and back, a template and an experience at each frame.
import { describe, expect, it } from 'vitest';
import { Graph } from '../src/model/graph';
import { loopStories } from '../src/model/loops';
import { RowStore } from '../src/model/row_store';
import { kColumns, type ColumnName } from '../src/wire/records';

type Row = Partial<Record<ColumnName, number>>;

/** Ten frames away from the start, of which the later ones are as given. */
function run(later: Record<number, Row>, frames = 10): RowStore {
  const store = new RowStore(kColumns);
  for (let f = 0; f < frames; ++f) {
    const row: Row = {
      'frame.frame': f, 'motion.scale_known': 1, 'place.recognition': 1, 'place.template_id': f,
      'odometry.x': 0, 'odometry.y': 0, 'odometry.z': 10 * f, 'truth.x': 0, 'truth.y': 0, 'truth.z': 10 * f, ...later[f],
    };
    store.add({ from: f, columns: kColumns.length, values: Float64Array.from(kColumns, (c) => row[c] ?? NaN) });
  }
  return store;
}

/** Links of frame, frames of the ends, residual and whether it is rejected. */
function graphOf(...links: readonly (readonly [number, number, number, number, number])[]): Graph {
  const graph = new Graph();
  graph.replace({
    header: { type: 'graph', version: 1, frame: 9 }, experience: new Float32Array(),
    link: new Int32Array(), linkKind: Uint8Array.from(links, () => 1), linkRejected: Uint8Array.from(links, (l) => l[4]),
    loop: Int32Array.from(links.flatMap(([frame, from, to], i) => [i, frame, from, to])),
    loopResidual: Float32Array.from(links, (l) => l[3]),
  });
  return graph;
}

const candidate = (template: number, score: number, limit: number): Row => ({
  'candidate.template_id': template, 'candidate.score': score, 'candidate.limit': limit, 'candidate.compared': -1,
});
const view = (id: number, fate: number, share: number, views: number): Row => ({
  'hypothesis.id': id, 'hypothesis.fate': fate, 'hypothesis.share': share, 'hypothesis.limit': 0.98, 'hypothesis.views': views,
});

describe('stories of loops', () => {
  it('judges links by the distance of their ends, and by a measured pose where there is one', () => {
    const there = { 'place.recognition': 2, 'truth.z': 4 };
    const rows = run({
      7: { ...there, 'place.template_id': 0, ...candidate(0, 0.1, 0.3) },
      8: { ...there, 'place.template_id': 1, 'measured.error': 3, 'measured.sigmas': 7 },
    });
    const stories = loopStories(rows, graphOf([7, 7, 0, 0.5, 0], [8, 8, 0, 1.5, 0], [9, 9, 0, 6, 1]));
    expect(stories.map((s) => [s.frame, s.earlier, s.ending, s.isTrue])).toEqual([
      [7, 0, 'kept', true], [8, 0, 'kept', false], [9, 0, 'rejected', false],
    ]);
    expect(stories.map((s) => s.text)).toEqual([
      'score 0.1 (limit 0.3) · 0.50 σ from the map · true: ends are 4.00 m apart',
      '1.50 σ from the map · FALSE: its pose is 3.00 m off',
      '6.00 σ from the map, too far for its robust loss · FALSE: ends are 90.0 m apart',
    ]);
  });

  it('says what a hypothesis reached and how it ended', () => {
    const rows = run({ 4: view(0, 0, 0.5, 1), 5: view(0, 1, 0.7, 2), 6: view(1, 2, 0.99, 3),
                       7: { ...view(0, 3, 0.2, 2), 'hypothesis.unsupported': 12 } });
    const stories = loopStories(rows, graphOf());
    expect(stories.map((s) => [s.frame, s.ending, s.text])).toEqual([
      [5, 'not accepted by the cells', 'share 0.7 (limit 0.98) · 2 views · died 12.0 m after its last view'],
    ]);
  });

  it('lists the nearest of neighbouring candidates, and none that was just driven', () => {
    const rows = run({ 3: candidate(2, 0.31, 0.3), 6: candidate(0, 0.4, 0.3), 7: candidate(1, 0.35, 0.3), 8: candidate(0, 0.5, 0.3) });
    expect(loopStories(rows, graphOf()).map((s) => [s.frame, s.earlier, s.ending, s.text])).toEqual([
      [7, 1, 'not recognised', 'score 0.35 (limit 0.3) · above its limit'],
    ]);
  });

  it('does not call a link true or false without truth', () => {
    const rows = run({ 7: { 'truth.x': NaN } });
    expect(loopStories(rows, graphOf([7, 7, 0, -1, 0])).map((s) => [s.isTrue, s.text])).toEqual([[null, '']]);
  });
});
