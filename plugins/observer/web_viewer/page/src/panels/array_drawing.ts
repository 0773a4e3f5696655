// SPDX-License-Identifier: BSD-3-Clause
// Arrays of unknown meaning: lines for one axis, a heat map for more.
import { rgbaTable } from '../look/colour_map';
import type { Surface } from '../look/dom';
import type { Colours } from '../look/theme';
import type { OtherArray } from '../model/populations';

const kTable = rgbaTable();
const kMargin = 6; // CSS px

export class ArrayDrawing {
  private readonly small = document.createElement('canvas');

  draw(surface: Surface, array: OtherArray, colours: Colours): void {
    if (array.shape.length <= 1) drawLine(surface, array.values, colours);
    else this.drawHeatMap(surface, array);
  }

  /** Rows downwards, columns to the right; further axes are stacked as rows. */
  private drawHeatMap(surface: Surface, { shape, values }: OtherArray): void {
    const context = surface.clear();
    const columns = shape[shape.length - 1] as number;
    const rows = values.length / columns;
    const image = new ImageData(columns, rows);
    const [least, greatest] = rangeOf(values);
    values.forEach((value, i) => {
      const from = 4 * Math.round((255 * (value - least)) / (greatest - least));
      for (let k = 0; k < 4; ++k) image.data[4 * i + k] = kTable[from + k] as number;
    });
    [this.small.width, this.small.height] = [columns, rows];
    this.small.getContext('2d')?.putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(
      this.small, kMargin, kMargin, surface.width - 2 * kMargin, surface.height - 2 * kMargin);
  }
}

function drawLine(surface: Surface, values: Float32Array, colours: Colours): void {
  const context = surface.clear();
  const [least, greatest] = rangeOf(values);
  const [width, height] = [surface.width - 2 * kMargin, surface.height - 2 * kMargin];
  context.beginPath();
  values.forEach((value, i) => {
    const x = kMargin + (width * (i + 0.5)) / values.length;
    const y = kMargin + height * (1 - (value - least) / (greatest - least));
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.strokeStyle = colours.blue;
  context.lineWidth = 1.5;
  context.stroke();
}

/** Least and greatest value, always different. */
function rangeOf(values: Float32Array): [number, number] {
  const least = values.reduce((a, b) => Math.min(a, b), Infinity);
  const greatest = values.reduce((a, b) => Math.max(a, b), -Infinity);
  return least < greatest ? [least, greatest] : [least - 0.5, least + 0.5];
}
