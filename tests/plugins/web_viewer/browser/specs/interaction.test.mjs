// SPDX-License-Identifier: BSD-3-Clause
// Pan, zoom, turn, scrub, keys, small screens.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { openPage, until, untilCaughtUp, untilSettled, untilText } from '../browser.mjs';
import { target } from '../target.mjs';

const map = (page) => page.evaluate(() => window.tolman.map);

async function drag(page, dx, dy) {
  const box = await page.locator('#map').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 8 });
  await page.mouse.up();
}

describe('interaction with the page', () => {
  const t = target({ start: 3600 });

  it('pan the map by as much as they move', async () => {
    const page = await openPage(t.browser, t.url);
    await untilSettled(page);
    const before = await map(page);
    await drag(page, 80, -40);
    const after = await map(page);
    assert.ok(Math.abs((before.centre[0] - after.centre[0]) * before.zoom - 80) < 1.5);
    assert.ok(Math.abs((before.centre[1] - after.centre[1]) * before.zoom - 40) < 1.5);
    assert.equal(after.zoom, before.zoom);
    await page.keyboard.press('f');
    await until(page, (z) => Math.abs(window.tolman.map.zoom - z) < 1e-6, before.zoom);
    assert.ok(Math.abs((await map(page)).centre[0] - before.centre[0]) < 1e-6);
    assert.deepEqual(page.complaints, []);
  });

  it('zoom by wheel and keys', async () => {
    const page = await openPage(t.browser, t.url);
    await untilSettled(page);
    const { zoom } = await map(page);
    await page.keyboard.press('+');
    await until(page, (z) => Math.abs(window.tolman.map.zoom / z - 1.25) < 1e-6, zoom);
    await page.keyboard.press('-');
    await page.locator('#map').hover();
    await page.mouse.wheel(0, -600);
    await until(page, (z) => window.tolman.map.zoom > 1.05 * z, zoom);
  });

  it('choose a loop: its frame is shown, beside the matched view', async () => {
    const page = await openPage(t.browser, t.url);
    await untilSettled(page);
    const { loops, rejected } = await page.evaluate(() => window.tolman.graph);
    await untilText(page, 'loops-verdict', new RegExp(`^loop links: ${loops}, .* rejected: ${rejected} `));
    const row = page.locator('#loops li').first();
    const frame = Number(await row.getAttribute('data-frame'));
    await row.click();
    await until(page, (f) => window.tolman.imageFrame === f, frame);
    await until(page, () => document.getElementById('template').naturalWidth > 0);
    assert.deepEqual(page.complaints, []);
  });

  it('turn the map in space and keep its rows', async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 1);
    await page.keyboard.press('3');
    await until(page, () => window.tolman.map.dimension === '3d');
    const { renders } = await map(page);
    await drag(page, 60, 30);
    await until(page, (n) => window.tolman.map.renders > n + 3, renders);
    await page.keyboard.press('2');
    await until(page, () => window.tolman.map.dimension === '2d');
    assert.deepEqual(page.complaints, []);
  });

  it('scrub by slider, keys, plot and list', async () => {
    const page = await openPage(t.browser, t.url);
    await until(page, () => Number(document.querySelector('#scrub').max) >= 191); // it follows the rows by a picture
    await page.locator('#scrub').fill('100');
    await until(page, () => window.tolman.shownFrame === window.tolman.row(100)['frame.frame']);
    await page.keyboard.press('ArrowRight');
    await until(page, () => window.tolman.shownFrame === window.tolman.row(101)['frame.frame']);
    await page.keyboard.press('Shift+ArrowLeft');
    await until(page, () => window.tolman.shownFrame === window.tolman.row(91)['frame.frame']);
    await page.keyboard.press('PageDown');
    await until(page, () => window.tolman.shownFrame === window.tolman.row(191)['frame.frame']);
    await page.keyboard.press('Home');
    await until(page, () => window.tolman.shownFrame === window.tolman.row(0)['frame.frame']);
    await page.locator('#templates .u-over').click();
    await until(page, () => window.tolman.shownFrame > window.tolman.row(0)['frame.frame']);
    await page.keyboard.press('l');
    await until(page, () => window.tolman.mode === 'live');
    await page.waitForTimeout(1000); // the list takes its time
    const event = page.locator('#events li').first();
    const frame = Number(await event.getAttribute('data-frame'));
    await event.click();
    await until(page, (f) => window.tolman.shownFrame === f, frame);
    assert.deepEqual(page.complaints, []);
  });

  it('choose light or dark, layers, torus and help', async () => {
    const page = await openPage(t.browser, t.url, { colorScheme: 'light' });
    await untilCaughtUp(page, 1);
    const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
    assert.equal(await theme(), 'light');
    await page.keyboard.press('t');
    assert.equal(await theme(), 'dark');
    await page.reload();
    await untilCaughtUp(page, 1);
    assert.equal(await theme(), 'dark');
    await page.locator('#layer-odometry').click();
    assert.ok(!(await page.locator('#layer-odometry input').isChecked()));
    await page.keyboard.press('g');
    await page.keyboard.press('?');
    assert.ok(await page.getByRole('dialog').isVisible());
    await page.keyboard.press('Escape');
    assert.deepEqual(page.complaints, []);
  });

  it('hold a phone: one column, nothing to scroll sideways', async () => {
    const page = await openPage(t.browser, t.url, { viewport: { width: 390, height: 844 }, hasTouch: true });
    await untilCaughtUp(page, 1);
    await page.waitForTimeout(500);
    const sizes = await page.evaluate(() => ({
      inner: window.innerWidth,
      wide: document.documentElement.scrollWidth,
      lefts: [...document.querySelectorAll('.panel')].map((p) => p.getBoundingClientRect().left),
      outside: [...document.querySelectorAll('body *')].filter((e) => e.checkVisibility() &&
        e.getBoundingClientRect().right > window.innerWidth + 1).length,
    }));
    assert.ok(sizes.wide <= sizes.inner, `${sizes.wide} of ${sizes.inner}`);
    assert.equal(new Set(sizes.lefts).size, 1);
    assert.equal(sizes.outside, 0);
    assert.deepEqual(page.complaints, []);
  });

  it('find a name for everything that can be used', async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 1);
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, input, canvas, [role=img], section')]
        .filter((e) => e.getAttribute('aria-hidden') !== 'true' && e.checkVisibility())
        .filter((e) => !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') || e.textContent.trim()))
        .map((e) => e.outerHTML.slice(0, 80)));
    assert.deepEqual(nameless, []);
  });
});
