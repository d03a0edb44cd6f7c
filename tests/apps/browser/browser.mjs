// SPDX-License-Identifier: GPL-3.0-or-later
// A report page in Chromium, used as people use it: pointer, fingers, keys, a screen reader's tree;
// through the DevTools protocol on a pipe.
import { spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';

const pause = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

export async function open(page, profile, width, height, { touch = false } = {}) {
  const chromium = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--remote-debugging-pipe',
    `--user-data-dir=${profile}`, `--window-size=${width},${height}`, '--host-resolver-rules=MAP * ~NOTFOUND', 'about:blank'],
  { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const waiting = new Map();
  const requests = [];
  const complaints = [];
  let last = 0;
  let rest = '';
  let session;
  function hear({ id, method, params, ...message }) {
    if (id) waiting.get(id)(message);
    if (method === 'Network.requestWillBeSent' && params.type !== 'Document' && !/^(data|blob):/.test(params.request.url)) requests.push(params.request.url);
    if (method === 'Runtime.exceptionThrown') complaints.push(params.exceptionDetails.exception.description);
    if (method === 'Log.entryAdded' && params.entry.level === 'error') complaints.push(params.entry.text);
  }
  chromium.stdio[4].on('data', (chunk) => {
    const parts = (rest + chunk).split('\0');
    rest = parts.pop();
    for (const part of parts) hear(JSON.parse(part));
  });
  async function send(method, params = {}) {
    const id = ++last;
    const answer = new Promise((resolve) => { waiting.set(id, resolve); });
    chromium.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: session })}\0`);
    const { result, error } = await answer;
    if (error) throw new Error(`${method}: ${error.message}`);
    return result;
  }
  async function evaluate(expression) {
    const { result, exceptionDetails } = await send('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
    return result.value;
  }
  async function until(condition) {
    for (let i = 0; i < 400; ++i, await pause(50)) if (await evaluate(condition)) return;
    throw new Error(`never: ${condition}`);
  }
  const mouse = (type, [x, y], more = {}) => send('Input.dispatchMouseEvent', { type, x, y, ...more });
  const left = { button: 'left', buttons: 1, clickCount: 1 };
  const fingers = (type, points) => send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const between = (a, b, share) => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];

  /// The middle of an element, scrolled into view.
  const middleOf = (selector) => evaluate(`(() => { const e = document.querySelector(${JSON.stringify(selector)});
    e.scrollIntoView({ block: 'center' }); const r = e.getBoundingClientRect();
    return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
  /// Where a place of the building (metres) is on the screen.
  const screenOf = ([x, y]) => evaluate(`(() => { const map = document.getElementById('map');
    map.scrollIntoView({ block: 'center' }); const r = map.getBoundingClientRect();
    const p = roomatlasMap.latLngToContainerPoint([${y}, ${x}]); return [r.x + p.x, r.y + p.y]; })()`);
  async function press(at) {
    await mouse('mouseMoved', at);
    await mouse('mousePressed', at, left);
    await mouse('mouseReleased', at, left);
  }
  async function tap(at) {
    await fingers('touchStart', [at]);
    await fingers('touchEnd', []);
    await pause(400);  // a second tap sooner would be a double tap
  }
  async function drag(from, to) {
    await mouse('mouseMoved', from);
    await mouse('mousePressed', from, left);
    for (let i = 1; i <= 5; ++i) await mouse('mouseMoved', between(from, to, i / 5), left);
    await mouse('mouseReleased', to, left);
  }
  /// Fingers that go from places to places together.
  async function swipe(from, to) {
    await fingers('touchStart', from);
    for (let i = 1; i <= 8; ++i, await pause(20)) await fingers('touchMove', from.map((one, k) => between(one, to[k], i / 8)));
    await fingers('touchEnd', []);
    await pause(400);
  }
  const codes = { Enter: 13, Escape: 27, Tab: 9, ' ': 32, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 };
  async function key(name, modifiers = 0) {
    const code = codes[name] || name.toUpperCase().charCodeAt(0);
    const text = name === 'Enter' ? '\r' : name === ' ' ? ' ' : undefined;
    const what = { key: name, code: name, windowsVirtualKeyCode: code, modifiers };
    await send('Input.dispatchKeyEvent', { type: text ? 'keyDown' : 'rawKeyDown', ...what, text });
    await send('Input.dispatchKeyEvent', { type: 'keyUp', ...what });
  }
  const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
  session = (await send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
  await send('Emulation.setDeviceMetricsOverride', { width: Number(width), height: Number(height), deviceScaleFactor: 1, mobile: touch });
  if (touch) await send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
  for (const domain of ['Page', 'Network', 'Runtime', 'Log', 'Accessibility']) await send(`${domain}.enable`);
  await send('Page.navigate', { url: `file://${page}` });
  await until("document.readyState === 'complete' && typeof roomatlasMap !== 'undefined'");

  return {
    send, evaluate, until, middleOf, screenOf, press, tap, drag, swipe, key, pause, requests, complaints, mouse,
    data: await evaluate("JSON.parse(document.getElementById('data').textContent)"),
    click: async (selector) => press(await middleOf(selector)),
    touch: async (selector) => tap(await middleOf(selector)),
    clickPlace: async (at) => press(await screenOf(at)),
    tapPlace: async (at) => tap(await screenOf(at)),
    write: (text) => send('Input.insertText', { text }),
    hint: () => evaluate("document.getElementById('edit-hint').textContent"),
    edits: async () => JSON.parse(await evaluate('roomatlasEdits()')),
    isTooWide: () => evaluate('document.documentElement.scrollWidth > window.innerWidth'),
    async picture(file) {
      const { data } = await send('Page.captureScreenshot', { format: 'png' });
      writeFileSync(file, Buffer.from(data, 'base64'));
    },
    close() {
      chromium.kill('SIGKILL');
      process.exit(0);
    },
  };
}
