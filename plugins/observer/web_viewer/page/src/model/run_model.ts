// SPDX-License-Identifier: BSD-3-Clause
// The state of the run on this page: joins the live stream, the history and past frames.
import { fetchFrame, fetchGraph, fetchHistory } from '../wire/api';
import { Connection, type LinkState } from '../wire/connection';
import type { Container } from '../wire/container';
import { hasSameColumns, headerOf, readFrame, readGraph, type FrameMessage } from '../wire/messages';
import { kColumns, type EndHeader, type HelloHeader, type RunInfo } from '../wire/records';
import type { Colours } from '../look/theme';
import { EventLog } from './event_log';
import { FrameStore } from './frame_store';
import { Graph } from './graph';
import { HistoryLoader } from './history_loader';
import { ImageDecoder } from './image_decoder';
import { Player } from './player';
import { RateMeter } from './rate';
import { RowStore } from './row_store';
import type { PageState } from './page_state';

export interface Trouble {
  readonly kind: 'gone' | 'no_frames' | 'other_version';
  readonly until: number; // ms on performance.now's clock; next attempt
}

export class RunModel {
  readonly player = new Player();
  trouble: Trouble | null = null;
  private info: RunInfo | null = null;
  private rows = new RowStore(kColumns);
  private loader = new HistoryLoader(this.rows, fetchHistory, () => undefined);
  private readonly graph = new Graph();
  private readonly events = new EventLog();
  private readonly frames: FrameStore;
  private readonly pictures: ImageDecoder;
  private readonly connection: Connection;
  private readonly rate = new RateMeter(5);
  private message: FrameMessage | null = null;
  private link: LinkState = 'connecting';
  private live = false;
  private recorded = false; // the run had ended before it was shown
  private reading = false; // its record, by the server
  private endState = '';
  private dropped = 0;
  private streamed = 0; // rows that the stream has brought
  private graphAsked = false;

  constructor(address: string, private readonly changed: () => void) {
    this.frames = new FrameStore(
      fetchFrame,
      (asked, message) => this.stored(asked, message),
      () => this.lostServer(),
    );
    this.pictures = new ImageDecoder(changed);
    this.connection = new Connection(address, {
      message: (message) => this.receive(message),
      state: (state, retry) => this.linkChanged(state, retry),
    });
  }

  open(): void {
    this.connection.open();
  }

  state(colours: Colours): PageState {
    const row = Math.min(this.player.row, this.rows.count - 1);
    return {
      info: this.info, rows: this.rows, row, frame: this.rows.frame(row), message: this.message,
      picture: this.pictures.picture, graph: this.graph, events: this.events,
      mode: this.player.mode, speed: this.player.speed, live: this.live,
      loading: this.loader.loading || this.reading, recorded: this.recorded, link: this.link,
      rate: this.live ? this.rate.rate(performance.now() / 1000) : NaN,
      dropped: this.dropped, colours,
    };
  }

  get count(): number {
    return this.rows.count;
  }
  get end(): string {
    return this.endState;
  }

  seek(row: number): void {
    if (this.rows.count === 0) return;
    this.player.seek(row, this.rows.count);
    this.shownChanged();
  }

  seekFrame(frame: number): void {
    this.seek(this.rows.rowOfFrame(frame));
  }

  follow(): void {
    this.player.follow(this.rows.count);
    this.shownChanged();
  }

  /** Pauses, or plays from the shown row; at the newest row a live run is followed again. */
  toggle(): void {
    if (this.player.mode !== 'paused') this.player.pause();
    else this.player.play(this.rows.column('frame.time'), this.rows.count);
    this.shownChanged();
  }

  tick(seconds: number): void {
    const stamps = this.rows.column('frame.time');
    if (!this.player.tick(seconds, stamps, this.rows.count)) return;
    const caughtUp = this.live && this.player.mode === 'paused';
    if (caughtUp) this.follow();
    else this.shownChanged();
  }

  private receive(message: Container): void {
    if (message.type === 'hello') this.hello(headerOf<HelloHeader>(message));
    else if (message.type === 'frame') this.frame(readFrame(message));
    else if (message.type === 'graph') this.graph.replace(readGraph(message));
    else if (message.type === 'end') this.finish(headerOf<EndHeader>(message).state);
    this.changed();
  }

  private hello(header: HelloHeader): void {
    if (!hasSameColumns(header)) {
      this.trouble = { kind: 'other_version', until: 0 };
      return;
    }
    const { run } = header;
    const same =
      this.info?.name === run.name && this.info.directory === run.directory &&
      header.rows >= this.rows.count;
    if (!same) this.restart();
    this.info = run;
    this.live = header.live && !header.recorded;
    this.recorded = header.recorded;
    this.reading = header.recorded && header.live;
    this.endState = '';
    this.trouble = null;
    this.dropped = 0;
    this.connection.setFlow(this.player.mode === 'live');
    void this.catchUp(header.rows);
  }

  private restart(): void {
    this.rows = new RowStore(kColumns);
    this.loader = new HistoryLoader(this.rows, fetchHistory, () => this.grown());
    this.graph.clear();
    this.events.clear();
    this.frames.clear();
    this.player.reset();
    this.message = null;
    this.pictures.clear();
    this.graphAsked = false;
  }

  private async catchUp(rows: number): Promise<void> {
    try {
      await this.loader.catchUp(rows);
    } catch {
      this.lostServer();
      return;
    }
    this.grown();
    const newest = this.rows.count - 1;
    const hasGraph = this.rows.value(newest, 'map_update.experiences') > 0;
    if (hasGraph && this.graph.experiences === 0 && !this.graphAsked) {
      this.graphAsked = true;
      this.graph.replace(await fetchGraph().catch(() => null));
      this.changed();
    }
    if (this.message === null && newest >= 0) this.shownChanged();
  }

  private frame(message: FrameMessage): void {
    this.dropped = message.header.dropped;
    this.events.add(message.header.events);
    this.frames.keep(message);
    if (message.rows !== null) {
      const added = message.rows.values.length / message.rows.columns;
      const end = message.rows.from + added;
      this.streamed += added;
      this.rows.add(message.rows);
      if (this.rows.gap >= 0) void this.catchUp(end);
    }
    this.rate.note(this.streamed, performance.now() / 1000);
    if (this.player.mode === 'live') this.show(message);
    this.grown();
  }

  private grown(): void {
    this.events.scan(this.rows);
    this.player.grow(this.rows.count);
    this.changed();
  }

  private finish(state: string): void {
    this.live = false;
    this.reading = false;
    this.endState = state;
  }

  /** Call after the shown row has changed. */
  private shownChanged(): void {
    const { mode, row } = this.player;
    this.connection.setFlow(mode === 'live');
    const awaitsStream = mode === 'live' && this.live && this.message !== null;
    if (row >= 0 && !awaitsStream) this.frames.want(this.rows.frame(row));
    this.changed();
  }

  private stored(asked: number, message: FrameMessage | null): void {
    if (this.trouble?.kind === 'no_frames') this.trouble = null;
    const newerShown = this.player.mode === 'live' && (this.message?.header.frame ?? -1) > asked;
    if (!newerShown && !message?.image) this.pictures.dropAfter(asked);
    if (message !== null && !newerShown) {
      this.events.add(message.header.events);
      this.show(message);
    }
    this.changed();
  }

  private show(message: FrameMessage): void {
    this.message = message;
    this.pictures.decode(message);
  }

  private lostServer(): void {
    if (this.link === 'ended' || this.endState !== '') {
      this.trouble = { kind: 'no_frames', until: 0 };
    }
    this.changed();
  }

  private linkChanged(state: LinkState, retry: number): void {
    this.link = state;
    if (state === 'waiting') {
      this.trouble = { kind: 'gone', until: performance.now() + 1000 * retry };
    }
    this.changed();
  }
}
