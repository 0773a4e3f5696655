// SPDX-License-Identifier: BSD-3-Clause
// A sheet of cells, oriented like the map: columns (x, forward at the start) upwards, rows (y) to the
// left. Bumps as circles of one standard deviation; on a periodic sheet they continue at the
// opposite edge.
import { rgbaTable } from '../look/colour_map';
import type { Surface } from '../look/dom';
import { isPeriodic, type Bump, type Population } from '../model/populations';
import { bumpColour } from './bump_colours';
import type { Colours } from '../look/theme';

const kTable = rgbaTable();
export const kMargin = 14; // CSS px, for the labels

/** The sheet as an image; the last unit of each axis is at the top and at the left. */
export function sheetImage({ shape, activity }: Population): ImageData {
  const [rows, columns] = shape as [number, number];
  const image = new ImageData(rows, columns);
  const greatest = activity.reduce((a, b) => Math.max(a, b), 1e-9);
  for (let y = 0; y < rows; ++y) {
    for (let x = 0; x < columns; ++x) {
      const share = Math.max(0, Math.min(1, (activity[y * columns + x] as number) / greatest));
      const from = 4 * Math.round(255 * share);
      const to = 4 * ((columns - 1 - x) * rows + (rows - 1 - y));
      for (let k = 0; k < 4; ++k) image.data[to + k] = kTable[from + k] as number;
    }
  }
  return image;
}

export class SheetDrawing {
  private readonly small = document.createElement('canvas');

  draw(surface: Surface, sheet: Population, colours: Colours): void {
    const context = surface.clear();
    const side = Math.min(surface.width, surface.height) - 2 * kMargin;
    const frame = { left: (surface.width - side) / 2, top: (surface.height - side) / 2, side };
    const image = sheetImage(sheet);
    [this.small.width, this.small.height] = [image.width, image.height];
    this.small.getContext('2d')?.putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.small, frame.left, frame.top, side, side);
    context.save();
    context.beginPath();
    context.rect(frame.left, frame.top, side, side);
    context.clip();
    for (const bump of sheet.bumps) drawBump(context, bump, frame, sheet, colours);
    context.restore();
    labelAxes(context, sheet, frame, colours);
  }
}

interface Square {
  readonly left: number;
  readonly top: number;
  readonly side: number;
}

function drawBump(
  context: CanvasRenderingContext2D,
  bump: Bump,
  { left, top, side }: Square,
  sheet: Population,
  colours: Colours,
): void {
  const [rows, columns] = sheet.shape as [number, number];
  // A unit is drawn as a square centred on its phase.
  const x = left + side * (1 - (bump.mean[0] ?? NaN) - 0.5 / rows);
  const y = top + side * (1 - (bump.mean[1] ?? NaN) - 0.5 / columns);
  const radius = side * Math.min(0.5, Math.max(bump.sigma[0] || 0, bump.sigma[1] || 0));
  const copies = isPeriodic(sheet) ? [-side, 0, side] : [0];
  for (const dx of copies) {
    for (const dy of copies) {
      if (bump.label === 'estimate') drawCross(context, x + dx, y + dy);
      else drawCircle(context, x + dx, y + dy, radius, bump, colours);
    }
  }
}

/** One standard deviation, and a dot at the mean of a hypothesis; faint at low energy. */
function drawCircle(
  context: CanvasRenderingContext2D, x: number, y: number, radius: number, bump: Bump, colours: Colours,
): void {
  context.strokeStyle = context.fillStyle = bumpColour(bump.label, colours);
  context.globalAlpha = 0.35 + 0.65 * bump.weight;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, Math.max(3, radius), 0, 2 * Math.PI);
  context.stroke();
  if (bump.isHypothesis) {
    context.beginPath();
    context.arc(x, y, 2 + 4 * bump.weight, 0, 2 * Math.PI);
    context.fill();
  }
  context.globalAlpha = 1;
}

function drawCross(context: CanvasRenderingContext2D, x: number, y: number): void {
  for (const [colour, width] of [['#000c', 3.5], ['#fff', 1.6]] as const) {
    context.beginPath();
    context.moveTo(x - 6, y);
    context.lineTo(x + 6, y);
    context.moveTo(x, y - 6);
    context.lineTo(x, y + 6);
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke();
  }
}

function labelAxes(
  context: CanvasRenderingContext2D, { info }: Population, { left, top, side }: Square, colours: Colours,
): void {
  context.fillStyle = colours.soft;
  context.font = '10px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(`← ${info.axes[0]?.name ?? ''}`, left + side / 2, top + side + 8);
  context.save();
  context.translate(left - 8, top + side / 2);
  context.rotate(-Math.PI / 2);
  context.fillText(`${info.axes[1]?.name ?? ''} →`, 0, 0);
  context.restore();
}
