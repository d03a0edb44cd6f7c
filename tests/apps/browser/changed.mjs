// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses what changed between missions on a report page, by pointer and by key.
// Usage: node changed.mjs PAGE PROFILE
// Prints how many there are, and how far from the ringed place the middle of the map is each time.
import { open } from './browser.mjs';

const [page, profile] = process.argv.slice(2);
const browser = await open(page, profile, 1440, 1000);
const { evaluate, click } = browser;
const report = [`rows ${await evaluate("document.querySelectorAll('#changed tbody tr').length")}`];
const off = (row) => evaluate(`(() => {
  const told = document.querySelectorAll('#changed tbody tr')[${row}].cells[3].textContent.split(', ').map(Number);
  const { lng, lat } = roomatlasMap.getCenter();
  const rings = document.querySelectorAll('.leaflet-missions-pane path[stroke-width="4"]').length;
  return rings + ' ring, ' + (Math.hypot(lng - told[0], lat - told[1]) < 0.2 ? 'there' : 'elsewhere');
})()`);
await click('#changed tbody tr:nth-child(2)');
report.push(await off(1));
await evaluate("document.querySelectorAll('#changed tbody tr')[0].focus()");
await browser.key('Enter');
report.push(await off(0));
report.push(`complaints ${browser.complaints.join(' ')}`);
process.stdout.write(report.join('; '));
browser.close();
