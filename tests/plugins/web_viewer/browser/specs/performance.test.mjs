// SPDX-License-Identifier: BSD-3-Clause
// 4,541 frames and thousands of experiences stay fluid, and the page does not grow. How fluid is a
// measurement: it is printed, and judged only where TOLMAN_FRAME_RATE says how many frames/s must be.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { openPage, until, untilCaughtUp, untilSettled } from '../browser.mjs';
import { real, target } from '../target.mjs';

const wanted = Number(process.env.TOLMAN_FRAME_RATE ?? 0);

/** Pans for some seconds, a step each animation frame; frames and drawings of the map a second. */
function pan(page, seconds) {
  return page.evaluate(async (duration) => {
    const canvas = document.querySelector('#map');
    const box = canvas.getBoundingClientRect();
    const send = (type, i) => canvas.dispatchEvent(new PointerEvent(type, {
      pointerId: 1, pointerType: 'mouse', button: type === 'pointermove' ? -1 : 0, buttons: 1,
      clientX: box.x + box.width / 2 + 90 * Math.sin(i / 9), clientY: box.y + box.height / 2 + 60 * Math.cos(i / 7),
      bubbles: true,
    }));
    canvas.setPointerCapture = canvas.releasePointerCapture = () => undefined; // no real pointer here
    send('pointerdown', 0);
    const started = performance.now();
    const renders = window.tolman.map.renders;
    let frames = 0;
    while (performance.now() - started < 1000 * duration) {
      send('pointermove', ++frames);
      await new Promise(requestAnimationFrame);
    }
    const elapsed = (performance.now() - started) / 1000;
    send('pointerup', frames);
    return { frames: frames / elapsed, renders: (window.tolman.map.renders - renders) / elapsed };
  }, seconds);
}

describe('a long run', () => {
  const t = target({ start: 4541, frames: 4541, spacing: 0.5 });

  for (const dimension of ['2', '3']) {
    it(`pans in ${dimension}-D, drawing as it goes`, async () => {
      const page = await openPage(t.browser, t.url);
      await untilCaughtUp(page, real ? 1 : 4541);
      await until(page, () => window.tolman.graph.experiences > 0);
      await page.keyboard.press(dimension);
      await untilSettled(page);
      await pan(page, 1); // shaders are made
      const graph = await page.evaluate(() => window.tolman.graph);
      const rate = await pan(page, 4);
      console.log(`${dimension}-D: ${rate.frames.toFixed(1)} frames/s, ${rate.renders.toFixed(1)} drawings/s,`,
        `${graph.experiences} experiences, ${graph.links} links`);
      assert.ok(rate.frames >= wanted, `${rate.frames.toFixed(1)} frames/s`);
      assert.ok(rate.renders > 0 && rate.renders >= wanted, `${rate.renders.toFixed(1)} drawings/s`);
      assert.deepEqual(page.complaints, []);
    });
  }

  it('does nothing when nothing changes', { skip: real }, async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 4541);
    await page.waitForTimeout(1500);
    const before = await page.evaluate(() => window.tolman.map.renders);
    await page.waitForTimeout(1500);
    assert.ok((await page.evaluate(() => window.tolman.map.renders)) - before <= 1);
  });
});

describe('a long look at a live run', () => {
  const t = target({ start: 200, frames: 4541 });

  it('leaves as many elements as there were', { skip: real }, async () => {
    t.fake.play(150);
    const page = await openPage(t.browser, t.url);
    await until(page, () => window.tolman?.rows > 2500);
    const early = await page.evaluate(() => window.tolman.nodes);
    await until(page, () => window.tolman.rows > 4000);
    const late = await page.evaluate(() => window.tolman.nodes);
    assert.ok(late - early <= 5 * 60 + 20, `${early} then ${late}`); // the list of events may fill up
    assert.ok(late < 1200, `${late} elements`);
    assert.deepEqual(page.complaints, []);
  });
});
