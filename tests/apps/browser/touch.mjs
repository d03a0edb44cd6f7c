// SPDX-License-Identifier: GPL-3.0-or-later
// A report page under fingers: moves and zooms the map, corrects the plan.
// Usage: node touch.mjs PAGE PROFILE WIDTH HEIGHT
// Prints { edits, moved_m, expected_m, zoomed, small: controls that a finger would miss,
//          jumped: px that the page scrolled by a tap on the map, tooWide, fetched, complaints }.
import { open } from './browser.mjs';

const [page, profile, width, height] = process.argv.slice(2);
const browser = await open(page, profile, width, height, { touch: true });
const { evaluate, data, screenOf, swipe, touch, tapPlace } = browser;
const centre = () => evaluate('(({ lng, lat }) => [lng, lat])(roomatlasMap.getCenter())');
const zoom = () => evaluate('roomatlasMap.getZoom()');

const [first, second] = data.rooms;
const at = await screenOf(first.label);
const before = [await centre(), await zoom()];
await swipe([at], [[at[0] + 60, at[1] + 20]]);
const after = await centre();
const moved_m = Math.hypot(after[0] - before[0][0], after[1] - before[0][1]);
const scale = Math.pow(2, before[1]);
const middle = await browser.middleOf('#map');
await swipe([[middle[0] - 30, middle[1]], [middle[0] + 30, middle[1]]], [[middle[0] - 90, middle[1]], [middle[0] + 90, middle[1]]]);
const zoomed = await zoom() - before[1];
await swipe([[middle[0] - 90, middle[1]], [middle[0] + 90, middle[1]]], [[middle[0] - 25, middle[1]], [middle[0] + 25, middle[1]]]);
await evaluate(`void roomatlasMap.setView([${before[0][1]}, ${before[0][0]}], ${before[1]})`);

await touch('#edit');
const there = await screenOf(first.label);
const scrolled = await evaluate('window.scrollY');
await browser.tap(there);
const jumped = await evaluate('window.scrollY') - scrolled;
await browser.write('Kitchen');
await touch('#edit-room button');
await touch('input[value="join"]');
await tapPlace(first.label);
await tapPlace(second.label);
await touch('#edit-undo');
await touch('input[value="shut"]');
await tapPlace(data.doors[0].at);
await touch('#edit-undo');
await touch('#edit-redo');

const small = await evaluate(`[...document.querySelectorAll('button, input, select, summary, a')]
  .map((one) => (one.matches('[type=radio], [type=checkbox]') ? one.closest('label') : one))
  .filter((one) => one.checkVisibility()).map((one) => [one, one.getBoundingClientRect()])
  .filter(([, box]) => box.width < 40 || box.height < 40).map(([one, box]) => one.outerHTML.slice(0, 80) + ' ' + box.width + ' x ' + box.height)`);
process.stderr.write(await browser.hint());
process.stdout.write(JSON.stringify({ edits: await browser.edits(), moved_m, expected_m: Math.hypot(60, 20) / scale, zoomed, small, jumped,
  tooWide: await browser.isTooWide(), fetched: browser.requests, complaints: browser.complaints }));
browser.close();
