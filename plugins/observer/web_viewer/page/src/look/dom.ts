// SPDX-License-Identifier: BSD-3-Clause
// Access to the elements of index.html.

export function byId<T extends Element = HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`no element #${id}`);
  return element as Element as T;
}

export function byTestId(name: string): HTMLElement {
  const element = document.querySelector<HTMLElement>(`[data-testid="${name}"]`);
  if (element === null) throw new Error(`no element for ${name}`);
  return element;
}

/** Changes the document only when the text differs. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function setAttribute(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Readonly<Record<string, string>> = {},
  text = '',
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text !== '') element.textContent = text;
  return element;
}

/** A canvas with the resolution of the screen, drawn in CSS pixels. */
export class Surface {
  readonly context: CanvasRenderingContext2D;
  width = 0; // CSS px
  height = 0;

  constructor(readonly canvas: HTMLCanvasElement) {
    const context = canvas.getContext('2d');
    if (context === null) throw new Error('no 2-D canvas');
    this.context = context;
  }

  /** Adapts to the size on the screen. True when it has changed. */
  fit(): boolean {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const scale = window.devicePixelRatio;
    const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
    if (this.canvas.width === w && this.canvas.height === h) return false;
    [this.canvas.width, this.canvas.height] = [w, h];
    [this.width, this.height] = [width, height];
    return true;
  }

  clear(): CanvasRenderingContext2D {
    const scale = window.devicePixelRatio;
    this.context.setTransform(scale, 0, 0, scale, 0, 0);
    this.context.clearRect(0, 0, this.width, this.height);
    return this.context;
  }
}
