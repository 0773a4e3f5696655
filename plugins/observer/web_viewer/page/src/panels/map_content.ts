// SPDX-License-Identifier: BSD-3-Clause
// Turns rows and graph into the layers of the map.
import { Box3, Color, Group, Mesh, MeshBasicMaterial, Shape, ShapeGeometry, Vector3 } from 'three';
import { bestMotion, bestScale, firstDistance, kIdentity, moved, type PlanarMotion, type Track } from '../model/alignment';
import type { Graph } from '../model/graph';
import type { RowStore } from '../model/row_store';
import type { PageState } from '../model/page_state';
import type { Colours } from '../look/theme';
import { hasStoreys, kStorey } from '../model/storeys';
import { countBelow } from '../model/thinning';
import type { ColumnName } from '../wire/records';
import type { Fade, Resolution } from './line_material';
import { DotLayer, SegmentLayer, toScene } from './map_layers';

export const kLayers = ['links', 'loops', 'rejected', 'experiences', 'odometry', 'truth'] as const;
export type LayerName = (typeof kLayers)[number];
const kLinkLayers = ['links', 'loops', 'rejected'] as const;
export type TruthMode = 'given' | 'fitted';

const kSameStart = 1; // m; truth that starts closer to the odometry is drawn as given

function track(rows: RowStore, name: 'odometry' | 'map' | 'truth'): Track {
  return { x: rows.column(`${name}.x`), y: rows.column(`${name}.y`), z: rows.column(`${name}.z`) };
}

export class MapContent {
  readonly group = new Group();
  readonly bounds = new Box3();
  readonly robot = new Group();
  truthMode: TruthMode | null = null; // null: not decided yet
  scale = 1; // of the estimate: metres of the truth in one of its units
  scaleKnown = true; // the run measures metres
  private chosen = false; // the mode, by the person who watches
  private readonly hidden = new Set<LayerName>();
  private readonly truth: SegmentLayer;
  private readonly odometry: SegmentLayer;
  private readonly links: SegmentLayer;
  private readonly loops: SegmentLayer;
  private readonly rejected: SegmentLayer;
  private readonly dots: DotLayer;
  private readonly fade: Fade = { level: { value: 0 }, reach: { value: 0 }, paper: { value: new Color() } };
  private readonly fill = new MeshBasicMaterial({ depthTest: false, transparent: true });
  private readonly rim = new MeshBasicMaterial({ depthTest: false, transparent: true });
  private drawnRows = { rows: null as RowStore | null, count: 0 };
  private drawnGraph = -1;
  private motion: PlanarMotion = kIdentity;
  private fittedRows = 0;
  /** Numbers of the links of each layer, ascending. */
  private readonly linksOf = { links: [] as number[], loops: [] as number[], rejected: [] as number[] };

  constructor(resolution: Resolution) {
    this.truth = new SegmentLayer(4.5, 1, resolution, this.fade);
    this.odometry = new SegmentLayer(1.4, 2, resolution, this.fade);
    this.links = new SegmentLayer(1.6, 3, resolution, this.fade);
    this.rejected = new SegmentLayer(1.2, 2, resolution, this.fade);
    this.loops = new SegmentLayer(3, 5, resolution, this.fade);
    this.dots = new DotLayer(4, this.fade);
    for (const layer of [this.truth, this.odometry, this.links, this.rejected, this.loops, this.dots]) {
      this.group.add(layer.object);
    }
    this.makeRobot();
    this.group.add(this.robot);
  }

  isHidden(layer: LayerName): boolean {
    return this.hidden.has(layer);
  }

  setHidden(layer: LayerName, hidden: boolean): void {
    if (hidden) this.hidden.add(layer);
    else this.hidden.delete(layer);
  }

  setTruthMode(mode: TruthMode): void {
    this.truthMode = mode;
    this.chosen = true;
    this.drawnRows.count = 0;
  }

  setColours(colours: Colours): void {
    this.truth.setColour(colours.truth);
    this.odometry.setColour(colours.orange);
    this.links.setColour(colours.blue);
    this.loops.setColour(colours.vermilion);
    this.rejected.setColour(colours.rejected);
    this.dots.setColour(colours.green);
    this.fill.color.set(colours.ink);
    this.rim.color.set(colours.panel);
    this.fade.paper.value.set(colours.well);
  }

  setDotSize(size: number): void {
    this.dots.setSize(size);
  }

  /** Updates buffers and bounds for new rows and a new graph. */
  take(state: PageState): void {
    this.updateRows(state.rows);
    if (state.graph.edition !== this.drawnGraph) this.updateGraph(state.graph);
  }

  /** Whether lengths are metres: as measured, or as the truth tells. */
  get hasMetres(): boolean {
    return this.scaleKnown || this.truthMode === 'fitted';
  }

  /** Shows the map as far as the shown row. `cell` is the resolution of lines in m. */
  show(state: PageState, cell: number): void {
    const { rows, row } = state;
    const newest = row === rows.count - 1;
    const limit = (column: ColumnName, all: number) => {
      const then = rows.value(row, column);
      return newest || !Number.isFinite(then) ? all : Math.min(all, then);
    };
    const links = limit('map_update.links', state.graph.links);
    this.draw('odometry', this.odometry, row, cell);
    this.draw('truth', this.truth, row, cell);
    const dots = limit('map_update.experiences', state.graph.experiences);
    this.dots.show(this.hidden.has('experiences') ? 0 : dots);
    for (const name of kLinkLayers) {
      this.draw(name, this[name], countBelow(this.linksOf[name], links), cell);
    }
    this.placeRobot(state);
  }

  private draw(name: LayerName, layer: SegmentLayer, count: number, cell: number): void {
    layer.show(this.hidden.has(name) ? 0 : count, cell);
  }

  private updateRows(rows: RowStore): void {
    if (this.drawnRows.rows !== rows) {
      this.drawnRows = { rows, count: 0 };
      this.truthMode = null;
      this.chosen = false;
      this.bounds.makeEmpty();
      this.odometry.cut(0);
      this.truth.cut(0);
    }
    const first = this.drawnRows.count;
    if (rows.count === first) return;
    const before = this.scale;
    const fit = this.alignTruth(rows);
    const rescaled = this.scale !== before;
    if (rescaled) {
      this.drawnGraph = -1;
      this.bounds.makeEmpty();
    }
    const estimate = { ...kIdentity, scale: this.scale };
    this.addPath(this.odometry, track(rows, 'odometry'), estimate, rescaled ? 0 : first, rows.count);
    this.addPath(this.truth, track(rows, 'truth'), this.motion, fit ? 0 : first, rows.count);
    this.drawnRows.count = rows.count;
  }

  /** Updates the alignment. True when the truth must be drawn again. */
  private alignTruth(rows: RowStore): boolean {
    const truth = track(rows, 'truth');
    const map = track(rows, 'map');
    this.scaleKnown = rows.value(rows.count - 1, 'motion.scale_known') !== 0;
    if (!this.chosen) {
      const apart = firstDistance(truth, track(rows, 'odometry'), rows.count);
      if (Number.isFinite(apart)) this.truthMode = apart < kSameStart && this.scaleKnown ? 'given' : 'fitted';
    }
    if (this.truthMode !== 'fitted') {
      const before = this.motion;
      this.motion = kIdentity;
      this.scale = 1;
      return before !== kIdentity;
    }
    // The fit is repeated whenever the run is 5 % longer.
    if (this.drawnRows.count > 0 && rows.count < 1.05 * this.fittedRows) return false;
    this.fittedRows = rows.count;
    this.scale = this.scaleKnown ? 1 : bestScale(truth, map, rows.count);
    this.motion = bestMotion(truth, map, rows.count, this.scale);
    return true;
  }

  private addPath(layer: SegmentLayer, path: Track, motion: PlanarMotion, first: number, count: number): void {
    let before: [number, number, number] | null = null;
    const at = (i: number) => {
      const [x, z] = moved(motion, path.x[i] as number, path.z[i] as number);
      return toScene(x, motion.scale * (path.y[i] as number) + motion.y, z);
    };
    for (let i = Math.max(0, first - 1); i < count; ++i) {
      const point = at(i);
      const known = Number.isFinite(point[0]);
      if (known) this.bounds.expandByPoint(new Vector3(...point));
      const from: [number, number, number] = before ?? point;
      // Segment i - 1 ends at row i; where a row is unknown nothing is seen: both ends are one.
      if (i > 0) layer.set(i - 1, known ? from : (before ?? [0, 0, 0]), known ? point : (before ?? [0, 0, 0]));
      if (known) before = point;
    }
  }

  private updateGraph(graph: Graph): void {
    this.drawnGraph = graph.edition;
    const at = (experience: number) => {
      const [x, y, z] = graph.position(experience);
      return toScene(this.scale * x, this.scale * y, this.scale * z);
    };
    for (let i = 0; i < graph.experiences; ++i) {
      const point = at(i);
      this.dots.set(i, point);
      this.bounds.expandByPoint(new Vector3(...point));
    }
    for (const name of kLinkLayers) this.linksOf[name] = [];
    for (let i = 0; i < graph.links; ++i) {
      const [from, to] = graph.ends(i);
      const name = graph.isRejected(i) ? 'rejected' : graph.isLoop(i) ? 'loops' : 'links';
      const list = this.linksOf[name];
      this[name].set(list.length, at(from), at(to));
      list.push(i);
    }
    for (const name of kLinkLayers) this[name].cut(this.linksOf[name].length);
    this.dots.upload();
    this.fade.reach.value = hasStoreys(graph, this.scale) ? kStorey * 0.6 : 0;
  }

  /** Where the robot was seen from its experience, which the map may have moved since. */
  private placeRobot({ rows, row, graph }: PageState): void {
    const at = (...columns: ColumnName[]) => columns.map((c) => rows.value(row, c)) as [number, number, number];
    let [x, y, z] = at('map.x', 'map.y', 'map.z');
    const experience = rows.value(row, 'map_update.experience');
    const [ax, ay, az] = at('anchor.x', 'anchor.y', 'anchor.z');
    const [ex, ey, ez] = graph.position(experience);
    let turn = graph.heading(experience) - rows.value(row, 'anchor.yaw');
    if (Number.isFinite(turn + ex + ax)) {
      const [dx, dz, c, s] = [x - ax, z - az, Math.cos(turn), Math.sin(turn)];
      [x, y, z] = [ex + c * dx - s * dz, ey + y - ay, ez + s * dx + c * dz];
    } else turn = 0;
    this.robot.visible = Number.isFinite(x);
    if (!this.robot.visible) return;
    this.robot.position.set(...toScene(this.scale * x, this.scale * y, this.scale * z));
    this.fade.level.value = this.robot.position.y;
    const heading = rows.value(row, 'decision.heading');
    this.robot.rotation.y = turn + (Number.isFinite(heading) ? heading : 0);
  }

  /** An arrow in the ground plane that points forward (-z of the scene), one unit long. */
  private makeRobot(): void {
    const parts = [[this.rim, 1.42, 6], [this.fill, 1, 7]] as const;
    for (const [material, size, order] of parts) {
      const shape = new Shape();
      shape.moveTo(0, 0.62 * size);
      shape.lineTo(0.42 * size, -0.45 * size);
      shape.lineTo(0, -0.22 * size);
      shape.lineTo(-0.42 * size, -0.45 * size);
      const mesh = new Mesh(new ShapeGeometry(shape), material);
      mesh.rotation.x = -Math.PI / 2;
      mesh.renderOrder = order;
      material.side = 2;
      this.robot.add(mesh);
    }
  }
}
