// SPDX-License-Identifier: BSD-3-Clause
// A periodic sheet of grid cells, laid as the map is: x (forward at the start) up, y to the left.
// Bumps as circles of one standard deviation, drawn again where they cross the seam.
import { rgbaTable } from '../look/colour_map';
import type { Surface } from '../look/dom';
import type { Bump, Population } from '../model/cell_modules';
import { bumpColours } from './bump_look';
import type { Colours } from '../look/theme';

const kTable = rgbaTable();
export const kMargin = 14; // CSS px, for the labels

/** The sheet as an image: row 0 at the top is the greatest x, column 0 the greatest y. */
export function sheetImage({ shape, activity }: Population): ImageData {
  const [rows, columns] = shape as [number, number];
  const image = new ImageData(rows, columns);
  const most = activity.reduce((a, b) => Math.max(a, b), 1e-9);
  for (let y = 0; y < rows; ++y) {
    for (let x = 0; x < columns; ++x) {
      const share = Math.max(0, Math.min(1, (activity[y * columns + x] as number) / most));
      const from = 4 * Math.round(255 * share);
      const to = 4 * ((columns - 1 - x) * rows + (rows - 1 - y));
      for (let k = 0; k < 4; ++k) image.data[to + k] = kTable[from + k] as number;
    }
  }
  return image;
}

export class SheetDrawing {
  private readonly small = document.createElement('canvas');

  /** `period` in the unit of the bumps; NaN when not known yet. */
  draw(surface: Surface, sheet: Population, period: number, colours: Colours): void {
    const context = surface.clear();
    const side = Math.min(surface.width, surface.height) - 2 * kMargin;
    const left = (surface.width - side) / 2;
    const top = (surface.height - side) / 2;
    const image = sheetImage(sheet);
    [this.small.width, this.small.height] = [image.width, image.height];
    this.small.getContext('2d')?.putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.small, left, top, side, side);
    context.save();
    context.beginPath();
    context.rect(left, top, side, side);
    context.clip();
    for (const bump of sheet.bumps) drawBump(context, bump, { left, top, side, period }, sheet, colours);
    context.restore();
    label(context, left, top, side, colours);
  }
}

interface Frame {
  readonly left: number;
  readonly top: number;
  readonly side: number;
  readonly period: number;
}

function drawBump(
  context: CanvasRenderingContext2D,
  bump: Bump,
  { left, top, side, period }: Frame,
  { shape }: Population,
  colours: Colours,
): void {
  if (!Number.isFinite(period) || bump.precision <= 0) return;
  const half = 0.5 / (shape[1] as number); // a unit is drawn as a square round its phase
  const right = left + side * (1 - (bump.mean[1] ?? NaN) / period - half);
  const down = top + side * (1 - (bump.mean[0] ?? NaN) / period - half);
  const radius = Math.min(side / 2, side / (period * Math.sqrt(bump.precision)));
  for (const dx of [-side, 0, side]) {
    for (const dy of [-side, 0, side]) {
      if (bump.kind === 'estimate') drawCross(context, right + dx, down + dy);
      else drawCircle(context, right + dx, down + dy, radius, bumpColours(colours)[bump.kind]);
    }
  }
}

function drawCircle(
  context: CanvasRenderingContext2D, x: number, y: number, radius: number, colour: string,
): void {
  context.beginPath();
  context.arc(x, y, Math.max(3, radius), 0, 2 * Math.PI);
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
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

function label(
  context: CanvasRenderingContext2D, left: number, top: number, side: number, colours: Colours,
): void {
  context.fillStyle = colours.soft;
  context.font = '10px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText('← y', left + side / 2, top + side + 8);
  context.save();
  context.translate(left - 8, top + side / 2);
  context.rotate(-Math.PI / 2);
  context.fillText('x →', 0, 0);
  context.restore();
}
