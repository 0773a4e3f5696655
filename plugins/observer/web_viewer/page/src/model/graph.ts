// SPDX-License-Identifier: BSD-3-Clause
// The newest experience graph, and how much of it stood at a moment. Experiences and links are
// numbered in the order of making, so a moment is a prefix of each list.
import type { GraphMessage } from '../wire/messages';

export class Graph {
  private message: GraphMessage | null = null;
  private loops_ = 0;
  private edition_ = 0;

  get experiences(): number {
    return this.message ? this.message.experience.length / 4 : 0;
  }
  get links(): number {
    return this.message ? this.message.linkKind.length : 0;
  }
  get loops(): number {
    return this.loops_;
  }
  get version(): number {
    return this.message?.version ?? -1;
  }
  get frame(): number {
    return this.message?.frame ?? -1;
  }
  /** Changes whenever the content does. */
  get edition(): number {
    return this.edition_;
  }

  replace(message: GraphMessage | null): void {
    if (message && this.message && message.frame < this.message.frame) return; // an old answer
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

  madeAt(experience: number): number {
    return this.message?.experienceFrame[experience] ?? -1;
  }

  ends(link: number): readonly [number, number] {
    const ends = this.message?.link;
    return [ends?.[2 * link] ?? -1, ends?.[2 * link + 1] ?? -1];
  }

  isLoop(link: number): boolean {
    return this.message?.linkKind[link] === 1;
  }

  private set(message: GraphMessage | null): void {
    this.message = message;
    this.loops_ = message ? message.linkKind.reduce((n, kind) => n + (kind === 1 ? 1 : 0), 0) : 0;
    ++this.edition_;
  }
}

const kNothing = new Float32Array();
