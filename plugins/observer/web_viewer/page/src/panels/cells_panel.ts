// SPDX-License-Identifier: BSD-3-Clause
// The arrays of the cells: a tile for each population (ring or sheet) and each other array.
import { byId, make, setAttribute, setText, Surface } from '../look/dom';
import { brief, degrees } from '../look/format';
import { isPeriodic, meanInUnits, sortArrays } from '../model/populations';
import type { Bump, OtherArray, Population, SortedArrays } from '../model/populations';
import type { Panel, PageState } from '../model/page_state';
import type { FrameMessage } from '../wire/messages';
import type { ArrayInfo } from '../wire/records';
import type { Colours } from '../look/theme';
import { ArrayDrawing } from './array_drawing';
import { bumpColour } from './bump_colours';
import { drawRing } from './ring_drawing';
import { SheetDrawing } from './sheet_drawing';
import { TorusScene } from './torus_scene';

const kListed = 8; // values; longer arrays are drawn

interface Tile {
  readonly surface: Surface | null; // null: the values are listed as text
  readonly caption: HTMLElement;
  readonly sheet: SheetDrawing;
  readonly array: ArrayDrawing;
}

export class CellsPanel implements Panel {
  private readonly root = byId('cells');
  private readonly listed = byId('cells-listed');
  private readonly empty = byId('cells-empty');
  private readonly legend = byId('bumps');
  private readonly button = byId<HTMLButtonElement>('torus');
  private readonly torus: TorusScene;
  private tiles: Tile[] = [];
  private layout = '';
  private labels = '';
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

  update(state: PageState): boolean {
    const message = state.message?.arrays.length ? state.message : null;
    let resized = this.torus.moved;
    for (const tile of this.tiles) resized = tile.surface?.fit() || resized;
    const same = message === this.message && state.colours === this.colours;
    if (same && !resized) return false;
    const { colours } = state;
    if (colours !== this.colours) this.labels = '';
    this.message = message;
    this.colours = colours;
    const sorted = sortArrays(message?.arrays ?? [], state.info?.arrays ?? []);
    const populations = [...sorted.rings, ...sorted.sheets];
    this.arrange(sorted, populations);
    this.drawLegend(populations, colours);
    populations.forEach((population, i) => this.drawPopulation(this.tiles[i] as Tile, population, colours));
    sorted.others.forEach((array, i) => {
      drawOther(this.tiles[populations.length + i] as Tile, array, colours);
    });
    return false;
  }

  /** New tiles only when names or shapes have changed. */
  private arrange({ rings, sheets, others }: SortedArrays, populations: readonly Population[]): void {
    const all = [...populations, ...others];
    const layout = all.map(({ info, shape }) => `${info.name}:${shape.join('x')}`).join() + this.asTorus;
    if (layout === this.layout) return;
    this.layout = layout;
    this.empty.hidden = all.length > 0;
    const first = sheets.findIndex(isPeriodic);
    this.button.hidden = first < 0 || !this.torus.possible;
    this.root.replaceChildren();
    this.listed.replaceChildren();
    this.tiles = [...populations.map((p) => this.makePopulationTile(p)), ...others.map((a) => this.makeOtherTile(a))];
    const canvas = this.tiles[rings.length + first]?.surface?.canvas;
    if (this.asTorus && first >= 0 && canvas) this.torus.attach(canvas);
    else this.torus.detach();
  }

  private makePopulationTile({ info, title, shape }: Population): Tile {
    const what = shape.length === 1 ? 'ring' : 'sheet';
    return this.makeTile(info, `Activity of ${title}, ${what} of ${shape.join(' × ')} cells`, true, '');
  }

  private makeOtherTile({ info, shape, values }: OtherArray): Tile {
    const label = `Values of ${info.name}, ${shape.join(' × ')}`;
    return this.makeTile(info, label, values.length > kListed, 'other');
  }

  private makeTile(info: ArrayInfo, label: string, isDrawn: boolean, kind: string): Tile {
    const caption = make('figcaption', { 'data-testid': `cells-${info.name}`, title: info.doc || info.name });
    const figure = make('figure', { class: kind });
    let surface: Surface | null = null;
    if (isDrawn) {
      const canvas = make('canvas', { role: 'img', 'aria-label': label });
      figure.append(canvas);
      surface = new Surface(canvas);
    }
    figure.append(caption);
    (isDrawn ? this.root : this.listed).append(figure);
    surface?.fit();
    return { surface, caption, sheet: new SheetDrawing(), array: new ArrayDrawing() };
  }

  private drawPopulation({ surface, caption, sheet }: Tile, population: Population, colours: Colours): void {
    if (surface === null) return;
    if (population.shape.length === 1) drawRing(surface, population, colours);
    else if (this.torus.isOn(surface.canvas)) this.torus.draw(surface, population, colours);
    else sheet.draw(surface, population, colours);
    setText(caption, captionOf(population));
    setAttribute(caption, 'data-peak', String(peakOf(population.activity)));
  }

  private drawLegend(populations: readonly Population[], colours: Colours): void {
    const labels = [...new Set(populations.flatMap((p) => p.bumps.map((b) => b.label)))];
    if (labels.join() === this.labels) return;
    this.labels = labels.join();
    this.legend.hidden = labels.length === 0;
    this.legend.replaceChildren(
      ...labels.map((label) => {
        const item = make('li');
        item.append(make('i', { class: 'swatch', style: `--swatch: ${bumpColour(label, colours)}` }), label);
        return item;
      }),
    );
  }
}

function drawOther({ surface, caption, array }: Tile, other: OtherArray, colours: Colours): void {
  const { info, shape, values } = other;
  if (surface !== null) array.draw(surface, other, colours);
  const what = surface !== null ? shape.join(' × ') : Array.from(values, brief).join(', ');
  setText(caption, `${info.name}: ${what}${info.unit ? ` ${info.unit}` : ''}`);
}

function peakOf(activity: Float32Array): number {
  let best = 0;
  for (let i = 1; i < activity.length; ++i) {
    if ((activity[i] as number) > (activity[best] as number)) best = i;
  }
  return best;
}

/** The population, its estimate, and the energies of the hypotheses, e.g. "hd 93.1°". */
function captionOf(population: Population): string {
  const hypotheses = population.bumps.filter((b) => b.isHypothesis).sort((a, b) => b.weight - a.weight);
  const estimate = population.bumps.find((b) => b.label === 'estimate') ?? hypotheses[0];
  if (estimate === undefined) return population.title;
  const energies = hypotheses.map((b) => brief(b.energy)).join(', ');
  return `${population.title} ${meanText(population, estimate)}${energies && ` · energies ${energies}`}`;
}

function meanText(population: Population, estimate: Bump): string {
  const mean = meanInUnits(population, estimate);
  const unit = population.info.axes[0]?.unit ?? '';
  if (unit === 'rad') return mean.map(degrees).join(', ');
  const ordered = mean.length === 2 ? [mean[1], mean[0]] : mean; // columns (x) first
  return `(${ordered.map((m) => brief(m ?? NaN)).join(', ')}) ${unit}`;
}
