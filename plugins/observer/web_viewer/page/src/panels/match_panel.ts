// SPDX-License-Identifier: BSD-3-Clause
// The current view beside the view that made its template.
import { byId, byTestId, setAttribute, setText, Surface } from '../look/dom';
import { brief, integer, kRecognitionNames, nameOf } from '../look/format';
import type { RowStore } from '../model/row_store';
import type { Panel, Picture, View } from '../model/view';
import { templateAddress } from '../wire/api';

const kLookBack = 40; // rows: recognition need not look at every frame

/** The newest row at or before `row` whose view was judged; -1 when there is none near. */
export function judgedRow(rows: RowStore, row: number): number {
  for (let r = row; r >= 0 && r > row - kLookBack; --r) {
    if (rows.value(r, 'recognition') > 0) return r;
  }
  return -1;
}

export class MatchPanel implements Panel {
  private readonly surface = new Surface(byId<HTMLCanvasElement>('view'));
  private readonly image = byId<HTMLImageElement>('template');
  private readonly empty = byId('template-empty');
  private readonly made = byId('template-made');
  private readonly tag = byId('recognition');
  private readonly texts = {
    frame: byTestId('view-frame'),
    template: byTestId('template'),
    score: byTestId('score'),
  };
  private picture: Picture | null = null;
  // The old picture stays until the new one is here; of quick changes only the newest is fetched.
  private readonly coming = new Image();
  private fetching = -1;
  private wanted = -1;

  constructor() {
    this.coming.onload = () => this.arrived();
    this.coming.onerror = () => this.arrived();
  }

  update(view: View): boolean {
    this.drawView(view);
    const row = judgedRow(view.rows, view.row);
    const template = view.rows.value(row, 'template_id');
    const kind = row < 0 ? 0 : view.rows.value(row, 'recognition');
    setText(this.texts.frame, integer(view.picture?.frame ?? NaN));
    setText(this.texts.template, integer(template >= 0 ? template : NaN));
    setText(this.texts.score, brief(view.rows.value(row, 'score')));
    setText(this.tag, nameOf(kRecognitionNames, kind));
    setAttribute(this.tag, 'data-kind', String(kind));
    setAttribute(this.tag, 'data-frame', integer(view.rows.frame(row)));
    const origin = template >= 0 ? view.rows.frameOfTemplate(template) : NaN;
    setText(this.made, Number.isFinite(origin) ? ` · frame ${origin}` : '');
    this.showTemplate(view.picture !== null && template >= 0 ? template : -1);
    return false;
  }

  private drawView({ picture }: View): void {
    if (!this.surface.fit() && this.picture === picture) return;
    this.picture = picture;
    const context = this.surface.clear();
    if (picture === null) return;
    const { width, height } = picture.bitmap;
    for (const well of [this.surface.canvas, this.image]) {
      well.parentElement?.style.setProperty('--shape', String(width / height));
    }
    const scale = Math.min(this.surface.width / width, this.surface.height / height);
    const [w, h] = [width * scale, height * scale];
    context.imageSmoothingQuality = 'high';
    context.drawImage(
      picture.bitmap, (this.surface.width - w) / 2, (this.surface.height - h) / 2, w, h);
  }

  private showTemplate(template: number): void {
    this.image.hidden = template < 0;
    this.empty.hidden = template >= 0;
    this.wanted = template;
    if (this.fetching < 0) this.fetchWanted();
  }

  private fetchWanted(): void {
    if (this.wanted < 0 || this.image.dataset['template'] === String(this.wanted)) return;
    this.fetching = this.wanted;
    this.coming.src = templateAddress(this.fetching);
  }

  private arrived(): void {
    const sound = this.coming.naturalWidth > 0;
    this.image.dataset['template'] = String(this.fetching);
    if (sound) this.image.src = this.coming.src;
    else this.image.removeAttribute('src');
    this.fetching = -1;
    this.fetchWanted();
  }
}
