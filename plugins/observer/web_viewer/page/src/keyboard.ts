// SPDX-License-Identifier: BSD-3-Clause
// The keys, and the table of them in the help.
import { byId, make } from './look/dom';

export interface KeyAction {
  readonly keys: readonly string[]; // values of KeyboardEvent.key
  readonly shown: string;
  readonly meaning: string;
  act(event: KeyboardEvent): void;
}

export function listen(actions: readonly KeyAction[]): void {
  const byKey = new Map(actions.flatMap((a) => a.keys.map((key) => [key, a] as const)));
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector('dialog[open]') !== null) return;
    const action = byKey.get(event.key);
    if (action === undefined || belongsToElement(event)) return;
    event.preventDefault();
    action.act(event);
  });
  fillHelp(actions);
}

/** Whether the focused element uses the key itself: space for a button, arrows for a list. */
function belongsToElement(event: KeyboardEvent): boolean {
  const element = event.target as Element;
  if (event.key === ' ') return element.matches('button, input[type=checkbox]');
  return element.matches('#events') && ['ArrowUp', 'ArrowDown', 'Home', 'End'].includes(event.key);
}

function fillHelp(actions: readonly KeyAction[]): void {
  const rows = actions.map(({ shown, meaning }) => {
    const row = make('tr');
    const keys = make('td');
    keys.append(...shown.split(' ').map((key) => make('kbd', {}, key)));
    row.append(keys, make('td', {}, meaning));
    return row;
  });
  byId('keys').replaceChildren(...rows);
}
