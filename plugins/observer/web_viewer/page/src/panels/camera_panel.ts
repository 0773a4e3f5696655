// SPDX-License-Identifier: BSD-3-Clause
// The left image with the points of the odometry, coloured by depth.
import { css, nearness, palette, viridis } from '../look/colour_map';
import { byId, byTestId, make, setText, Surface } from '../look/dom';
import { brief, metres, units } from '../look/format';
import { GrowingDepthRange } from '../model/depth_range';
import type { Panel, DecodedImage, PageState } from '../model/page_state';
import type { FrameMessage } from '../wire/messages';

const kColours = palette(64, 0.12); // without the darkest, which are invisible on a dark image
const kPointSize = 2.4; // CSS px

export class CameraPanel implements Panel {
  private readonly surface = new Surface(byId<HTMLCanvasElement>('camera'));
  private readonly empty = byId('camera-empty');
  private readonly legend = byId('depth');
  private readonly count = byTestId('points');
  private readonly note = byId('points-note');
  private readonly depths = new GrowingDepthRange();
  private picture: DecodedImage | null = null;
  private points: FrameMessage | null = null;

  update(state: PageState): boolean {
    const withPoints = state.message?.points ? state.message : null;
    const resized = this.surface.fit();
    if (!resized && this.picture === state.picture && this.points === withPoints) return false;
    this.picture = state.picture;
    this.points = withPoints;
    this.empty.hidden = state.picture !== null || withPoints !== null;
    if (withPoints?.points) {
      this.depths.include(withPoints.points);
      this.drawLegend(state.rows.value(state.row, 'motion.scale_known') !== 0);
    }
    this.describe(withPoints);
    this.draw(state);
    return false;
  }

  private describe(message: FrameMessage | null): void {
    setText(this.count, message?.points ? String(message.points.length / 4) : '–');
    const other = message !== null && message.header.points_frame !== message.header.frame;
    setText(this.note, other ? ` of frame ${message.header.points_frame}` : '');
  }

  private draw(state: PageState): void {
    const [width, height] = [
      state.info?.source.rig.width || state.picture?.bitmap.width || 0,
      state.info?.source.rig.height || state.picture?.bitmap.height || 0,
    ];
    const context = this.surface.clear();
    if (width === 0 || height === 0) return;
    this.surface.canvas.parentElement?.style.setProperty('--shape', String(width / height));
    const scale = Math.min(this.surface.width / width, this.surface.height / height);
    context.translate(
      (this.surface.width - width * scale) / 2,
      (this.surface.height - height * scale) / 2,
    );
    if (state.picture) {
      context.imageSmoothingQuality = 'high';
      context.drawImage(state.picture.bitmap, 0, 0, width * scale, height * scale);
    }
    this.drawPoints(context, scale);
  }

  private drawPoints(context: CanvasRenderingContext2D, scale: number): void {
    const points = this.points?.points;
    const range = this.depths.range;
    if (!points || range === null) return;
    for (let i = 0; i + 3 < points.length; i += 4) {
      const near = nearness(1 / (points[i + 2] as number), range);
      context.fillStyle = kColours[Math.round(near * (kColours.length - 1))] as string;
      const u = (points[i] as number) * scale - kPointSize / 2;
      const v = (points[i + 1] as number) * scale - kPointSize / 2;
      context.fillRect(u, v, kPointSize, kPointSize);
    }
  }

  private drawLegend(scaleKnown: boolean): void {
    const range = this.depths.range;
    if (range === null) return;
    const key = `${range.near} ${range.far} ${scaleKnown}`;
    if (this.legend.dataset['range'] === key) return;
    this.legend.dataset['range'] = key;
    const stops = [1, 0.75, 0.5, 0.25, 0].map((near) => css(viridis(0.12 + 0.88 * near)));
    this.legend.style.background = `linear-gradient(to right, ${stops.join(', ')})`;
    this.legend.replaceChildren(
      ...thinned(this.depths.ticks()).map((depth, i) => {
        const left = `left: ${(100 * (1 - nearness(depth, range))).toFixed(2)}%`;
        const text = scaleKnown ? metres : i === 0 ? units : brief;
        return make('span', { style: left }, text(depth));
      }),
    );
  }
}

/** At most seven ticks, so that their texts do not overlap. */
function thinned(ticks: number[]): number[] {
  if (ticks.length <= 7) return ticks;
  const step = Math.ceil((ticks.length - 1) / 6);
  return ticks.filter((_, i) => i % step === 0);
}
