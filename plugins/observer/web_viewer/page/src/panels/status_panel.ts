// SPDX-License-Identifier: BSD-3-Clause
// Name of the run, state of the connection, and a banner for errors.
import { byId, setAttribute, setText } from '../look/dom';
import type { RunModel } from '../model/run_model';
import type { Panel, PageState } from '../model/page_state';

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

  constructor(private readonly model: RunModel) {}

  update(state: PageState, now: number): boolean {
    setText(this.name, state.info?.name ?? 'no run yet');
    setText(this.description, state.info?.source.description || state.info?.directory || '');
    const title = state.info ? `${state.info.name} · Tolman` : 'Tolman';
    if (document.title !== title) document.title = title;
    const [kind, text] = this.connection(state);
    setAttribute(this.pill, 'data-state', kind);
    setText(this.pillText, text);
    const banner = this.trouble(now);
    this.banner.hidden = banner === null;
    if (banner !== null) {
      setText(this.banner, banner.text);
      setAttribute(this.banner, 'data-kind', banner.kind);
    }
    return this.model.trouble?.kind === 'gone'; // counts the seconds
  }

  private connection(state: PageState): [string, string] {
    if (state.link === 'waiting' || state.link === 'connecting') {
      return [state.link, state.link === 'waiting' ? 'no server' : 'connecting'];
    }
    if (state.loading) return ['connecting', state.recorded ? 'reading the record' : 'reading the history'];
    if (state.recorded && state.link === 'open') return ['recorded', 'recorded run'];
    if (this.model.end === 'interrupted') return ['ended', 'run was interrupted'];
    if (this.model.end !== '' || state.link === 'ended') return ['ended', 'run has ended'];
    if (!state.live) return ['recorded', 'recorded run'];
    if (state.mode === 'live') return ['open', 'live'];
    return ['open', state.mode === 'playing' ? 'live, playing' : 'live, paused here'];
  }

  private trouble(now: number): Banner | null {
    const trouble = this.model.trouble;
    if (trouble === null) return null;
    if (trouble.kind === 'no_frames') {
      const text = 'The run and its server have ended: images and activity of past frames are no longer available. "tolman view" shows the recorded run.';
      return { kind: 'info', text };
    }
    if (trouble.kind === 'other_version') {
      return { kind: 'warning', text: 'The server is of another version than this page. Reload the page.' };
    }
    const seconds = Math.max(0, Math.ceil((trouble.until - now) / 1000));
    const again = seconds > 0 ? `in ${seconds} s` : 'now';
    return {
      kind: 'warning',
      text: `The server does not answer. Next attempt ${again}.`,
    };
  }
}
