// SPDX-License-Identifier: BSD-3-Clause
// The neural populations: a tile for each ring and each sheet, whatever the plugin calls them.
import { byId, make, setAttribute, setText, Surface } from '../look/dom';
import { brief, degrees } from '../look/format';
import { kBumpKinds, PeriodFinder, sortCells, type CellModules, type Population } from '../model/cell_modules';
import type { Panel, View } from '../model/view';
import type { FrameMessage } from '../wire/messages';
import type { Colours } from '../look/theme';
import { bumpColours } from './bump_look';
import { drawRing } from './ring_drawing';
import { SheetDrawing } from './sheet_drawing';
import { TorusScene } from './torus_scene';

interface Tile {
  readonly surface: Surface;
  readonly caption: HTMLElement;
  readonly finder: PeriodFinder;
  readonly sheet: SheetDrawing;
}

export class CellsPanel implements Panel {
  private readonly root = byId('cells');
  private readonly empty = byId('cells-empty');
  private readonly legend = byId('bumps');
  private readonly button = byId<HTMLButtonElement>('torus');
  private readonly torus: TorusScene;
  private tiles: Tile[] = [];
  private layout = '';
  private message: FrameMessage | null = null;
  private colours: Colours | null = null;
  private asTorus = false;

  constructor(private readonly changed: () => void) {
    this.torus = new TorusScene(changed);
    this.button.onclick = () => this.toggleTorus();
  }

  toggleTorus(): void {
    if (!this.torus.possible) return;
    this.asTorus = !this.asTorus;
    setAttribute(this.button, 'aria-pressed', String(this.asTorus));
    this.message = null;
    this.layout = '';
    this.changed();
  }

  update(view: View): boolean {
    const message = view.message?.cells.length ? view.message : null;
    let resized = this.torus.moved;
    for (const tile of this.tiles) resized = tile.surface.fit() || resized;
    const same = message === this.message && view.colours === this.colours;
    if (same && !resized) return false;
    if (view.colours !== this.colours) this.drawLegend(view.colours);
    this.message = message;
    this.colours = view.colours;
    const modules = sortCells(message?.cells ?? []);
    this.arrange(modules);
    [...modules.rings, ...modules.sheets].forEach((population, i) => {
      this.draw(this.tiles[i] as Tile, population, view.colours);
    });
    return false;
  }

  /** One tile each, made anew only when the populations are others. */
  private arrange({ rings, sheets }: CellModules): void {
    const all = [...rings, ...sheets];
    const layout = all.map((p) => `${p.module}:${p.shape.join('x')}`).join() + this.asTorus;
    if (layout === this.layout) return;
    this.layout = layout;
    this.empty.hidden = all.length > 0;
    this.button.hidden = sheets.length === 0 || !this.torus.possible;
    this.legend.hidden = all.every((p) => p.bumps.length === 0);
    this.root.replaceChildren();
    this.tiles = all.map((p) => this.makeTile(p));
    const first = this.tiles[rings.length];
    if (this.asTorus && first) this.torus.attach(first.surface.canvas);
    else this.torus.detach();
  }

  private makeTile({ module, shape }: Population): Tile {
    const what = shape.length === 1 ? 'ring' : 'sheet';
    const label = `Activity of ${module}, ${what} of ${shape.join(' × ')} cells`;
    const canvas = make('canvas', { role: 'img', 'aria-label': label });
    const caption = make('figcaption', { 'data-testid': `cells-${module}` });
    const figure = make('figure');
    figure.append(canvas, caption);
    this.root.append(figure);
    const surface = new Surface(canvas);
    surface.fit();
    return { surface, caption, finder: new PeriodFinder(), sheet: new SheetDrawing() };
  }

  private draw(tile: Tile, population: Population, colours: Colours): void {
    tile.finder.note(population);
    if (population.shape.length === 1) drawRing(tile.surface, population, colours);
    else if (this.torus.isOn(tile.surface.canvas)) this.torus.draw(tile.surface, population, colours);
    else tile.sheet.draw(tile.surface, population, tile.finder.period, colours);
    setText(tile.caption, captionOf(population));
    setAttribute(tile.caption, 'data-peak', String(peakOf(population.activity)));
  }

  private drawLegend(colours: Colours): void {
    const look = bumpColours(colours);
    this.legend.replaceChildren(
      ...kBumpKinds.map((kind) => {
        const item = make('li');
        item.append(make('i', { class: 'swatch', style: `--swatch: ${look[kind]}` }), kind);
        return item;
      }),
    );
  }
}

function peakOf(activity: Float32Array): number {
  let best = 0;
  for (let i = 1; i < activity.length; ++i) {
    if ((activity[i] as number) > (activity[best] as number)) best = i;
  }
  return best;
}

function captionOf({ module, shape, bumps, inUnits, activity }: Population): string {
  const mean = bumps.find((b) => b.kind === 'estimate')?.mean;
  if (mean === undefined) return module;
  if (shape.length === 1) {
    const units = inUnits ? (2 * Math.PI) / activity.length : 1;
    return `${module} ${degrees((mean[0] ?? NaN) * units)}`;
  }
  return `${module} (${brief(mean[0] ?? NaN)}, ${brief(mean[1] ?? NaN)}) cells`;
}
