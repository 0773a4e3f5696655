// SPDX-License-Identifier: BSD-3-Clause
// Parts that the plots share: axes in the colours of the page, a line at the shown frame.
import type uPlot from 'uplot';
import { make } from '../look/dom';
import type { Colours } from '../look/theme';

const kFont = '10.5px system-ui, sans-serif';

export function axis(label: string, size: number, colours: () => Colours): uPlot.Axis {
  return {
    label,
    labelSize: 15,
    labelGap: 0,
    labelFont: kFont,
    font: kFont,
    size,
    gap: 3,
    stroke: () => colours().soft,
    grid: { stroke: () => colours().line, width: 1 },
    ticks: { stroke: () => colours().line, width: 1, size: 4 },
  };
}

/** Hides the canvas from screen readers; the element around it has the label. */
export function hideCanvas(plot: uPlot): void {
  plot.ctx.canvas.setAttribute('aria-hidden', 'true');
}

/** A vertical line over the plot at a value of x. */
export class NowLine {
  private readonly line = make('div', { class: 'now' });

  constructor(private readonly plot: uPlot) {
    hideCanvas(plot);
    plot.over.append(this.line);
  }

  at(x: number): void {
    const left = this.plot.valToPos(x, 'x');
    const inside = Number.isFinite(left) && left >= 0 && left <= this.plot.over.clientWidth;
    this.line.hidden = !inside;
    if (inside) this.line.style.transform = `translateX(${left.toFixed(1)}px)`;
  }
}

/** Fits the plot to its element. True when the size has changed. */
export function fitPlot(plot: uPlot, root: HTMLElement): boolean {
  const [width, height] = [root.clientWidth, root.clientHeight];
  if (width === 0 || height === 0 || (plot.width === width && plot.height === height)) return false;
  plot.setSize({ width, height });
  return true;
}

/** Calls back with the x value of a click; drags are ignored. */
export function onClick(plot: uPlot, clicked: (x: number) => void): void {
  plot.over.addEventListener('click', (event) => {
    clicked(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  });
}
