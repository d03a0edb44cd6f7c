// SPDX-License-Identifier: GPL-3.0-or-later
// Moves walls on a report page. Usage: node move_wall.mjs PAGE PROFILE WIDTH HEIGHT X,Y X,Y HOW
// HOW: drag (by the mouse, from the one place to the other), click (the one, then the other),
// touch (as drag, by a finger), or a number (chooses the one, and writes by how much).
// Prints edits.json.
import { open } from './browser.mjs';

const [page, profile, width, height, first, second, how] = process.argv.slice(2);
const [from, to] = [first, second].map((text) => text.split(',').map(Number));
const browser = await open(page, profile, width, height, { touch: how === 'touch' });
if (how === 'touch') {
  await browser.touch('#edit');
  await browser.touch('input[value="wall"]');
  await browser.swipe([await browser.screenOf(from)], [await browser.screenOf(to)]);
} else {
  await browser.click('#edit');
  await browser.click('input[value="wall"]');
  if (how === 'drag') await browser.drag(await browser.screenOf(from), await browser.screenOf(to));
  else await browser.clickPlace(from);
  if (how === 'click') await browser.clickPlace(to);
  if (!isNaN(Number(how))) {
    await browser.evaluate("document.getElementById('edit-by').select()");
    await browser.evaluate("document.getElementById('edit-by').focus()");
    await browser.write(how);
    await browser.key('Enter');
  }
}
process.stderr.write(`${await browser.hint()}\n${browser.complaints.join('\n')}`);
process.stdout.write(JSON.stringify(await browser.edits()));
browser.close();
