// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { duration } from '../src/look/format';

describe('duration', () => {
  it('has the unit that fits', () => {
    expect(duration(0)).toBe('0.0 s');
    expect(duration(3.7)).toBe('3.7 s');
    expect(duration(59.96)).toBe('1:00 min');
    expect(duration(64.4)).toBe('1:04 min');
    expect(duration(3599.6)).toBe('1:00 h');
    expect(duration(3720)).toBe('1:02 h');
  });

  it('is a dash where it is not known', () => {
    expect(duration(NaN)).toBe('–');
  });
});
