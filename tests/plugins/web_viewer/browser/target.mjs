// SPDX-License-Identifier: BSD-3-Clause
// What the specs look at: the server that TOLMAN_VIEWER_URL names, or a fake one of their own.
import { after, afterEach, before } from 'node:test';
import { launch } from './browser.mjs';
import { FakeServer } from './fake/server.mjs';

export const real = process.env.TOLMAN_VIEWER_URL;

/** Filled before the tests: url, browser, and fake (null for a real server). */
export function target(options = {}) {
  const t = { url: '', browser: null, fake: null };
  before(async () => {
    t.fake = real ? null : await new FakeServer(options).listen();
    t.url = (real ?? t.fake.url).replace(/\/$/, '');
    t.browser = await launch();
  });
  // A page left open goes on drawing, and slows the next one.
  afterEach(async () => {
    for (const context of t.browser.contexts()) await context.close();
  });
  after(async () => {
    await t.browser?.close();
    await t.fake?.close();
  });
  return t;
}
