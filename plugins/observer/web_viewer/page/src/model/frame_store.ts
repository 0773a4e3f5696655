// SPDX-License-Identifier: BSD-3-Clause
// Past frames from the server. The last few are kept; of several waiting requests only the newest
// is sent.
import type { FrameMessage } from '../wire/messages';

export type FetchFrame = (frame: number) => Promise<FrameMessage | null>;

const kKept = 24;

export class FrameStore {
  private kept = new Map<number, FrameMessage>(); // by asked frame, oldest use first
  private busy = false;
  private next: number | null = null;

  constructor(
    private readonly fetchFrame: FetchFrame,
    private readonly arrived: (asked: number, message: FrameMessage | null) => void,
    private readonly failed: (error: unknown) => void,
  ) {}

  get loading(): boolean {
    return this.busy;
  }

  clear(): void {
    this.kept.clear();
    this.next = null;
  }

  /** A frame that the stream has brought. */
  keep(message: FrameMessage): void {
    if (message.image !== null || message.arrays.length > 0) {
      this.remember(message.header.frame, message);
    }
  }

  want(frame: number): void {
    const known = this.kept.get(frame);
    if (known !== undefined) {
      this.next = null;
      this.remember(frame, known);
      this.arrived(frame, known);
      return;
    }
    this.next = frame;
    if (!this.busy) void this.fetchNext();
  }

  private remember(frame: number, message: FrameMessage): void {
    this.kept.delete(frame);
    this.kept.set(frame, message);
    for (const oldest of this.kept.keys()) {
      if (this.kept.size <= kKept) break;
      this.kept.delete(oldest);
    }
  }

  private async fetchNext(): Promise<void> {
    this.busy = true;
    while (this.next !== null) {
      const asked = this.next;
      this.next = null;
      try {
        const message = await this.fetchFrame(asked);
        if (message !== null) this.remember(asked, message);
        this.arrived(asked, message);
      } catch (error) {
        this.failed(error);
      }
    }
    this.busy = false;
  }
}
