// SPDX-License-Identifier: BSD-3-Clause
// The numbers of the shown frame, along the top.
import { byId, make, setAttribute, setText } from '../look/dom';
import { choiceName, degrees, fixed, integer } from '../look/format';
import type { Panel, PageState } from '../model/page_state';
import { kChoices, type ColumnName } from '../wire/records';

interface Counter {
  readonly name: string;
  readonly label: string;
  unit?(state: PageState): string;
  text(state: PageState): string;
  tone?(state: PageState): string;
}

const kActions = kChoices['decision.action'];
const kActionTexts: Readonly<Record<(typeof kActions)[number], string>> = {
  stay: 'stay', create_experience: 'create', close_loop: 'loop',
};

function actionText(index: number): string {
  const action = kActions[index];
  return action === undefined ? '–' : kActionTexts[action];
}

const value = (state: PageState, column: ColumnName) => state.rows.value(state.row, column);

const kCounters: readonly Counter[] = [
  {
    name: 'tracking',
    label: 'odometry',
    text: (v) => choiceName('motion.state', value(v, 'motion.state')),
    tone: (v) => ['', 'good', 'warn'][value(v, 'motion.state')] ?? '',
  },
  { name: 'speed', label: 'speed', unit: (v) => (value(v, 'motion.scale_known') === 0 ? 'units/s' : 'm/s'), text: (v) => fixed(value(v, 'motion.v'), 2) },
  { name: 'tracked', label: 'tracked', text: (v) => integer(value(v, 'motion.tracked')) },
  { name: 'heading', label: 'heading', text: (v) => degrees(value(v, 'decision.heading')) },
  { name: 'templates', label: 'templates', text: (v) => integer(v.rows.templates(v.row)) },
  { name: 'experiences', label: 'experiences', text: (v) => integer(value(v, 'map_update.experiences')) },
  { name: 'links', label: 'links', text: (v) => integer(value(v, 'map_update.links')) },
  { name: 'loops', label: 'loops', text: (v) => integer(value(v, 'map_update.loops')) },
  { name: 'action', label: 'decision', text: (v) => actionText(value(v, 'decision.action')) },
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
      if (counter.unit) line.append(make('small'));
      cell.append(make('dt', {}, counter.label), line);
      root.append(cell);
      this.values.set(counter.name, number);
    }
  }

  update(state: PageState): boolean {
    for (const counter of kCounters) {
      const element = this.values.get(counter.name) as HTMLElement;
      setText(element, counter.text(state));
      if (counter.unit) setText(element.nextElementSibling as Element, counter.unit(state));
      if (counter.tone) setAttribute(element.parentElement as Element, 'data-tone', counter.tone(state));
    }
    return false;
  }
}
