// SPDX-License-Identifier: BSD-3-Clause
// The page: model, panels, keys, and the loop that draws when something has changed.
import 'uplot/dist/uPlot.min.css';
import './style/tokens.css';
import './style/base.css';
import './style/panels.css';
import { publish } from './debug';
import { listen } from './keyboard';
import { byId } from './look/dom';
import { Theme } from './look/theme';
import { RateMeter } from './model/rate';
import { RunModel } from './model/run_model';
import type { Panel } from './model/page_state';
import { CameraPanel } from './panels/camera_panel';
import { CellsPanel } from './panels/cells_panel';
import { CountersPanel } from './panels/counters_panel';
import { EventsPanel } from './panels/events_panel';
import { LoopsPanel } from './panels/loops_panel';
import { MapPanel } from './panels/map_panel';
import { MatchPanel } from './panels/match_panel';
import { StatusPanel } from './panels/status_panel';
import { TemplatesPanel } from './panels/templates_panel';
import { TimingPanel } from './panels/timing_panel';
import { TransportPanel } from './panels/transport_panel';

const kLater = 100; // ms until a panel that put work off is asked again

class App {
  private readonly theme = new Theme(() => this.invalidate());
  private readonly model = new RunModel(
    `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/live`,
    () => this.invalidate(),
  );
  private readonly map = new MapPanel(() => this.invalidate());
  private readonly cells = new CellsPanel(() => this.invalidate());
  private readonly panels: Panel[];
  private readonly drawn = new RateMeter(1);
  private draws = 0;
  private waiting = false;
  private later = 0;
  private last = performance.now();

  constructor() {
    const seekFrame = (frame: number) => this.model.seekFrame(frame);
    const match = new MatchPanel();
    const seekLoop = (frame: number) => seekFrame((match.candidateAt = frame));
    this.panels = [
      new StatusPanel(this.model), new CountersPanel(), new CameraPanel(), match,
      this.map, this.cells, new TemplatesPanel(this.theme.colours, (seconds) => this.seekTime(seconds)),
      new TimingPanel(), new EventsPanel(seekFrame), new LoopsPanel(seekLoop),
      new TransportPanel(this.model, () => this.invalidate()),
    ];
    this.bindKeys();
    byId('theme').onclick = () => this.theme.toggle();
    byId('help-open').onclick = () => this.openHelp();
    new ResizeObserver(() => this.invalidate()).observe(document.documentElement);
    publish(() => this.model.state(this.theme.colours), this.map, () => this.drawn.rate(performance.now() / 1000));
    this.model.open();
  }

  private invalidate(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.waiting = false;
    this.model.tick((now - this.last) / 1000);
    this.last = now;
    const view = this.model.state(this.theme.colours);
    let unfinished = false;
    for (const panel of this.panels) unfinished = panel.update(view, now) || unfinished;
    this.drawn.note(++this.draws, now / 1000);
    if (view.mode === 'playing') this.invalidate();
    // Rates fall also when nothing comes any more.
    this.scheduleLater(unfinished ? kLater : view.live ? 1000 : 0);
  }

  private scheduleLater(wait: number): void {
    window.clearTimeout(this.later);
    if (wait > 0) this.later = window.setTimeout(() => this.invalidate(), wait);
  }

  private seekTime(seconds: number): void {
    const { rows } = this.model.state(this.theme.colours);
    const stamps = rows.column('frame.time').subarray(0, rows.count);
    let row = stamps.findIndex((stamp) => stamp >= seconds);
    if (row < 0) row = rows.count - 1;
    this.model.seek(row);
  }

  private step(event: KeyboardEvent, direction: number): void {
    this.model.seek(this.model.player.row + direction * (event.shiftKey ? 10 : 1));
  }

  private openHelp(): void {
    byId<HTMLDialogElement>('help').showModal();
  }

  private bindKeys(): void {
    const { model, map } = this;
    listen([
      { keys: [' '], shown: 'space', meaning: 'pause, or play what is recorded', act: () => model.toggle() },
      { keys: ['ArrowLeft'], shown: '←', meaning: 'a frame back (with shift: ten)', act: (e) => this.step(e, -1) },
      { keys: ['ArrowRight'], shown: '→', meaning: 'a frame on (with shift: ten)', act: (e) => this.step(e, 1) },
      { keys: ['PageUp'], shown: 'PgUp', meaning: 'a hundred frames back', act: () => model.seek(model.player.row - 100) },
      { keys: ['PageDown'], shown: 'PgDn', meaning: 'a hundred frames on', act: () => model.seek(model.player.row + 100) },
      { keys: ['Home'], shown: 'home', meaning: 'first frame', act: () => model.seek(0) },
      { keys: ['End', 'l'], shown: 'end l', meaning: 'newest frame, and follow the run', act: () => model.follow() },
      { keys: ['s'], shown: 's', meaning: 'speed of playing', act: () => byId('speed').click() },
      { keys: ['+', '='], shown: '+', meaning: 'map nearer', act: () => map.zoomBy(1.25) },
      { keys: ['-'], shown: '-', meaning: 'map farther', act: () => map.zoomBy(0.8) },
      { keys: ['f'], shown: 'f', meaning: 'fit the whole map', act: () => map.fit() },
      { keys: ['c'], shown: 'c', meaning: 'keep the robot in the middle', act: () => map.toggleCentre() },
      { keys: ['2'], shown: '2', meaning: 'map from above', act: () => map.choose('2d') },
      { keys: ['3'], shown: '3', meaning: 'map in space', act: () => map.choose('3d') },
      { keys: ['g'], shown: 'g', meaning: 'grid cells as sheet or torus', act: () => this.cells.toggleTorus() },
      { keys: ['t'], shown: 't', meaning: 'light or dark', act: () => this.theme.toggle() },
      { keys: ['?'], shown: '?', meaning: 'this help', act: () => this.openHelp() },
    ]);
  }
}

new App();
