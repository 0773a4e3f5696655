// SPDX-License-Identifier: BSD-3-Clause
// Debian's Chromium without a head, and a page that notes every complaint of the console.
import { chromium } from 'playwright-core';

export function launch() {
  return chromium.launch({
    executablePath: process.env.TOLMAN_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
}

/** `options` of a Playwright context; the page gets `complaints`. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !isGpuRemark(message.text())) {
      page.complaints.push(`${message.text()} (${message.location().url})`);
    }
  });
  page.on('pageerror', (error) => page.complaints.push(String(error)));
  await page.goto(url);
  return page;
}

/** Software rendering talks about itself. */
function isGpuRemark(text) {
  return /GPU stall|GL Driver Message|swiftshader/i.test(text);
}

export async function until(page, condition, argument) {
  await page.waitForFunction(condition, argument, { timeout: 120000, polling: 50 });
}

/** The page has all rows that the server has, and shows a frame. */
export async function untilCaughtUp(page, rows) {
  await until(page, (n) => window.tolman?.rows >= n && window.tolman.shownFrame >= 0, rows);
}

/** The map has its rows, its graph and its place. */
export async function untilSettled(page) {
  await untilCaughtUp(page, 1);
  let before = '';
  for (;;) {
    await page.waitForTimeout(500);
    const now = await page.evaluate(() => JSON.stringify([window.tolman.rows, window.tolman.map.zoom]));
    if (now === before) return;
    before = now;
  }
}

export const text = (page, name) => page.locator(`[data-testid="${name}"]`).innerText();

/** What is shown follows the state with the next drawing. */
export async function untilText(page, name, expected) {
  await page.locator(`[data-testid="${name}"]`, { hasText: expected }).waitFor();
}
