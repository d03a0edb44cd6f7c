// SPDX-License-Identifier: GPL-3.0-or-later
// A report page by keyboard alone, and as a screen reader has it.
// Usage: node keyboard.mjs PAGE PROFILE WIDTH HEIGHT
// Prints { edits, reached: what the tab key stops at, unseen: stops without a visible focus,
//          nameless: controls without a name, pictures, rows: of rooms, announced, live }.
import { open } from './browser.mjs';

const [page, profile, width, height] = process.argv.slice(2);
const browser = await open(page, profile, width, height);
const { evaluate, key, data } = browser;
const focused = () => evaluate('document.activeElement.id || document.activeElement.value || document.activeElement.dataset.room || document.activeElement.textContent');
const SHIFT = 8;
const CTRL = 2;

async function tabTo(id, modifiers = 0) {
  for (let i = 0; i < 200; ++i) {
    await key('Tab', modifiers);
    if (await focused() === id) return;
  }
  throw new Error(`the tab key does not reach ${id}`);
}
/// Moves the map until the cross is on a place.
async function crossTo([x, y]) {
  for (let i = 0; i < 400; ++i) {
    const [dx, dy] = await evaluate(`(() => { const p = roomatlasMap.latLngToContainerPoint([${y}, ${x}]);
      const c = roomatlasMap.getSize().divideBy(2); return [p.x - c.x, p.y - c.y]; })()`);
    const [off, name] = Math.abs(dx) > Math.abs(dy) ? [dx, dx > 0 ? 'ArrowRight' : 'ArrowLeft'] : [dy, dy > 0 ? 'ArrowDown' : 'ArrowUp'];
    if (Math.abs(off) <= 2) return;
    await key(name, Math.abs(off) < 13 ? SHIFT : 0);
  }
  throw new Error('the cross does not get there');
}
const tools = ['name', 'join', 'split', 'shut', 'open', 'door', 'wall', 'furniture', 'pillar', 'reject', 'pin'];
/// From the map to a tool and back to the map.
async function tool(name) {
  await tabTo('edit');
  await key('Tab');
  const now = tools.indexOf(await focused());
  for (let i = now; i < tools.indexOf(name); ++i) await key('ArrowDown');
  for (let i = now; i > tools.indexOf(name); --i) await key('ArrowUp');
  if (await focused() !== name) throw new Error(`the arrow keys do not reach ${name}`);
  await tabTo('map', SHIFT);
}
const announced = [];
const hear = async () => announced.push(await browser.hint());

const [first, second] = data.rooms;
await tabTo('edit');
await key('Enter');
await hear();
await tabTo('map', SHIFT);
await crossTo(first.label);
await key('Enter');
await browser.write('Kitchen');
await key('Enter');
await hear();
await tool('join');  // let go by Esc, half done
await crossTo(first.label);
await key('Enter');
await key('Escape');
await hear();
await tool('wall');
const { at } = data.doors[0];
await crossTo([at[0] - 0.05, at[1] + 1.1]);
await key('Enter');
await browser.write('0.2');
await key('Enter');
await hear();
await tabTo('map', SHIFT);
await key('z', CTRL);
await hear();
await key('y', CTRL);
await hear();
await tool('shut');
await crossTo(at);
await key('Enter');
await hear();

// What the tab key stops at, once around.
for (let i = 0; i < 300 && await evaluate('document.activeElement !== document.body'); ++i) await key('Tab');
const reached = [];
const unseen = [];
for (let i = 0; i < 300; ++i) {
  await key('Tab');
  const [tag, name, ring] = await evaluate(`(() => { const one = document.activeElement; const style = getComputedStyle(one);
    return [one.tagName, one.id || one.value || one.dataset.room || one.textContent, style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2]; })()`);
  if (tag === 'BODY') break;
  reached.push(name);
  if (!ring) unseen.push(name);
}

const { nodes } = await browser.send('Accessibility.getFullAXTree');
const all = nodes.map((node) => ({ id: node.nodeId, parent: node.parentId, children: node.childIds || [], isHeard: !node.ignored,
  role: node.role.value, name: (node.name || { value: '' }).value, live: (node.properties || []).some(({ name, value }) => name === 'live' && value.value === 'polite') }));
const byId = new Map(all.map((node) => [node.id, node]));
const heard = all.filter(({ isHeard }) => isHeard);
const controls = /^(button|radio|checkbox|textbox|searchbox|combobox|listbox|spinbutton|slider|link|application|grid)$/;
const isOfRooms = (node) => Boolean(node) && (node.role === 'grid' ? node.name.startsWith('Rooms') : isOfRooms(byId.get(node.parent)));
const named = (node) => node.children.map((id) => byId.get(id)).filter(Boolean).map(({ name }) => name);
process.stdout.write(JSON.stringify({
  edits: await browser.edits(), reached, unseen, announced,
  nameless: heard.filter(({ role, name }) => controls.test(role) && !name).map(({ role }) => role),
  controls: heard.filter(({ role }) => controls.test(role)).length,
  pictures: heard.filter(({ role }) => role === 'image').map(({ name }) => name),
  rows: heard.filter((node) => node.role === 'row' && isOfRooms(node)).map(named),
  live: heard.filter(({ role, live }) => role === 'status' && live).length,
  complaints: browser.complaints,
}));
browser.close();
