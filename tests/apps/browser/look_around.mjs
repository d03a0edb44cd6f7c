// SPDX-License-Identifier: GPL-3.0-or-later
// Selects rooms, switches layers, searches and sorts on a report page.
// Usage: node look_around.mjs PAGE PROFILE WIDTH HEIGHT
// Prints what came of it in one line.
import { open } from './browser.mjs';

const [page, profile, width, height] = process.argv.slice(2);
const browser = await open(page, profile, width, height);
const { evaluate, data, click } = browser;
const report = [];
const rows = (what) => evaluate(`[...document.querySelectorAll('#rooms tbody tr')]${what}`);
const selected = () => rows(".filter((row) => row.classList.contains('selected')).map((row) => row.dataset.room).join()");
const painted = () => evaluate("document.querySelector('.leaflet-missions-pane canvas:not([hidden])').toDataURL()");
async function isPaintedAnew(before) {
  for (let i = 0; i < 100 && await painted() === before; ++i) await browser.pause(50);
  return await painted() !== before;
}
const isTicked = (id) => evaluate(`document.getElementById('layer-${id}').checked`);
async function show(id) {
  const before = await painted();
  if (!await isTicked(id)) await click(`#layer-${id}`);
  return before;
}

await click('#rooms tbody tr:nth-child(3)');
report.push(`row ${await selected()}`);
report.push(`highlighted ${await evaluate("document.querySelectorAll('.leaflet-missions-pane path[stroke-width=\"4\"]').length")}`);
await click('#rooms tbody tr:nth-child(1)');
await evaluate('void roomatlasMap.fitBounds([[-100, -100], [100, 100]])');
await evaluate(`void roomatlasMap.setView([${data.rooms[2].label[1]}, ${data.rooms[2].label[0]}], 5)`);
await browser.clickPlace(data.rooms[2].label);
report.push(`map ${await selected()}`);
await evaluate("document.querySelectorAll('#rooms tbody tr')[3].focus()");
await browser.key('ArrowDown');
await browser.key('Enter');
report.push(`key ${await selected()}`);
await evaluate('void roomatlasMap.setZoom(1)');
report.push(`seen ${await isPaintedAnew(await show('seen'))}`);
const corrected = await painted();
await click('#moment');  // its middle: half the way from odometry
report.push(`moved ${await isPaintedAnew(corrected)}`);
report.push(`ellipses ${await isPaintedAnew(await show('uncertainty'))}`);
await click('#search');
await browser.write('lab 315');
report.push(`found ${await rows('.filter((row) => !row.hidden).map((row) => row.dataset.room).join()')}`);
await click('#rooms th:nth-child(4) button');
report.push(`sorted ${await rows('.map((row) => Number(row.cells[3].textContent)).every((area, i, all) => i === 0 || all[i - 1] <= area)')}`);
for (const id of await evaluate("[...document.querySelectorAll('#layers input')].map((box) => box.id.slice(6))")) await show(id);
report.push(`layers ${await evaluate("[...document.querySelectorAll('#layers input:checked')].map((box) => box.id.slice(6)).join()")}`);
report.push(`wider than the window ${await browser.isTooWide()}`);
report.push(`fetched ${browser.requests.join(' ')}`, `complaints ${browser.complaints.join(' ')}`);
process.stdout.write(report.join('; '));
browser.close();
