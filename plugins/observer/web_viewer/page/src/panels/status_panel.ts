// SPDX-License-Identifier: BSD-3-Clause
// Name of the run, state of the connection, and what to say when something is wrong.
import { byId, setAttribute, setText } from '../look/dom';
import type { Session } from '../model/session';
import type { Panel, View } from '../model/view';

interface Banner {
  readonly kind: 'info' | 'warning';
  readonly text: string;
}

export class StatusPanel implements Panel {
  private readonly name = byId('run-name');
  private readonly description = byId('run-description');
  private readonly pill = byId('link');
  private readonly pillText = byId('link-text');
  private readonly banner = byId('banner');

  constructor(private readonly session: Session) {}

  update(view: View, now: number): boolean {
    setText(this.name, view.info?.name ?? 'no run yet');
    setText(this.description, view.info?.description || view.info?.directory || '');
    const title = view.info ? `${view.info.name} · Tolman` : 'Tolman';
    if (document.title !== title) document.title = title;
    const [state, text] = this.state(view);
    setAttribute(this.pill, 'data-state', state);
    setText(this.pillText, text);
    const banner = this.trouble(now);
    this.banner.hidden = banner === null;
    if (banner !== null) {
      setText(this.banner, banner.text);
      setAttribute(this.banner, 'data-kind', banner.kind);
    }
    return this.session.trouble?.kind === 'gone'; // counts the seconds
  }

  private state(view: View): [string, string] {
    if (view.link === 'waiting' || view.link === 'connecting') {
      return [view.link, view.link === 'waiting' ? 'no server' : 'connecting'];
    }
    if (view.loading) return ['connecting', 'reading the history'];
    if (this.session.end === 'interrupted') return ['ended', 'run was interrupted'];
    if (this.session.end !== '' || view.link === 'ended') return ['ended', 'run has ended'];
    if (!view.live) return ['recorded', 'recorded run'];
    if (view.mode === 'live') return ['open', 'live'];
    return ['open', view.mode === 'playing' ? 'live, playing' : 'live, paused here'];
  }

  private trouble(now: number): Banner | null {
    const trouble = this.session.trouble;
    if (trouble === null) return null;
    if (trouble.kind === 'no_frames') {
      const text = 'The run has ended, and its server with it: no more images and activity. Numbers, plots and map stay. "tolman view" opens the recorded run.';
      return { kind: 'info', text };
    }
    const seconds = Math.max(0, Math.ceil((trouble.until - now) / 1000));
    const again = seconds > 0 ? `in ${seconds} s` : 'now';
    return {
      kind: 'warning',
      text: `The viewer's server does not answer. What was seen stays here; next attempt ${again}.`,
    };
  }
}
