// SPDX-License-Identifier: BSD-3-Clause
// Pause, live, speed, and the scrub bar over a strip that shows where what happened.
import { byId, setAttribute, setText, Surface } from '../look/dom';
import { clock, integer } from '../look/format';
import type { Session } from '../model/session';
import { Pace, type Panel, type View } from '../model/view';

const kPause = 'M6 4.5h3v11H6zM11 4.5h3v11h-3z';
const kPlay = 'M6.5 4.2v11.6L16 10z';

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

  constructor(session: Session, changed: () => void) {
    this.scrub.oninput = () => session.seek(Number(this.scrub.value));
    this.play.onclick = () => session.toggle();
    this.live.onclick = () => session.follow();
    this.speed.onclick = () => {
      session.player.cycleSpeed();
      changed();
    };
  }

  update(view: View, now: number): boolean {
    const { rows, row, mode } = view;
    setAttribute(this.scrub, 'max', String(Math.max(0, rows.count - 1)));
    if (this.scrub.value !== String(Math.max(0, row))) this.scrub.value = String(Math.max(0, row));
    setAttribute(this.scrub, 'aria-valuetext', `frame ${integer(view.frame)}`);
    const paused = mode === 'paused' || (mode === 'live' && !view.live);
    setAttribute(this.texts.shape, 'd', paused ? kPlay : kPause);
    setAttribute(this.play, 'aria-label', paused ? 'Play (space)' : 'Pause (space)');
    setText(this.live, view.live ? 'Live' : 'Newest');
    setAttribute(this.live, 'aria-pressed', String(mode === 'live'));
    setText(this.speed, `${view.speed}×`);
    setText(this.texts.frame, integer(view.frame));
    const total = view.live && view.info && view.info.frames > 0 ? view.info.frames - 1 : rows.frame(rows.count - 1);
    setText(this.texts.of, ` / ${integer(total)}`);
    setText(this.texts.time, `${clock(rows.value(row, 'stamp_s') - rows.value(0, 'stamp_s'))} min`);
    return this.updateStrip(view, now);
  }

  private updateStrip(view: View, now: number): boolean {
    const key = `${view.rows.count} ${view.info?.name} ${Object.values(view.colours).join()}`;
    const resized = this.surface.fit();
    if (key === this.key && !resized) return false;
    if (!resized && !this.pace.due(now)) return true;
    this.key = key;
    this.drawStrip(view);
    return false;
  }

  /** Speed as a hill, familiar views below it, loops and lost frames as marks. */
  private drawStrip({ rows, colours }: View): void {
    const context = this.surface.clear();
    const { width, height } = this.surface;
    const count = rows.count;
    if (count < 2) return;
    const [speed, kind, action, tracking] = ['v', 'recognition', 'action', 'tracking'].map((c) =>
      rows.column(c)) as [Float64Array, Float64Array, Float64Array, Float64Array];
    let most = 1e-6;
    for (let i = 0; i < count; ++i) most = Math.max(most, Math.abs(speed[i] as number) || 0);
    const columns = Math.max(1, Math.floor(width));
    for (let x = 0; x < columns; ++x) {
      const from = Math.floor((x * count) / columns);
      const to = Math.max(from + 1, Math.floor(((x + 1) * count) / columns));
      let [fast, familiar, loop, lost] = [0, false, false, false];
      for (let i = from; i < to; ++i) {
        fast = Math.max(fast, Math.abs(speed[i] as number) || 0);
        familiar ||= kind[i] === 2;
        loop ||= action[i] === 2;
        lost ||= tracking[i] === 2;
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
