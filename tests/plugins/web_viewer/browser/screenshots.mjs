// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the page, to look at: node screenshots.mjs URL FOLDER [row]
import { join } from 'node:path';
import { launch, openPage, untilSettled } from './browser.mjs';

const [url, folder, frame] = process.argv.slice(2);
const browser = await launch();
for (const colorScheme of ['light', 'dark']) {
  for (const [width, height] of [[1280, 800], [390, 844], [1680, 1050]]) {
    const page = await openPage(browser, url, { viewport: { width, height }, colorScheme });
    await untilSettled(page);
    if (frame !== undefined) {
      await page.locator('#scrub').fill(frame);
      await page.waitForFunction((f) => window.tolman.imageFrame === f, Number(frame));
    }
    await page.waitForTimeout(1500);
    const fullPage = width < 700;
    await page.screenshot({ path: join(folder, `${width}-${colorScheme}.png`), fullPage });
    if (page.complaints.length > 0) console.log(width, colorScheme, page.complaints);
    await page.context().close();
  }
}
await browser.close();
