// SPDX-License-Identifier: BSD-3-Clause
// The experience map and its tools: layers, 2-D and 3-D, fit, centre on the robot, scale.
import { Vector2 } from 'three';
import { byId, make, setAttribute, setText } from '../look/dom';
import { brief, metres, units } from '../look/format';
import { webGl } from '../look/web_gl';
import { roundDown } from '../model/sampling';
import { cellFor } from '../model/thinning';
import type { Panel, PageState } from '../model/page_state';
import type { Colours } from '../look/theme';
import { kLayers, MapContent, type LayerName } from './map_content';
import { MapStage, type Dimension } from './map_stage';

const kLayerNames: Readonly<Record<LayerName, string>> = {
  links: 'odometry links', loops: 'loop links', rejected: 'rejected loop links', experiences: 'experiences',
  odometry: 'odometry', truth: 'ground truth',
};
const kRobotSize = 17; // px
const kRest = 300; // ms without a change
const kColourOf = {
  links: 'blue', loops: 'vermilion', rejected: 'rejected', experiences: 'green', odometry: 'orange', truth: 'truth',
} as const;

export class MapPanel implements Panel {
  renders = 0;
  private readonly stage: MapStage | null;
  private readonly content: MapContent;
  private readonly texts = { foot: byId('map-foot'), scale: byId('scale-text'), axes: byId('axes') };
  private readonly bar = byId('scale-bar');
  private readonly numbers = new Map<LayerName, HTMLElement>();
  private readonly centreButton = byId('map-centre');
  private readonly align = byId('align');
  private centred = false;
  private dirty = true;
  private lastMove = 0; // ms
  private key = '';
  private cell = 0;
  private relayer = false; // which layers are drawn, or how, has changed
  private colours: Colours | null = null;
  private hasTruth: boolean | null = null;

  constructor(private readonly changed: () => void) {
    const canvas = byId<HTMLCanvasElement>('map');
    this.stage = webGl() !== 'none' ? new MapStage(canvas, () => this.touch()) : null;
    this.content = new MapContent(this.stage?.resolution ?? { value: new Vector2(1, 1) });
    this.stage?.add(this.content.group);
    if (this.stage === null) {
      const empty = byId('map-empty');
      empty.hidden = false;
      setText(empty, 'This browser offers no WebGL, which the map needs.');
    }
    byId('map-2d').onclick = () => this.choose('2d');
    byId('map-3d').onclick = () => this.choose('3d');
    byId('map-fit').onclick = () => this.fit();
    this.centreButton.onclick = () => this.toggleCentre();
    this.makeLayers();
  }

  get zoom(): number {
    return this.stage?.zoom ?? NaN;
  }
  get centre(): readonly [number, number] {
    const centre = this.stage?.centre;
    return centre ? [centre.x, -centre.z] : [NaN, NaN];
  }
  get dimension(): Dimension {
    return this.stage?.dimension ?? '2d';
  }

  choose(dimension: Dimension): void {
    this.stage?.choose(dimension);
    setAttribute(byId('map-2d'), 'aria-pressed', String(dimension === '2d'));
    setAttribute(byId('map-3d'), 'aria-pressed', String(dimension === '3d'));
    this.touch();
  }

  fit(): void {
    if (this.centred) this.toggleCentre();
    this.stage?.fit(this.content.bounds);
    if (this.stage) this.stage.untouched = true;
    this.touch();
  }

  toggleCentre(): void {
    this.centred = !this.centred;
    setAttribute(this.centreButton, 'aria-pressed', String(this.centred));
    this.touch();
  }

  zoomBy(factor: number): void {
    this.stage?.zoomBy(factor);
    this.touch();
  }

  toggle(layer: LayerName): void {
    this.content.setHidden(layer, !this.content.isHidden(layer));
    this.relayer = true;
    this.touch();
  }

  update(state: PageState, now: number): boolean {
    if (this.stage === null) return false;
    const resized = this.stage.resize();
    if (state.colours !== this.colours) this.paint(state.colours);
    const key = `${state.rows.count} ${state.row} ${state.graph.edition}`;
    if (!resized && !this.dirty && key === this.key) return this.refine(this.stage, now);
    this.stage.fine = false;
    this.stage.resize();
    this.lastMove = now;
    const fresh = key !== this.key || this.relayer;
    if (fresh) this.content.take(state);
    if (this.stage.untouched) this.stage.fit(this.content.bounds);
    const cell = cellFor(this.stage.zoom);
    if (fresh || cell !== this.cell) this.content.show(state, cell);
    if (fresh) this.describe(state);
    [this.key, this.cell, this.relayer, this.dirty] = [key, cell, false, false];
    if (this.centred && this.content.robot.visible) this.stage.centreOn(this.content.robot.position);
    const zoom = this.stage.zoom;
    this.content.robot.scale.setScalar(kRobotSize / zoom);
    this.content.setDotSize(Math.max(3.4, Math.min(9, 2.2 * zoom)));
    this.dirty = this.stage.render(this.content.bounds);
    ++this.renders;
    this.showScale(zoom);
    if (this.dirty) this.changed(); // still gliding
    return this.stage.software;
  }

  /** Renders finely once nothing moves. True when that is due soon. */
  private refine(stage: MapStage, now: number): boolean {
    if (!stage.software || stage.fine) return false;
    if (now - this.lastMove < kRest) return true;
    stage.fine = true;
    stage.resize();
    stage.render(this.content.bounds);
    ++this.renders;
    return false;
  }

  private touch(): void {
    this.dirty = true;
    this.changed();
  }

  private paint(colours: Colours): void {
    this.colours = colours;
    this.content.setColours(colours);
    this.stage?.setColours(colours.well, colours.line);
    this.dirty = true;
  }

  private describe(state: PageState): void {
    const { rows, row, graph } = state;
    setText(this.numbers.get('experiences') as HTMLElement, String(graph.experiences));
    setText(this.numbers.get('links') as HTMLElement, String(graph.links - graph.loops - graph.rejected));
    setText(this.numbers.get('loops') as HTMLElement, String(graph.loops));
    setText(this.numbers.get('rejected') as HTMLElement, String(graph.rejected));
    byId('layer-rejected').hidden = graph.rejected === 0;
    const hasTruth = Number.isFinite(rows.value(0, 'truth.x')) || (state.info?.source.has_truth ?? false);
    if (hasTruth !== this.hasTruth) {
      this.hasTruth = hasTruth;
      byId('layer-truth').hidden = !hasTruth;
      this.align.hidden = !hasTruth;
    }
    setText(this.align, this.content.truthMode === 'fitted' ? 'as given' : 'align');
    const past = row < rows.count - 1;
    const corrected = `correction ${graph.version}`;
    const truth = !hasTruth ? '' : ` · truth ${truthText(this.content)}`;
    setText(this.texts.foot, (past ? `as far as frame ${state.frame} · ` : '') + corrected + truth);
    setAttribute(this.texts.foot, 'data-version', String(graph.version));
  }

  private showScale(zoom: number): void {
    const length = roundDown(110 / zoom);
    setAttribute(this.bar, 'style', `width: ${(length * zoom).toFixed(1)}px`);
    const text = this.content.hasMetres ? metres : units;
    setText(this.texts.scale, text(length));
    const grid = `grid ${text(this.stage?.gridStep ?? NaN)}`;
    setText(this.texts.axes, this.dimension === '2d' ? `z ↑ x → · ${grid}` : grid);
  }

  private makeLayers(): void {
    for (const layer of kLayers) {
      const label = make('label', { id: `layer-${layer}`, class: 'chip' });
      const box = make('input', { type: 'checkbox', 'aria-label': `Show ${kLayerNames[layer]}` });
      box.checked = true;
      box.onchange = () => this.toggle(layer);
      const style = `--swatch: var(--${kColourOf[layer]})`;
      const swatch = make('i', { style, class: layer === 'experiences' ? 'round' : '' });
      const number = make('b', { 'data-testid': `graph-${layer}` });
      this.numbers.set(layer, number);
      label.append(box, swatch, layer, number);
      byId('layers').append(label);
    }
    this.align.onclick = () => {
      this.content.setTruthMode(this.content.truthMode === 'fitted' ? 'given' : 'fitted');
      this.relayer = true;
      this.touch();
    };
  }
}

function truthText({ truthMode, scaleKnown, scale }: MapContent): string {
  if (truthMode === 'fitted') {
    return scaleKnown ? 'fitted (turn and shift)' : `fitted, 1 unit is ${brief(scale)} m`;
  }
  return truthMode === 'given' ? 'as given' : 'not known yet';
}
