// SPDX-License-Identifier: BSD-3-Clause
// The newest experience graph. Experiences and links are numbered in the order of creation, so the
// graph at an earlier frame is a prefix of each list.
import type { GraphMessage } from '../wire/messages';

export class Graph {
  private message: GraphMessage | null = null;
  private loops_ = 0;
  private rejected_ = 0;
  private edition_ = 0;

  get experiences(): number {
    return this.message ? this.message.experience.length / 4 : 0;
  }
  get links(): number {
    return this.message ? this.message.linkKind.length : 0;
  }
  /** Loop links that the map has not rejected. */
  get loops(): number {
    return this.loops_;
  }
  /** Loop links that the map has rejected. */
  get rejected(): number {
    return this.rejected_;
  }
  get version(): number {
    return this.message?.header.version ?? -1;
  }
  get frame(): number {
    return this.message?.header.frame ?? -1;
  }
  /** Changes whenever the content does. */
  get edition(): number {
    return this.edition_;
  }

  replace(message: GraphMessage | null): void {
    if (message && this.message && ageOf(message) < ageOf(this.message)) return; // an older answer
    this.set(message);
  }

  clear(): void {
    this.set(null);
  }

  position(experience: number): readonly [number, number, number] {
    const values = this.message?.experience ?? kNothing;
    const at = 4 * experience;
    return [values[at] ?? NaN, values[at + 1] ?? NaN, values[at + 2] ?? NaN];
  }

  heading(experience: number): number {
    return this.message?.experience[4 * experience + 3] ?? NaN;
  }

  /** Of each loop link its number, its frame, the frames of its ends, and its residual (-1: not known). */
  *loopLinks(): Iterable<readonly [number, number, number, number, number]> {
    const { loop = new Int32Array(), loopResidual = kNothing } = this.message ?? {};
    const at = (i: number) => loop[i] as number;
    for (let i = 0; i < loop.length; i += 4) yield [at(i), at(i + 1), at(i + 2), at(i + 3), loopResidual[i / 4] ?? -1];
  }

  ends(link: number): readonly [number, number] {
    const ends = this.message?.link;
    return [ends?.[2 * link] ?? -1, ends?.[2 * link + 1] ?? -1];
  }

  isLoop(link: number): boolean {
    return this.message?.linkKind[link] === 1;
  }

  isRejected(link: number): boolean {
    return this.message?.linkRejected[link] === 1;
  }

  private set(message: GraphMessage | null): void {
    this.message = message;
    this.rejected_ = message ? message.linkRejected.reduce((n, flag) => n + flag, 0) : 0;
    const kinds = message?.linkKind ?? new Uint8Array();
    this.loops_ = kinds.reduce((n, kind) => n + (kind === 1 ? 1 : 0), 0) - this.rejected_;
    ++this.edition_;
  }
}

const kNothing = new Float32Array();

/** The graph after the last frame has frame -1. */
function ageOf({ header }: GraphMessage): number {
  return header.frame < 0 ? Infinity : header.frame;
}
