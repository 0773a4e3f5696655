// SPDX-License-Identifier: BSD-3-Clause
// One colour for each kind of bump, in ring, sheet and legend.
import type { BumpKind } from '../model/cell_modules';
import type { Colours } from '../look/theme';

export function bumpColours(colours: Colours): Readonly<Record<BumpKind, string>> {
  return {
    integrator: colours.orange,
    calibration: colours.sky,
    injected: colours.vermilion,
    estimate: colours.ink,
  };
}
