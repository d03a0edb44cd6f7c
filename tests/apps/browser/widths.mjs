// SPDX-License-Identifier: GPL-3.0-or-later
// A report page in windows from a phone's to a desk's, with each tool of the editor in hand.
// Usage: node widths.mjs PAGE PROFILE [FOLDER]
// Prints { tooWide: where the page scrolls sideways, tables, complaints }; pictures to the folder.
import { open } from './browser.mjs';

const [page, profile, folder] = process.argv.slice(2);
const browser = await open(page, profile, 1440, 1000);
const tooWide = [];
await browser.click('#edit');
const tools = await browser.evaluate("[...document.querySelectorAll('input[name=\"edit-tool\"]')].map((one) => one.value)");
for (const width of [390, 768, 1440]) {
  await browser.send('Emulation.setDeviceMetricsOverride', { width, height: 900, deviceScaleFactor: 1, mobile: false });
  for (const tool of tools) {
    await browser.click(`input[value="${tool}"]`);
    for (const room of browser.data.rooms) await browser.clickPlace(room.label);
    if (await browser.isTooWide()) tooWide.push(`${width} px, ${tool}`);
  }
  if (folder) {
    await browser.evaluate('window.scrollTo(0, 0)');
    await browser.picture(`${folder}/${width}.png`);
  }
}
process.stdout.write(JSON.stringify({ tooWide, complaints: browser.complaints,
  tables: await browser.evaluate("[...document.querySelectorAll('table')].filter((one) => one.rows.length && one.checkVisibility()).map((one) => one.id)") }));
browser.close();
