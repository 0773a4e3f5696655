// SPDX-License-Identifier: BSD-3-Clause
// The numbers along the top.
import { byId, make, setAttribute, setText } from '../look/dom';
import { degrees, fixed, integer, kActionNames, kTrackingNames, nameOf } from '../look/format';
import type { Panel, View } from '../model/view';

interface Counter {
  readonly name: string;
  readonly label: string;
  readonly unit?: string;
  text(view: View): string;
  tone?(view: View): string;
}

const value = (view: View, column: string) => view.rows.value(view.row, column);

const kCounters: readonly Counter[] = [
  {
    name: 'tracking',
    label: 'odometry',
    text: (v) => nameOf(kTrackingNames, value(v, 'tracking')),
    tone: (v) => ['', 'good', 'warn'][value(v, 'tracking')] ?? '',
  },
  { name: 'speed', label: 'speed', unit: 'm/s', text: (v) => fixed(value(v, 'v'), 2) },
  { name: 'tracked', label: 'tracked', text: (v) => integer(value(v, 'tracked')) },
  { name: 'heading', label: 'heading', text: (v) => degrees(value(v, 'heading')) },
  { name: 'templates', label: 'templates', text: (v) => integer(v.rows.templates(v.row)) },
  { name: 'experiences', label: 'experiences', text: (v) => integer(value(v, 'experiences')) },
  { name: 'links', label: 'links', text: (v) => integer(value(v, 'links')) },
  { name: 'loops', label: 'loops', text: (v) => integer(value(v, 'loops')) },
  { name: 'action', label: 'decision', text: (v) => nameOf(kActionNames, value(v, 'action')) },
  { name: 'rate', label: 'frames/s', text: (v) => (v.live ? fixed(v.rate, 1) : '–') },
  { name: 'dropped', label: 'dropped', text: (v) => integer(v.dropped) },
];

export class CountersPanel implements Panel {
  private readonly values = new Map<string, HTMLElement>();

  constructor() {
    const root = byId('counters');
    for (const counter of kCounters) {
      const cell = make('div', { class: `counter-${counter.name}` });
      const number = make('span', { 'data-testid': counter.name });
      const line = make('dd');
      line.append(number);
      if (counter.unit) line.append(make('small', {}, counter.unit));
      cell.append(make('dt', {}, counter.label), line);
      root.append(cell);
      this.values.set(counter.name, number);
    }
  }

  update(view: View): boolean {
    for (const counter of kCounters) {
      const element = this.values.get(counter.name) as HTMLElement;
      setText(element, counter.text(view));
      if (counter.tone) setAttribute(element.parentElement as Element, 'data-tone', counter.tone(view));
    }
    return false;
  }
}
