// SPDX-License-Identifier: BSD-3-Clause
// Decodes JPEG images outside the main thread. Of several waiting images only the newest is decoded.
import type { FrameMessage } from '../wire/messages';
import type { DecodedImage } from './page_state';

export class ImageDecoder {
  private shown: DecodedImage | null = null;
  private next: FrameMessage | null = null;
  private busy = false;

  constructor(private readonly changed: () => void) {}

  get picture(): DecodedImage | null {
    return this.shown;
  }

  clear(): void {
    this.next = null;
    this.shown?.bitmap.close();
    this.shown = null;
  }

  /** Forgets the image if it is of a later frame. */
  dropAfter(frame: number): void {
    if ((this.shown?.frame ?? frame) > frame) this.clear();
  }

  /** After a message without image the last image remains. */
  decode(message: FrameMessage): void {
    if (message.image === null || message.header.frame === this.shown?.frame) return;
    this.next = message;
    if (!this.busy) void this.work();
  }

  private async work(): Promise<void> {
    this.busy = true;
    while (this.next?.image) {
      const { image, header }: FrameMessage = this.next;
      this.next = null;
      // A copy, because the bytes are a view into the whole message.
      const blob = new Blob([image.slice()], { type: 'image/jpeg' });
      const bitmap = await createImageBitmap(blob).catch(() => null);
      if (bitmap === null) continue;
      this.shown?.bitmap.close();
      this.shown = { frame: header.frame, bitmap };
      this.changed();
    }
    this.busy = false;
  }
}
