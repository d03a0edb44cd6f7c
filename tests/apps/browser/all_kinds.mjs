// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a statement of each kind on a report page of data/worlds/eight_rooms.geojson, by the mouse.
// Usage: node all_kinds.mjs PAGE PROFILE STEP
// STEP 1: all but wall_to_furniture; 2: that one, on the page of a plan in which a pillar stands.
// Prints edits.json.
import { open } from './browser.mjs';

const [page, profile, step] = process.argv.slice(2);
const browser = await open(page, profile, 1440, 1000);
const { click, clickPlace, data, evaluate, screenOf } = browser;
const label = (id) => data.rooms.find((room) => room.id === id).label;
const tool = (name) => click(`input[value="${name}"]`);
async function at(name, ...places) {
  await tool(name);
  for (const place of places) await clickPlace(place);
}
async function choose(id, value) {
  await evaluate(`(() => { const list = document.getElementById('${id}'); list.value = '${value}'; list.dispatchEvent(new Event('change')); })()`);
}

await click('#edit');
if (step === '1') {
  await at('name', label(9));
  await browser.write('Kitchen');
  await click('#edit-room button');
  await clickPlace(label(6));
  await choose('edit-kind', 'hall');
  await click('#edit-room button');
  await at('join', label(2), label(4));
  await at('split', [11.0, -0.65], [11.0, 4.05]);
  await at('shut', [2.6, 0.3], [6.7, 11.0]);
  await at('open', [6.7, 11.0]);
  await at('door', [-0.5, 6.8], [0.4, 6.8]);
  await tool('wall');
  await browser.drag(await screenOf([20.0, 3.92]), await screenOf([20.0, 4.31]));  // snaps to 0.2 m, in line with room 8
  await at('furniture', [18.5, 8.6]);
  await tool('reject');
  await choose('edit-matches', data.closures.findIndex(({ from, to }) => from === 28 && to === 41));
  await click('#edit-match button');
  await at('pin', label(1), label(2));
  await click('#edit-pin button');
} else {
  await at('pillar', [18.5, 8.6]);
}
process.stderr.write(`${await browser.hint()}\n${browser.complaints.join('\n')}`);
process.stdout.write(await evaluate('roomatlasEdits()'));
browser.close();
