// SPDX-License-Identifier: BSD-3-Clause
// Pause, live, speed, and the time line with speed, familiar views, loop closures and lost tracking.
import { byId, setAttribute, setText, Surface } from '../look/dom';
import { duration, integer } from '../look/format';
import type { RunModel } from '../model/run_model';
import { Pace, type Panel, type PageState } from '../model/page_state';
import { kChoices } from '../wire/records';

const kPause = 'M6 4.5h3v11H6zM11 4.5h3v11h-3z';
const kPlay = 'M6.5 4.2v11.6L16 10z';
const kFamiliar = kChoices['place.recognition'].indexOf('familiar');
const kCloseLoop = kChoices['decision.action'].indexOf('close_loop');
const kLost = kChoices['motion.state'].indexOf('lost');

export class TransportPanel implements Panel {
  private readonly scrub = byId<HTMLInputElement>('scrub');
  private readonly play = byId<HTMLButtonElement>('play');
  private readonly live = byId<HTMLButtonElement>('live');
  private readonly speed = byId<HTMLButtonElement>('speed');
  private readonly surface = new Surface(byId<HTMLCanvasElement>('strip'));
  private readonly texts = {
    shape: byId<SVGPathElement>('play-shape'),
    frame: byId('shown-frame'),
    of: byId('of-frames'),
    time: byId('shown-time'),
  };
  private readonly pace = new Pace(300);
  private key = '';

  constructor(model: RunModel, changed: () => void) {
    this.scrub.oninput = () => model.seek(Number(this.scrub.value));
    this.play.onclick = () => model.toggle();
    this.live.onclick = () => model.follow();
    this.speed.onclick = () => {
      model.player.cycleSpeed();
      changed();
    };
  }

  update(state: PageState, now: number): boolean {
    const { rows, row, mode } = state;
    setAttribute(this.scrub, 'max', String(Math.max(0, rows.count - 1)));
    if (this.scrub.value !== String(Math.max(0, row))) this.scrub.value = String(Math.max(0, row));
    setAttribute(this.scrub, 'aria-valuetext', `frame ${integer(state.frame)}`);
    const paused = mode === 'paused' || (mode === 'live' && !state.live);
    setAttribute(this.texts.shape, 'd', paused ? kPlay : kPause);
    setAttribute(this.play, 'aria-label', paused ? 'Play (space)' : 'Pause (space)');
    setText(this.live, state.live ? 'Live' : 'Newest');
    setAttribute(this.live, 'aria-pressed', String(mode === 'live'));
    setText(this.speed, `${state.speed}×`);
    setText(this.texts.frame, integer(state.frame));
    const total = state.live && state.info && state.info.source.frames > 0 ? state.info.source.frames - 1 : rows.frame(rows.count - 1);
    setText(this.texts.of, ` / ${integer(total)}`);
    setText(this.texts.time, duration(rows.value(row, 'frame.time') - rows.value(0, 'frame.time')));
    return this.updateStrip(state, now);
  }

  private updateStrip(state: PageState, now: number): boolean {
    const key = `${state.rows.count} ${state.info?.name} ${Object.values(state.colours).join()}`;
    const resized = this.surface.fit();
    if (key === this.key && !resized) return false;
    if (!resized && !this.pace.due(now)) return true;
    this.key = key;
    this.drawStrip(state);
    return false;
  }

  /** Speed as bars, familiar views below them, loop closures and lost frames as marks. */
  private drawStrip({ rows, colours }: PageState): void {
    const context = this.surface.clear();
    const { width, height } = this.surface;
    const count = rows.count;
    if (count < 2) return;
    const speed = rows.column('motion.v');
    const kind = rows.column('place.recognition');
    const action = rows.column('decision.action');
    const tracking = rows.column('motion.state');
    let most = 1e-6;
    for (let i = 0; i < count; ++i) most = Math.max(most, Math.abs(speed[i] as number) || 0);
    const columns = Math.max(1, Math.floor(width));
    for (let x = 0; x < columns; ++x) {
      const from = Math.floor((x * count) / columns);
      const to = Math.max(from + 1, Math.floor(((x + 1) * count) / columns));
      let [fast, familiar, loop, lost] = [0, false, false, false];
      for (let i = from; i < to; ++i) {
        fast = Math.max(fast, Math.abs(speed[i] as number) || 0);
        familiar ||= kind[i] === kFamiliar;
        loop ||= action[i] === kCloseLoop;
        lost ||= tracking[i] === kLost;
      }
      const hill = (0.55 * height * fast) / most;
      context.fillStyle = lost ? colours.purple : colours.line;
      context.fillRect(x, height - 5 - hill, 1, hill);
      context.fillStyle = familiar ? colours.faint : 'transparent';
      context.fillRect(x, height - 4, 1, 3);
      if (loop) {
        context.fillStyle = colours.vermilion;
        context.fillRect(x, 3, 1.4, 9);
      }
    }
  }
}
