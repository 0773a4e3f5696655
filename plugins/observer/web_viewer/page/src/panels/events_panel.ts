// SPDX-License-Identifier: BSD-3-Clause
// Events up to the shown frame, newest first. List items are reused.
import { byId, byTestId, make, setAttribute, setText } from '../look/dom';
import { Pace, type Panel, type PageState } from '../model/page_state';
import type { LogEvent } from '../model/event_log';

const kShown = 60;

export class EventsPanel implements Panel {
  private readonly list = byId('events');
  private readonly count = byTestId('event-count');
  private readonly pace = new Pace(150);
  private readonly items: HTMLLIElement[] = [];
  private key = '';

  constructor(seekFrame: (frame: number) => void) {
    this.list.addEventListener('click', (event) => {
      const item = (event.target as Element).closest('li');
      if (item) seekFrame(Number(item.dataset['frame']));
    });
  }

  update(state: PageState, now: number): boolean {
    const key = `${state.events.edition} ${state.frame}`;
    if (key === this.key) return false;
    if (!this.pace.due(now)) return true;
    this.key = key;
    const events = state.events.newest(state.frame, kShown);
    while (this.items.length < events.length) this.items.push(this.makeItem());
    this.items.forEach((item, i) => this.fill(item, events[i]));
    setText(this.count, String(state.events.count));
    return false;
  }

  private makeItem(): HTMLLIElement {
    const item = make('li');
    const text = make('span');
    text.append(make('b'), ' ', make('small'));
    item.append(make('span'), text);
    this.list.append(item);
    return item;
  }

  private fill(item: HTMLLIElement, event: LogEvent | undefined): void {
    item.hidden = event === undefined;
    if (event === undefined) return;
    setAttribute(item, 'data-frame', String(event.frame));
    setAttribute(item, 'data-level', event.level);
    setText(item.firstElementChild as Element, String(event.frame));
    setText(item.querySelector('b') as Element, event.message);
    setText(item.querySelector('small') as Element, event.source);
  }
}
