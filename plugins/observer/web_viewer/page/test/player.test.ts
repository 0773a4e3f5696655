// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { Player } from '../src/model/player';

const kStamps = Float64Array.from({ length: 100 }, (_, i) => 50 + i / 10);

describe('the player', () => {
  it('follows the newest row until someone looks back', () => {
    const player = new Player();
    expect(player.grow(10)).toBe(true);
    expect(player.row).toBe(9);
    player.seek(3, 10);
    expect(player.grow(20)).toBe(false);
    expect([player.mode, player.row]).toEqual(['paused', 3]);
    player.follow(20);
    expect([player.mode, player.row]).toEqual(['live', 19]);
  });

  it('stays within what there is', () => {
    const player = new Player();
    player.seek(-5, 10);
    expect(player.row).toBe(0);
    player.seek(1000, 10);
    expect(player.row).toBe(9);
  });

  it('plays data time, at its speed, to the end', () => {
    const player = new Player();
    player.seek(10, 100);
    player.play(kStamps, 100);
    player.tick(0.2, kStamps, 100);
    expect(player.row).toBe(12);
    player.cycleSpeed(); // 2
    player.tick(0.2, kStamps, 100);
    expect(player.row).toBe(16);
    for (let i = 0; i < 100; ++i) player.tick(0.2, kStamps, 100);
    expect([player.mode, player.row]).toEqual(['paused', 99]);
  });

  it('plays from the start when it stands at the end', () => {
    const player = new Player();
    player.grow(100);
    player.play(kStamps, 100);
    expect(player.row).toBe(0);
  });

  it('does not leap after a long sleep', () => {
    const player = new Player();
    player.seek(0, 100);
    player.play(kStamps, 100);
    player.tick(3600, kStamps, 100);
    expect(player.row).toBeLessThan(5);
  });
});
