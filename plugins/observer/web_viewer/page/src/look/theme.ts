// SPDX-License-Identifier: BSD-3-Clause
// Light or dark: the system's setting until the user chooses. Drawings take their colours here;
// the style sheet is the one place that defines them.

export type ThemeName = 'light' | 'dark';

const kTokens = [
  'ink', 'soft', 'faint', 'line', 'panel', 'well', 'blue', 'orange', 'green', 'vermilion',
  'purple', 'sky', 'grey', 'accent', 'truth', 'rejected',
] as const;
type Token = (typeof kTokens)[number];
export type Colours = Readonly<Record<Token, string>>;

const kKey = 'tolman.theme';

export class Theme {
  private readonly system = matchMedia('(prefers-color-scheme: dark)');
  private chosen: ThemeName | null = null;
  private colours_: Colours;

  constructor(private readonly changed: () => void) {
    this.chosen = stored();
    this.system.addEventListener('change', () => this.apply());
    this.colours_ = this.show();
  }

  get name(): ThemeName {
    return this.chosen ?? (this.system.matches ? 'dark' : 'light');
  }
  get colours(): Colours {
    return this.colours_;
  }

  toggle(): void {
    this.chosen = this.name === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(kKey, this.chosen);
    } catch {
      // Private windows may refuse: the choice then lasts as long as the page.
    }
    this.apply();
  }

  private apply(): void {
    this.colours_ = this.show();
    this.changed();
  }

  private show(): Colours {
    document.documentElement.dataset['theme'] = this.name;
    const style = getComputedStyle(document.documentElement);
    const entries = kTokens.map((t) => [t, style.getPropertyValue(`--${t}`).trim()] as const);
    return Object.fromEntries(entries) as Record<Token, string>;
  }
}

function stored(): ThemeName | null {
  try {
    const value = localStorage.getItem(kKey);
    return value === 'light' || value === 'dark' ? value : null;
  } catch {
    return null;
  }
}
