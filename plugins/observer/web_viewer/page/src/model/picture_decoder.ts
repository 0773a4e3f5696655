// SPDX-License-Identifier: BSD-3-Clause
// JPEG to bitmap, off the main thread; of quick requests only the newest is decoded.
import type { FrameMessage } from '../wire/messages';
import type { Picture } from './view';

export class PictureDecoder {
  private shown: Picture | null = null;
  private next: FrameMessage | null = null;
  private busy = false;

  constructor(private readonly changed: () => void) {}

  get picture(): Picture | null {
    return this.shown;
  }

  clear(): void {
    this.next = null;
    this.shown?.bitmap.close();
    this.shown = null;
  }

  /** A picture of a later frame does not stand for this one. */
  dropAfter(frame: number): void {
    if ((this.shown?.frame ?? frame) > frame) this.clear();
  }

  /** A message without image leaves the last picture standing. */
  decode(message: FrameMessage): void {
    if (message.image === null || message.frame === this.shown?.frame) return;
    this.next = message;
    if (!this.busy) void this.work();
  }

  private async work(): Promise<void> {
    this.busy = true;
    while (this.next?.image) {
      const { image, frame }: FrameMessage = this.next;
      this.next = null;
      // A copy: a view into the message may not be handed over.
      const blob = new Blob([image.slice()], { type: 'image/jpeg' });
      const bitmap = await createImageBitmap(blob).catch(() => null);
      if (bitmap === null) continue;
      this.shown?.bitmap.close();
      this.shown = { frame, bitmap };
      this.changed();
    }
    this.busy = false;
  }
}
