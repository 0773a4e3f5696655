// SPDX-License-Identifier: BSD-3-Clause
// Every panel shows what the run says: the numbers on the page against those of the source.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { openPage, text, until, untilCaughtUp } from '../browser.mjs';
import * as source from '../source.mjs';
import { target } from '../target.mjs';

const kTracking = ['initialising', 'tracking', 'lost'];
const kRecognition = ['none', 'novel', 'familiar'];

async function show(page, at, frame) {
  await until(page, (last) => Number(document.querySelector('#scrub').max) >= last, at); // it follows the rows by a picture
  await page.locator('#scrub').fill(String(at));
  await until(page, (f) => document.querySelector('#shown-frame').textContent === String(f) &&
    window.tolman.mode === 'paused', frame);
}

const degrees = (heading) => `${((heading * 180) / Math.PI).toFixed(1)}°`;

async function compareCounters(page, row, rows) {
  const seen = async (name) => text(page, name);
  assert.equal(await seen('tracking'), kTracking[row['motion.state']]);
  assert.equal(await seen('speed'), row['motion.v'].toFixed(2).replace('-0.00', '0.00'));
  assert.equal(await seen('tracked'), String(row['motion.tracked']));
  assert.equal(await seen('heading'), degrees(row['decision.heading']));
  assert.equal(await seen('experiences'), String(row['map_update.experiences']));
  assert.equal(await seen('links'), String(row['map_update.links']));
  assert.equal(await seen('loops'), String(row['map_update.loops']));
  const past = rows.filter((r) => r['frame.frame'] <= row['frame.frame'] && r['place.template_id'] >= 0);
  assert.equal(Number(await seen('templates')), Math.max(-1, ...past.map((r) => r['place.template_id'])) + 1);
  assert.equal(await seen('shown-frame'), String(row['frame.frame']));
}

async function compareMatch(page, row, rows) {
  const judged = rows.filter((r) => r['frame.frame'] <= row['frame.frame'] && r['place.recognition'] > 0).at(-1);
  if (!judged || row['frame.frame'] - judged['frame.frame'] > 30) return;
  assert.equal(await text(page, 'template'), String(judged['place.template_id']));
  assert.equal(await text(page, 'recognition'), kRecognition[judged['place.recognition']]);
  assert.ok(Math.abs(Number(await text(page, 'score')) - judged['place.score']) <= 0.005 * Math.max(1, judged['place.score']));
}

async function compareTiming(page, row, rows) {
  const last = rows.filter((r) => r['frame.frame'] <= row['frame.frame']).slice(-300);
  for (const stage of ['source', 'odometry', 'place', 'cells', 'map']) {
    const values = last.map((r) => r[`duration.${stage}`]).filter(Number.isFinite).sort((a, b) => a - b);
    if (values.length === 0) continue;
    const middle = values.length >> 1;
    const median = values.length % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    for (const [name, value] of [['now', row[`duration.${stage}`]], ['median', median]]) {
      const shown = Number(await text(page, `${stage}-${name}`));
      assert.ok(Math.abs(shown - value) <= 0.0051 * Math.max(1, value), `${stage} ${name}: ${shown}, ${value}`);
    }
  }
}

async function compareCells(page, url, frame) {
  const { arrays } = await source.storedFrame(url, frame);
  for (const [name, { values }] of Object.entries(arrays)) {
    const module = name.match(/^cells\.(.*)\.activity$/)?.[1];
    if (!module) continue;
    const peak = values.indexOf(Math.max(...values));
    const shown = await page.getByTestId(name.replace('cells.', 'cells-')).getAttribute('data-peak');
    assert.equal(Number(shown), peak, module);
  }
}

function compareRecord(frame, row) {
  const record = source.recorded(frame);
  if (record === null) return;
  assert.equal(kTracking[row['motion.state']], record.motion.state);
  assert.equal(row['motion.tracked'], record.motion.tracked);
  assert.equal(kRecognition[row['place.recognition']], record.place.recognition);
  assert.equal(row['place.template_id'], record.place.template_id);
  assert.equal(row['decision.experience'], record.decision.experience);
  assert.ok(Math.abs(row['decision.heading'] - record.decision.heading) < 1e-9);
  for (const name of ['experiences', 'links', 'loops']) assert.equal(row[`map_update.${name}`], record.map_update[name]);
}

/** What does not hold after half a minute does not hold. */
async function eventually(check) {
  for (const started = Date.now(); ;) {
    try {
      return await check();
    } catch (error) {
      if (Date.now() - started > 30000) throw error;
      await new Promise((wake) => setTimeout(wake, 250));
    }
  }
}

describe('the numbers on the page', () => {
  const t = target({ start: 4000 });

  it('are those of the source, wherever one looks', async () => {
    const page = await openPage(t.browser, t.url);
    const rows = await source.allRows(t.url);
    await untilCaughtUp(page, rows.length);
    for (const share of [0.999, 0.75, 0.5, 0.31, 0]) {
      const at = Math.floor(share * (rows.length - 1));
      const row = rows[at];
      await show(page, at, row['frame.frame']);
      await until(page, (f) => !(window.tolman.imageFrame > f), row['frame.frame']);
      await eventually(async () => { // plots and lists take their time
        await compareCounters(page, row, rows);
        await compareMatch(page, row, rows);
        await compareTiming(page, row, rows);
        await compareCells(page, t.url, row['frame.frame']);
      });
      compareRecord(row['frame.frame'], row);
    }
    assert.deepEqual(page.complaints, []);
  });

  it('are those of the graph', async () => {
    const page = await openPage(t.browser, t.url);
    await untilCaughtUp(page, 1);
    await until(page, () => window.tolman.graph.experiences > 0);
    const graph = await source.graph(t.url);
    if (t.fake) assert.deepEqual(await page.evaluate(() => window.tolman.graph), graph);
    await eventually(async () => { // the map of a running run grows between two looks
      const shown = await page.evaluate(() => window.tolman.graph);
      assert.equal(Number(await text(page, 'graph-experiences')), shown.experiences);
      assert.equal(Number(await text(page, 'graph-loops')), shown.loops);
      assert.equal(Number(await text(page, 'graph-links')), shown.links - shown.loops - shown.rejected);
    });
  });

  it('keep every row bit for bit', async () => {
    const page = await openPage(t.browser, t.url);
    const rows = await source.allRows(t.url);
    await untilCaughtUp(page, rows.length);
    for (const at of [0, 1, Math.floor(rows.length / 2), rows.length - 1]) {
      const shown = await page.evaluate((i) => {
        const row = window.tolman.row(i);
        return Object.fromEntries(Object.entries(row).map(([k, v]) => [k, String(v)]));
      }, at);
      assert.deepEqual(shown, Object.fromEntries(Object.entries(rows[at]).map(([k, v]) => [k, String(v)])));
    }
  });
});
