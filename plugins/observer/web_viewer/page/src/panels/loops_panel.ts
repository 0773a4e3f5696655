// SPDX-License-Identifier: BSD-3-Clause
// Loops and near misses of the whole run, false links first; above them how many there are.
import { byId, byTestId, make, setText } from '../look/dom';
import { loopStories, type LoopStory } from '../model/loops';
import { Pace, type Panel, type PageState } from '../model/page_state';

const kShown = 400;

export class LoopsPanel implements Panel {
  private readonly list = byId('loops');
  private readonly verdict = byTestId('loops-verdict');
  private readonly pace = new Pace(1500);
  private key = '';

  constructor(seek: (frame: number) => void) {
    this.list.addEventListener('click', (event) => {
      const item = (event.target as Element).closest('li');
      if (item) seek(Number(item.dataset['frame']));
    });
  }

  update({ rows, graph }: PageState, now: number): boolean {
    const key = `${graph.edition} ${rows.count}`;
    if (key === this.key || rows.count === 0) return false;
    if (!this.pace.due(now)) return true;
    this.key = key;
    const stories = loopStories(rows, graph);
    setText(this.verdict, verdictOf(stories));
    const shown = [...stories.filter(isFalse), ...stories.filter((story) => !isFalse(story))];
    this.list.replaceChildren(...shown.slice(0, kShown).map(itemOf));
    return false;
  }
}

const isFalse = (story: LoopStory) => story.ending === 'kept' && story.isTrue === false;

function verdictOf(stories: readonly LoopStory[]): string {
  const kept = stories.filter(({ ending }) => ending === 'kept');
  const rejected = stories.filter(({ ending }) => ending === 'rejected').length;
  const unknown = kept.length > 0 && kept.every(({ isTrue }) => isTrue === null);
  const wrong = unknown ? 'truth unknown' : `${kept.filter(isFalse).length} false`;
  return `loop links: ${kept.length}, ${wrong} · rejected: ${rejected} · near misses: ${stories.length - kept.length - rejected}`;
}

function itemOf(story: LoopStory): HTMLLIElement {
  const item = make('li', { 'data-frame': String(story.frame), 'data-verdict': isFalse(story) ? 'false' : story.ending });
  const text = make('span');
  text.append(make('b', {}, story.ending), ' ', make('small', {}, story.text));
  item.append(make('span', {}, `${story.frame} → ${story.earlier < 0 ? '–' : story.earlier}`), text);
  return item;
}
