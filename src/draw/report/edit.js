'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand: statements in metres, saved as edits.json (docs/edits.md). Nothing is sent.
function makeEditor(data, view) {
  const element = (id) => document.getElementById(id);
  const { map } = view;
  const container = map.getContainer();
  const latLng = ([x, y]) => [y, x];
  const point = ({ lng, lat }) => [lng, lat];
  const forms = ['edit-room', 'edit-wall', 'edit-match', 'edit-pin'];
  const marks = L.layerGroup();     // of the statements
  const previews = L.layerGroup();  // of what is being chosen
  let edits = [...data.edits];      // those that the store keeps come first
  const undone = [];                // lists, as each was before it was undone
  const done = [];
  let tool = 'name';

  const desk = {
    edits: () => edits,
    say(text) { element('edit-hint').textContent = text; },
    roomAt: view.roomAt,
    anchor: (room) => ({ id: room.id, at_m: shapes.place(room.label), outline_m: room.parts[0][0].map(shapes.place) }),
    reach: () => Math.max(0.5, 22 / Math.pow(2, map.getZoom())),  // a finger's width
    open(form) { for (const id of forms) element(id).hidden = id !== form; },
    /// Draws what would be: { lines, thick, dots, text of the first line, thin }, all in metres.
    preview({ lines = [], thick = [], dots = [], text = '', thin = false }) {
      const style = { pane: 'missions', color: '#a2337c', interactive: false };
      previews.clearLayers();
      if (lines.length) L.polyline(lines.map((line) => line.map(latLng)), { ...style, weight: thin ? 1 : 3, opacity: thin ? 0.5 : 1, dashArray: thin ? '' : '6 4' }).addTo(previews);
      for (const line of thick) L.polyline(line.map(latLng), { ...style, weight: 6, opacity: 0.6 }).addTo(previews);
      for (const dot of dots) L.circleMarker(latLng(dot), { ...style, radius: 5 }).addTo(previews);
      if (text) L.tooltip({ permanent: true, direction: 'center' }).setLatLng(latLng(shapes.middle(lines[0]))).setContent(text).addTo(previews);
    },
    /// Statements that are undone together.
    add(...made) {
      if (made.length) change([...edits, ...made]);
      reset();
      if (made.length) desk.say(`${made.map(words).join(', ')}: done. ${tools[tool].hint}`);
    },
    reset: () => reset(),
  };
  const tools = { ...roomTools(data, desk), wall: wallTool(data, desk), ...matchTools(data, desk) };

  const words = (one) => {
    const rooms = (one.rooms || (one.room ? [one.room] : [])).map((room) => room.id || '?').join(' and ');
    const by = typeof one.by_m === 'number' ? `by ${one.by_m.toFixed(2)} m` : '';
    const at = typeof one.from_time_s === 'number' ? `at ${one.from_time_s} s and ${one.to_time_s} s` : '';
    return [one.edit.replace(/_/g, ' '), rooms, one.name || one.kind || by || at].filter(Boolean).join(' ');
  };
  function change(now) {
    done.push(edits);
    undone.length = 0;
    edits = now;
  }
  function reset() {
    if (tools[tool].reset) tools[tool].reset();
    desk.open('');
    previews.clearLayers();
    if (isOn() && tools[tool].show) tools[tool].show();
    redraw();
  }
  function redraw() {
    const style = { pane: 'missions', color: '#a2337c', weight: 3, interactive: false };
    marks.clearLayers();
    for (const one of edits.filter((each) => !data.edits.includes(each))) {
      const line = one.line_m || one.jambs_m || (one.wall_m && one.wall_m.map((end) => shapes.plus(end, shapes.axes(one.wall_m).left, one.by_m)));
      if (line) L.polyline(line.map(latLng), style).addTo(marks);
      for (const at of [one.at_m, ...(one.rooms || (one.room ? [one.room] : [])).map((room) => room.at_m)]) {
        if (at) L.circleMarker(latLng(at), { ...style, radius: 8 }).addTo(marks);
      }
    }
    element('edit-list').replaceChildren(...edits.map((one) => {
      const item = document.createElement('li');
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = 'Remove';
      button.setAttribute('aria-label', `Remove: ${words(one)}`);
      button.addEventListener('click', () => remove(one));
      item.append(`${words(one)} `, button);
      return item;
    }));
    element('edit-undo').disabled = edits.length === 0 && done.length === 0;
    element('edit-redo').disabled = undone.length === 0;
  }
  function remove(one) {
    change(edits.filter((other) => other !== one));
    reset();
    element('edit-undo').focus();  // its button is gone
    desk.say(`${words(one)}: removed.`);
  }
  /// What came to a list of statements and went.
  const told = (before, after) => [...after.filter((one) => !before.includes(one)).map(words),
    ...before.filter((one) => !after.includes(one)).map((one) => `${words(one)} removed`)].join(', ');
  function undo() {
    if (!edits.length && !done.length) return desk.say('Nothing is left to undo.');
    const was = edits;
    undone.push(was);
    edits = done.length ? done.pop() : edits.slice(0, -1);
    reset();
    return desk.say(`Undone: ${told(edits, was)}.`);
  }
  function redo() {
    if (!undone.length) return desk.say('Nothing is left to do again.');
    const was = edits;
    done.push(was);
    edits = undone.pop();
    reset();
    return desk.say(`Done again: ${told(was, edits)}.`);
  }
  const text = () => `{"format": "roomatlas-edits", "version": 1, "frame": "building", "edits": [${
    edits.map((one) => `\n ${JSON.stringify(one)}`).join(',')}\n]}\n`;
  function save() {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text()], { type: 'application/json' }));
    link.download = 'edits.json';
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    desk.say('Saved: roomatlas assemble STORE --edits edits.json draws the plan so.');
  }

  const isOn = () => !element('edit-bar').hidden;
  element('edit').addEventListener('click', () => {
    element('edit-bar').hidden = !element('edit-bar').hidden;
    element('edit').setAttribute('aria-expanded', String(isOn()));
    container.classList.toggle('editing', isOn());
    for (const layer of [marks, previews]) if (isOn()) layer.addTo(map); else layer.remove();
    reset();
    desk.say(tools[tool].hint);
  });
  for (const choice of document.querySelectorAll('input[name="edit-tool"]')) {
    choice.addEventListener('change', () => {
      if (tools[tool].reset) tools[tool].reset();
      tool = choice.value;
      reset();
      desk.say(tools[tool].hint);
    });
  }
  element('edit-undo').addEventListener('click', undo);
  element('edit-redo').addEventListener('click', redo);
  element('edit-save').addEventListener('click', save);

  // By pointer: a tap chooses; what a tool takes hold of is dragged instead of the map.
  let held = null;  // where a drag began, in pixels, and whether something was chosen before
  let isDropped = false;  // the click that ends a drag chooses nothing
  const at = (event) => point(map.mouseEventToLatLng(event));
  map.on('click', (event) => {
    if (!isOn() || isDropped) return;
    tools[tool].pick(point(event.latlng));
  });
  map.on('mousemove', (event) => { if (isOn() && !held && tools[tool].hover) tools[tool].hover(point(event.latlng)); });
  container.addEventListener('pointerdown', (event) => {
    isDropped = false;
    const isOnMap = !event.target.closest('.leaflet-control');
    if (!isOn() || !event.isPrimary || !isOnMap || !tools[tool].drag) return;
    const wasPicking = tools[tool].isPicking();
    if (!tools[tool].drag(at(event))) return;
    held = { from: [event.clientX, event.clientY], wasPicking };
    map.dragging.disable();
  }, true);
  const release = () => {
    held = null;
    map.dragging.enable();
  };
  window.addEventListener('pointermove', (event) => { if (held && event.isPrimary) tools[tool].hover(at(event)); });
  window.addEventListener('pointerup', (event) => {
    if (!held || !event.isPrimary) return;
    const isDragged = shapes.apart(held.from, [event.clientX, event.clientY]) > 6;
    isDropped = isDragged || !held.wasPicking;
    if (isDragged) tools[tool].drop(at(event));
    release();
  });
  window.addEventListener('pointercancel', () => { if (held) { release(); reset(); } });

  // By keyboard: arrows move the map below the cross, by little with Shift; Enter chooses what it is on, Esc lets go.
  const ways = { arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, -1], arrowdown: [0, 1] };
  container.addEventListener('keydown', (event) => {
    const way = ways[event.key.toLowerCase()];
    if (!isOn() || !way || event.target !== container) return;
    map.panBy(way.map((one) => one * (event.shiftKey ? 3 : 24)), { animate: false });
    event.preventDefault();
    event.stopPropagation();
  }, true);
  element('map-section').addEventListener('keydown', (event) => {
    if (!isOn()) return;
    const key = event.key.toLowerCase();
    const isCommand = event.ctrlKey || event.metaKey;
    const isWriting = /^(text|number)$/.test(event.target.type || '');
    if (key === 'escape') {
      const was = tools[tool].isPicking && tools[tool].isPicking();
      reset();
      container.focus({ preventScroll: true });
      desk.say(`${was ? 'Let go. ' : ''}${tools[tool].hint}`);
    } else if (key === 'enter' && event.target === container) {
      tools[tool].pick(point(map.getCenter()));
      if (tools[tool].byKeyboard && tools[tool].isPicking()) tools[tool].byKeyboard();
    } else if (isCommand && key === 'z' && !isWriting) (event.shiftKey ? redo : undo)();
    else if (isCommand && key === 'y' && !isWriting) redo();
    else return;
    event.preventDefault();
  });
  return {
    text,
    /// A room that was chosen in the table.
    chooseRoom(room) {
      if (isOn() && tools[tool].pickRoom) tools[tool].pickRoom(room);
    },
  };
}
