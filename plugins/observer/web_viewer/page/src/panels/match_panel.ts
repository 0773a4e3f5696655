// SPDX-License-Identifier: BSD-3-Clause
// The current view beside the view that its template was made of.
import { byId, byTestId, setAttribute, setText, Surface } from '../look/dom';
import { brief, integer, choiceName } from '../look/format';
import type { RowStore } from '../model/row_store';
import type { Panel, DecodedImage, PageState } from '../model/page_state';
import { templateAddress } from '../wire/api';
import { kChoices } from '../wire/records';

const kLookBack = 40; // rows; place recognition may skip frames

/** The newest row up to `row` with a template; -1 when there is none within kLookBack rows. */
export function judgedRow(rows: RowStore, row: number): number {
  for (let r = row; r >= 0 && r > row - kLookBack; --r) {
    if (rows.value(r, 'place.recognition') > 0) return r;
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
  private picture: DecodedImage | null = null;
  /** At this frame, if it is not familiar, the template is that of its best candidate. */
  candidateAt = -1;
  // The old image stays until the new one has arrived; only the newest template is fetched.
  private readonly coming = new Image();
  private fetching = -1;
  private wanted = -1;

  constructor() {
    this.coming.onload = () => this.arrived();
    this.coming.onerror = () => this.arrived();
  }

  update(state: PageState): boolean {
    this.drawView(state);
    const row = judgedRow(state.rows, state.row);
    const kind = row < 0 ? 0 : state.rows.value(row, 'place.recognition');
    const missed = state.frame === this.candidateAt && kChoices['place.recognition'][kind] !== 'familiar';
    const template = state.rows.value(missed ? state.row : row, missed ? 'candidate.template_id' : 'place.template_id');
    setText(this.texts.frame, integer(state.picture?.frame ?? NaN));
    setText(this.texts.template, integer(template >= 0 ? template : NaN));
    setText(this.texts.score, brief(state.rows.value(row, 'place.score')));
    setText(this.tag, choiceName('place.recognition', kind));
    setAttribute(this.tag, 'data-kind', String(kind));
    setAttribute(this.tag, 'data-frame', integer(state.rows.frame(row)));
    const origin = template >= 0 ? state.rows.frameOfTemplate(template) : NaN;
    setText(this.made, Number.isFinite(origin) ? ` · frame ${origin}` : '');
    this.showTemplate(state.picture !== null && template >= 0 ? template : -1);
    return false;
  }

  private drawView({ picture }: PageState): void {
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
