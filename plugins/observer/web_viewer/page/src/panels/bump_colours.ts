// SPDX-License-Identifier: BSD-3-Clause
// One colour for each label of bumps, in ring, sheet and legend.
import type { Colours } from '../look/theme';

const kColourOf: Readonly<Record<string, keyof Colours>> = {
  integrator: 'orange', calibration: 'sky', injected: 'vermilion', estimate: 'ink',
};

export function bumpColour(label: string, colours: Colours): string {
  return colours[kColourOf[label] ?? 'purple'];
}
