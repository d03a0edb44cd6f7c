// SPDX-License-Identifier: GPL-3.0-or-later
// Rejects a match and pins two rooms on a report page.
// Usage: node closures.mjs PAGE PROFILE WIDTH HEIGHT
// Prints { edits, rejected: { from, to }, pinned: { first, second } }, the visits by their numbers.
import { open } from './browser.mjs';

const [page, profile, width, height] = process.argv.slice(2);
const browser = await open(page, profile, width, height);
const { click, clickPlace, data, evaluate } = browser;
const visit = (asr) => data.visits.find((one) => one.asr === asr);

// By its line: in the middle between the middles of both visits, the one that lies alone there.
const middle = ({ from, to }) => [0, 1].map((i) => (visit(from).middle.at[i] + visit(to).middle.at[i]) / 2);
const length = ({ from, to }) => Math.hypot(...[0, 1].map((i) => visit(from).middle.at[i] - visit(to).middle.at[i]));
const match = [...data.closures].sort((a, b) => length(b) - length(a))[0];
await click('#edit');
await click('input[value="reject"]');
await clickPlace(middle(match));
const chosen = Number(await evaluate("document.getElementById('edit-matches').value"));
await click('#edit-match button');
const rejected = data.closures[chosen];

await click('input[value="pin"]');
const rooms = data.rooms.filter((room) => data.visits.some((one) => one.room === room.id));
const [a, b] = [rooms[0], rooms[rooms.length - 1]];
await clickPlace(a.label);
await clickPlace(b.label);
// A place of the second room, and the same one a bit to the right.
await clickPlace(b.label);
await clickPlace([b.label[0] + 0.1, b.label[1]]);
const pinned = await evaluate("({ first: Number(document.getElementById('edit-first').value), second: Number(document.getElementById('edit-second').value) })");
await click('#edit-pin button');
process.stderr.write(`${await browser.hint()}\n${browser.complaints.join('\n')}`);
process.stdout.write(JSON.stringify({ edits: await browser.edits(), rejected, pinned }));
browser.close();
