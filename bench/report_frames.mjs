// SPDX-License-Identifier: GPL-3.0-or-later
// How fluid the map of a report page is: times between frames while it is moved, zoomed and pointed at.
// Usage: node bench/report_frames.mjs REPORT.html [WIDTH HEIGHT]
// For 2,000 rooms: roomatlas simulate --random-rooms 2000 -o R; roomatlas assemble R/building.gpkg;
// roomatlas report R/building.gpkg -o REPORT.html
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { open } from '../tests/apps/browser/browser.mjs';

const [page, width = 1440, height = 1000] = process.argv.slice(2);
const profile = mkdtempSync(join(tmpdir(), 'roomatlas-frames-'));
const browser = await open(resolve(page), profile, width, height);
const { evaluate, mouse, pause } = browser;
process.stdout.write(`${browser.data.rooms.length} rooms, ${browser.data.doors.length} doors, open after ${((await browser.evaluate('performance.timing.loadEventEnd - performance.timing.navigationStart')) / 1000).toFixed(1)} s\n`);

const [x, y] = await browser.middleOf('#map');
const buttons = { button: 'left', buttons: 1, clickCount: 1 };
const whole = () => evaluate("void roomatlasMap.fitBounds(JSON.parse(document.getElementById('data').textContent).rooms.map(({ label }) => [label[1], label[0]]), { animate: false })");
const near = () => evaluate('void roomatlasMap.setZoom(5, { animate: false })');
async function measure(what, action) {
  await pause(500);
  await evaluate(`void (window.frames_ = [], window.measuring_ = true, requestAnimationFrame(function next(now) {
    window.frames_.push(now); if (window.measuring_) requestAnimationFrame(next); }))`);
  await action();
  const deltas = await evaluate('(window.measuring_ = false, window.frames_.slice(1).map((now, i) => now - window.frames_[i]))');
  deltas.sort((a, b) => a - b);
  const at = (share) => deltas[Math.min(deltas.length - 1, Math.floor(share * deltas.length))].toFixed(0).padStart(5);
  process.stdout.write(`${what.padEnd(28)} ${String(deltas.length).padStart(4)} frames, ms: median ${at(0.5)}  95 % ${at(0.95)}  longest ${at(1)}\n`);
}
async function drag() {
  await mouse('mousePressed', [x, y], buttons);
  for (let i = 1; i <= 60; ++i) await mouse('mouseMoved', [x + 150 * Math.sin(i / 10), y + 100 * Math.sin(i / 7)], buttons);
  await mouse('mouseReleased', [x, y], buttons);
}
async function wheel() {
  for (let i = 0; i < 40; ++i) await mouse('mouseWheel', [x + i, y], { deltaX: 0, deltaY: Math.floor(i / 10) % 2 ? 100 : -100 });
}
async function hover() {
  for (let i = 0; i < 120; ++i) await mouse('mouseMoved', [x + 250 * Math.sin(i / 19), y + 150 * Math.cos(i / 13)]);
}
async function keys() {
  await evaluate("document.getElementById('map').focus()");
  for (let i = 0; i < 20; ++i) await browser.key(['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown'][i % 4]);
}
for (const [where, go] of [['whole building', whole], ['near', near]]) {
  for (const [what, action] of [['drag', drag], ['wheel', wheel], ['point at', hover], ['arrow keys', keys]]) {
    await whole();
    await go();
    await measure(`${where}, ${what}`, action);
  }
}
await whole();
await evaluate("document.querySelectorAll('#layers input').forEach((box) => { if (!box.checked) box.click(); })");
for (const [what, action] of [['drag', drag], ['wheel', wheel], ['point at', hover]]) {
  await whole();
  await measure(`all layers, ${what}`, action);
}
if (await evaluate("document.querySelector('input[value=wall]') !== null")) {
  await browser.click('#edit');
  await browser.click('input[value="wall"]');
  await measure('moving a wall', async () => { await browser.clickPlace(browser.data.doors[0].at); await hover(); });
}
rmSync(profile, { recursive: true, force: true });
browser.close();
