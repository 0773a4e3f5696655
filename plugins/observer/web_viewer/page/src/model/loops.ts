// SPDX-License-Identifier: BSD-3-Clause
// Loops and near misses from rows and graph, as `tolman explain` lists them. The height of storeys, a setting
// of the evaluation, is not known here.
import { brief } from '../look/format';
import { kChoices, type ColumnName } from '../wire/records';
import type { Graph } from './graph';
import type { RowStore } from './row_store';

const kEndings = ['kept', 'rejected', 'not accepted by the cells', 'not recognised'] as const;
export interface LoopStory {
  readonly frame: number;
  readonly earlier: number; // -1: not known
  readonly ending: (typeof kEndings)[number];
  readonly isTrue: boolean | null; // null: no truth, or no link
  readonly distance: number; // smaller: nearer to being a loop
  readonly text: string; // numbers beside their limits, and the reason
}

/** A hypothesis of the cells: rows of its largest share, its last view and its last change. */
interface Life { best: number; view: number; end: number }

const kNearShare = 0.01; // hypotheses that stay below were never near
const kNearScore = 1.5; // of the limit
const kSameView = 20; // frames: further candidates within tell the same story
const kJustDriven = 20; // m
const kJustDrivenShare = 0.04; // of the path, where its scale is unknown
// Of a link: off by more than metres and sigmas, or by more than `apart`, is false.
const kWrong = { metres: 1, sigmas: 5, apart: 10 };
const kFamiliar = kChoices['place.recognition'].indexOf('familiar');
const kAccepted = kChoices['hypothesis.fate'].indexOf('accepted');

class Stories {
  private readonly driven: Float64Array; // up to each row
  private readonly lives = new Map<number, Life>();
  private readonly supported = new Map<number, Life>(); // by row

  constructor(private readonly rows: RowStore, private readonly graph: Graph) {
    this.driven = new Float64Array(rows.count);
    const columns = (['odometry.x', 'odometry.y', 'odometry.z', 'hypothesis.id'] as const).map((name) => rows.column(name));
    const [x, y, z, ids] = columns as [Float64Array, Float64Array, Float64Array, Float64Array];
    for (let row = 0; row < rows.count; ++row) {
      const change = (axis: Float64Array) => (axis[row] as number) - (axis[row - 1] ?? NaN);
      const step = Math.hypot(change(x), change(y), change(z));
      this.driven[row] = (this.driven[row - 1] ?? 0) + (Number.isFinite(step) ? step : 0);
      const id = ids[row] as number;
      if (id >= 0) this.follow(row, this.lives.get(id) ?? { best: row, view: -1, end: row }, id);
    }
  }

  all(): LoopStory[] {
    const stories = [...this.links(), ...this.undecided(), ...this.unfamiliar()];
    const rank = ({ ending }: LoopStory) => kEndings.indexOf(ending);
    return stories.sort((a, b) => rank(a) - rank(b) || a.distance - b.distance);
  }

  private at(row: number, column: ColumnName): number {
    return this.rows.value(row, column);
  }
  private apart(a: number, b: number): number {
    return Math.hypot(...(['truth.x', 'truth.y', 'truth.z'] as const).map((name) => this.at(a, name) - this.at(b, name)));
  }

  private follow(row: number, life: Life, id: number): void {
    this.lives.set(id, life);
    life.end = row;
    if (this.at(row, 'hypothesis.share') >= this.at(life.best, 'hypothesis.share')) life.best = row;
    if (this.at(row, 'hypothesis.fate') > kAccepted) return; // not by a view
    life.view = row;
    this.supported.set(row, life);
  }

  private story(row: number, ending: LoopStory['ending'], distance: number, reason: string, life = this.supported.get(row)): LoopStory {
    const [frame, familiar] = [this.rows.frame(row), this.at(row, 'place.recognition') === kFamiliar];
    const made = this.rows.frameOfTemplate(this.at(row, familiar ? 'place.template_id' : 'candidate.template_id'));
    const short = (value: number) => Number(value.toPrecision(3));
    const beside = (name: string, value: number, limit: number) => (Number.isFinite(value + limit) ? `${name} ${short(value)} (limit ${short(limit)})` : '');
    const [agreeing, compared] = [this.at(row, 'candidate.agreeing'), this.at(row, 'candidate.compared')];
    const views = life ? this.at(life.best, 'hypothesis.views') : 0;
    const parts = [
      beside('score', this.at(row, 'candidate.score'), this.at(row, 'candidate.limit')),
      compared >= 0 ? `${agreeing} of ${compared} landmarks agree (needs ${this.at(row, 'candidate.needed')})` : '',
      life ? beside('share', this.at(life.best, 'hypothesis.share'), this.at(life.best, 'hypothesis.limit')) : '',
      views > 0 ? `${views} view${views === 1 ? '' : 's'}` : '', reason,
    ];
    return { frame, earlier: made < frame ? made : -1, ending, isTrue: null, distance, text: parts.filter(Boolean).join(' · ') };
  }

  private *links(): Iterable<LoopStory> {
    for (const [link, frame, from, to, residual] of this.graph.loopLinks()) {
      const row = this.rows.rowOfFrame(frame);
      const [a, b] = [this.rows.rowOfFrame(from), this.rows.rowOfFrame(to)];
      const known = this.rows.frame(a) === from && this.rows.frame(b) === to;
      const [error, apart] = [this.at(row, 'measured.error'), known ? this.apart(a, b) : NaN];
      const wrong = error > kWrong.metres && this.at(row, 'measured.sigmas') > kWrong.sigmas;
      const off = Number.isFinite(error) ? error : apart;
      const isTrue = Number.isFinite(off) ? !wrong && off <= kWrong.apart : null;
      const rejected = this.graph.isRejected(link);
      const reasons = [
        residual < 0 ? '' : `${brief(residual)} σ from the map${rejected ? ', too far for its robust loss' : ''}`,
        isTrue === null ? '' : `${isTrue ? 'true' : 'FALSE'}: ${off === error ? 'its pose is' : 'ends are'} ${brief(off)} m ${off === error ? 'off' : 'apart'}`,
      ];
      const story = this.story(row, rejected ? 'rejected' : 'kept', residual, reasons.filter(Boolean).join(' · '));
      yield { ...story, frame, earlier: Math.min(from, to), isTrue };
    }
  }

  /** Hypotheses that were not accepted. */
  private *undecided(): Iterable<LoopStory> {
    for (const life of this.lives.values()) {
      const [share, fate] = [this.at(life.best, 'hypothesis.share'), this.at(life.end, 'hypothesis.fate')];
      if (fate === kAccepted || share < kNearShare || life.view < 0) continue;
      const unit = this.at(life.end, 'motion.scale_known') === 0 ? 'units' : 'm';
      const died = `died ${brief(this.at(life.end, 'hypothesis.unsupported'))} ${unit} after its last view`;
      const reason = { faded: died, displaced: 'gave way to a stronger one' }[kChoices['hypothesis.fate'][fate] as string];
      yield this.story(life.view, 'not accepted by the cells', -share, reason ?? 'its share stayed too small', life);
    }
  }

  /** Of candidates near each other only the one that is nearest to its limit, and none on the path just driven. */
  private unfamiliar(): LoopStory[] {
    const stories: LoopStory[] = [];
    const { rows, driven } = this;
    const inMetres = this.at(rows.count - 1, 'motion.scale_known') !== 0;
    const justDriven = inMetres ? kJustDriven : kJustDrivenShare * (driven.at(-1) ?? 0);
    const kinds = rows.column('place.recognition');
    for (let row = 0; row < rows.count; ++row) {
      if (kinds[row] === kFamiliar) continue;
      const [score, limit, compared] = [this.at(row, 'candidate.score'), this.at(row, 'candidate.limit'), this.at(row, 'candidate.compared')];
      const near = compared >= 0 || score <= kNearScore * limit;
      if (!near || this.supported.has(row)) continue;
      const found = this.story(row, 'not recognised', score, compared >= 0 ? '' : score > limit ? 'above its limit' : 'no answer, though within its limit');
      const back = (driven[row] as number) - (driven[rows.rowOfFrame(found.earlier)] ?? Infinity);
      const last = stories.at(-1);
      const same = last !== undefined && found.frame - last.frame <= kSameView;
      if (!(back >= justDriven) || (same && score >= last.distance)) continue;
      if (same) stories.pop();
      stories.push(found);
    }
    return stories;
  }
}

/** Kept and rejected links, then near misses of the cells and of places; of each kind the nearest to its limit first. */
export function loopStories(rows: RowStore, graph: Graph): LoopStory[] {
  return new Stories(rows, graph).all();
}
