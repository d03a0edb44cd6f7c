// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a report page in Chromium and corrects the plan by pointer and keyboard, through the
// DevTools protocol on a pipe. Usage: node click_edits.mjs PAGE PROFILE WIDTH HEIGHT [SCREENSHOT]
// Prints the statements that the page would save, as edits.json.
import { spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';

const [page, profile, width, height, screenshot] = process.argv.slice(2);
const chromium = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--remote-debugging-pipe',
  `--user-data-dir=${profile}`, `--window-size=${width},${height}`, '--host-resolver-rules=MAP * ~NOTFOUND', 'about:blank'],
{ stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
const waiting = new Map();
const events = [];
let last = 0;
let rest = '';
chromium.stdio[4].on('data', (chunk) => {
  const parts = (rest + chunk).split('\0');
  rest = parts.pop();
  for (const part of parts) {
    const message = JSON.parse(part);
    if (message.id) waiting.get(message.id)(message); else events.push(message);
  }
});
let session;
async function send(method, params = {}) {
  const id = ++last;
  const answer = new Promise((resolve) => { waiting.set(id, resolve); });
  chromium.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: session })}\0`);
  const { result, error } = await answer;
  if (error) throw new Error(`${method}: ${error.message}`);
  return result;
}
async function evaluate(expression) {
  const { result, exceptionDetails } = await send('Runtime.evaluate', { expression, returnByValue: true });
  if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
  return result.value;
}
async function press(x, y) {
  const point = { x, y, button: 'left', clickCount: 1 };
  await send('Input.dispatchMouseEvent', { type: 'mouseMoved', x, y });
  await send('Input.dispatchMouseEvent', { type: 'mousePressed', ...point });
  await send('Input.dispatchMouseEvent', { type: 'mouseReleased', ...point });
}
async function click(selector) {
  const { x, y } = await evaluate(`(() => { const e = document.querySelector(${JSON.stringify(selector)});
    e.scrollIntoView({ block: 'center' }); const r = e.getBoundingClientRect();
    return { x: r.x + r.width / 2, y: r.y + r.height / 2 }; })()`);
  await press(x, y);
}
/// Where a place of the building (metres) is on the screen.
async function clickPlace([x, y]) {
  const at = await evaluate(`(() => { document.getElementById('map').scrollIntoView({ block: 'center' });
    const r = document.getElementById('map').getBoundingClientRect();
    const p = roomatlasMap.latLngToContainerPoint([${y}, ${x}]);
    return { x: r.x + p.x, y: r.y + p.y }; })()`);
  await press(at.x, at.y);
}
async function key(name, code, modifiers = 0) {
  const what = { key: name, code: name, windowsVirtualKeyCode: code, modifiers };
  await send('Input.dispatchKeyEvent', { type: 'rawKeyDown', ...what });
  await send('Input.dispatchKeyEvent', { type: 'keyUp', ...what });
}
const tool = (name) => click(`input[value="${name}"]`);
const until = async (condition) => {
  while (!(await evaluate(condition))) await new Promise((resolve) => { setTimeout(resolve, 50); });
};

const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
session = (await send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
await send('Emulation.setDeviceMetricsOverride', { width: Number(width), height: Number(height), deviceScaleFactor: 1, mobile: false });
await send('Page.enable');
await send('Page.navigate', { url: `file://${page}` });
await until("document.readyState === 'complete' && typeof roomatlasMap !== 'undefined'");
const data = await evaluate("JSON.parse(document.getElementById('data').textContent)");
await click('#edit');
const [first, second] = data.rooms;
await clickPlace(first.label);
await send('Input.insertText', { text: 'Kitchen' });
await evaluate("document.getElementById('edit-kind').value = 'hall'");
await click('#edit-room button');
await tool('join');
await clickPlace(first.label);
await clickPlace(second.label);
await click('#edit-undo');
await click('#edit-redo');
await evaluate("document.getElementById('map').focus()");
await key('z', 90, 2);
await tool('shut');
await clickPlace(data.doors[0].at);
await tool('split');
const ring = second.parts[0][0];
const low = Math.min(...ring.map((p) => p[1]));
const high = Math.max(...ring.map((p) => p[1]));
const across = (Math.min(...ring.map((p) => p[0])) + Math.max(...ring.map((p) => p[0]))) / 2 + 0.8;
await clickPlace([across, low + 0.02]);
await clickPlace([across, high - 0.02]);
if (screenshot) {
  await evaluate("document.getElementById('map').scrollIntoView({ block: 'start' })");
  const { data: png } = await send('Page.captureScreenshot', { format: 'png' });
  writeFileSync(screenshot, Buffer.from(png, 'base64'));
}
const wide = await evaluate('document.documentElement.scrollWidth > window.innerWidth');
process.stderr.write(`wider than the window: ${wide}\n${await evaluate("document.getElementById('edit-hint').textContent")}\n`);
process.stdout.write(await evaluate('roomatlasEdits()'));
chromium.kill('SIGKILL');
process.exit(0);
