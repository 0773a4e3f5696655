// SPDX-License-Identifier: BSD-3-Clause
// What happened up to the shown frame, newest first, in list items that are used again.
import { byId, byTestId, make, setAttribute, setText } from '../look/dom';
import { Pace, type Panel, type View } from '../model/view';
import type { LogEvent } from '../wire/messages';

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

  update(view: View, now: number): boolean {
    const key = `${view.events.edition} ${view.frame}`;
    if (key === this.key) return false;
    if (!this.pace.due(now)) return true;
    this.key = key;
    const events = view.events.newest(view.frame, kShown);
    while (this.items.length < events.length) this.items.push(this.makeItem());
    this.items.forEach((item, i) => this.fill(item, events[i]));
    setText(this.count, String(view.events.count));
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
