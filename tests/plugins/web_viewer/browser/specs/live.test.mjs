// SPDX-License-Identifier: BSD-3-Clause
// The page during a run: it follows, recovers from reloads and drops, and knows the end.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { openPage, text, until, untilCaughtUp, untilText } from '../browser.mjs';
import * as source from '../source.mjs';
import { real, target } from '../target.mjs';

/** Frames that the page has, and whether they are dense and ascending. */
function frames(page) {
  return page.evaluate(() => {
    const list = [];
    for (let i = 0; i < window.tolman.rows; ++i) list.push(window.tolman.row(i)['frame.frame']);
    return list;
  });
}

async function expectNoGaps(page, url) {
  const shown = await frames(page);
  const rows = (await source.allRows(url)).slice(0, shown.length);
  assert.deepEqual(shown, rows.map((r) => r['frame.frame']));
}

describe('a page that opens during a run', () => {
  const t = target({ start: 150 });

  it('has the past, follows the present and complains of nothing', async () => {
    t.fake?.play(10);
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    const before = await page.evaluate(() => window.tolman.rows);
    if (t.fake) await until(page, (n) => window.tolman.rows > n + 20, before);
    if (t.fake) await untilText(page, 'link', 'live');
    await expectNoGaps(page, t.url);
    assert.deepEqual(page.complaints, []);
  });

  it('recovers when it is loaded again in mid-run', async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    const before = await page.evaluate(() => window.tolman.rows);
    for (let i = 0; i < 3; ++i) {
      await page.reload();
      await untilCaughtUp(page, before);
    }
    await expectNoGaps(page, t.url);
    assert.deepEqual(page.complaints, []);
  });

  it('stays where one looks while the run goes on', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    await page.keyboard.press('Home');
    const before = await page.evaluate(() => window.tolman.rows);
    await until(page, (n) => window.tolman.rows > n + 20, before);
    assert.equal(await page.evaluate(() => window.tolman.shownFrame), 0);
    assert.ok([...t.fake.clients.values()].some((c) => !c.flow), 'no images asked for meanwhile');
    await page.keyboard.press('End');
    await until(page, () => window.tolman.mode === 'live' && window.tolman.imageFrame > 0);
    assert.deepEqual(page.complaints, []);
  });

  it('comes back after a drop, without gaps', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    // The page is connected again within a second: the banner is noted when it appears.
    await page.evaluate(() => {
      const banner = document.querySelector('#banner');
      window.shownBanner = '';
      new MutationObserver(() => {
        if (!banner.hidden) window.shownBanner = banner.textContent;
      }).observe(banner, { attributes: true, childList: true });
    });
    t.fake.drop();
    await until(page, () => /does not answer/.test(window.shownBanner));
    const before = await page.evaluate(() => window.tolman.rows);
    await until(page, (n) => window.tolman.rows > n + 20, before);
    await page.getByTestId('banner').waitFor({ state: 'hidden' });
    await expectNoGaps(page, t.url);
  });

  it('says when the run has ended, and plays it', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    t.fake.finish();
    await until(page, (n) => window.tolman.rows === n && !window.tolman.live, t.fake.rows);
    await untilText(page, 'link', 'run has ended');
    await page.keyboard.press('Home');
    await until(page, () => window.tolman.imageFrame === 0);
    await page.keyboard.press(' ');
    await until(page, () => window.tolman.shownFrame > 3 && window.tolman.mode === 'playing');
    await page.keyboard.press(' ');
    assert.equal(await page.evaluate(() => window.tolman.mode), 'paused');
    assert.deepEqual(page.complaints, []);
  });
});

describe('a recorded run', () => {
  const t = target({ start: 150, frames: 300, recorded: true });

  it('is not called live while its record is read', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await page.evaluate(() => {
      const link = document.querySelector('[data-testid="link"]');
      window.shownLinks = [];
      new MutationObserver(() => window.shownLinks.push(link.innerText))
        .observe(link, { characterData: true, childList: true, subtree: true });
    });
    await untilCaughtUp(page, 150);
    await untilText(page, 'link', 'reading the record');
    t.fake.play(300);
    await until(page, () => window.tolman.rows === 300);
    await untilText(page, 'link', 'recorded run');
    assert.deepEqual((await page.evaluate(() => window.shownLinks)).filter((text) => /live/.test(text)), []);
    assert.equal(await page.locator('#live').innerText(), 'Newest');
    assert.deepEqual(page.complaints, []);
  });
});

describe('a run of unknown scale', () => {
  const t = target({ start: 600, frames: 600, scale: 0.25 });

  it('is drawn in metres of the truth', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 600);
    await untilText(page, 'map-foot', 'fitted, 1 unit is');
    const scale = Number((await text(page, 'map-foot')).match(/unit is ([\d.]+) m/)[1]);
    assert.ok(Math.abs(scale - 4) < 0.05, `${scale}`);
    await page.locator('#align').click();
    await until(page, () => / units$/.test(document.querySelector('[data-testid="scale"]').innerText));
    assert.deepEqual(page.complaints, []);
  });
});

describe('a page without server', () => {
  const t = target({ start: 150, frames: 900 });

  it('keeps what it has and says that nobody answers', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    await t.fake.close();
    await page.getByTestId('banner').waitFor({ state: 'visible' });
    await untilText(page, 'link', 'no server'); // between two attempts it says "connecting"
    assert.equal(await page.evaluate(() => window.tolman.rows), 150);
    await t.fake.listen(t.fake.port);
    await until(page, () => document.querySelector('[data-testid="link"]').innerText === 'live');
  });
});

describe('a run without images', () => {
  const t = target({ start: 150, frames: 300, images: false });

  it('asks for none and complains of nothing', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 150);
    await page.keyboard.press('Home');
    await page.keyboard.press('ArrowRight');
    await until(page, () => window.tolman.shownFrame === 1);
    await page.waitForTimeout(300);
    assert.ok(!t.fake.requests.some((r) => r.startsWith('/api/template')));
    assert.deepEqual(page.complaints, []);
  });
});
