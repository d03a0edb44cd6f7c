'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand: statements in metres, saved as edits.json (docs/edits.md). Nothing is sent.
function makeEditor(data, view) {
  const element = (id) => document.getElementById(id);
  const { map } = view;
  const rounded = (value) => Math.round(value * 1000) / 1000;
  const place = ([x, y]) => [rounded(x), rounded(y)];
  const marks = L.layerGroup();
  let edits = [...data.edits];  // those that the store keeps come first
  const undone = [];
  let tool = 'name';
  let picked = [];  // what was tapped for a statement that needs two

  const inside = (ring, [x, y]) => ring.reduce((is, a, i) => {
    const b = ring[(i + 1) % ring.length];
    return (a[1] > y) !== (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) ? !is : is;
  }, false);
  const covers = (rings, at) => rings.filter((ring) => inside(ring, at)).length % 2 === 1;
  const roomAt = (at) => data.rooms.find((room) => room.parts.some((part) => covers(part, at)));
  const toSegment = ([[ax, ay], [bx, by]], [x, y]) => {
    const [dx, dy] = [bx - ax, by - ay];
    const t = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    return Math.hypot(x - ax - t * dx, y - ay - t * dy);
  };
  const reach = () => Math.max(0.5, 22 / Math.pow(2, map.getZoom()));  // a finger's width
  const nearest = (things, distance, at) => things.map((thing) => [distance(thing, at), thing])
    .filter(([apart]) => apart <= reach()).sort((a, b) => a[0] - b[0]).map(([, thing]) => thing)[0];
  const anchor = (room) => ({ id: room.id, at_m: place(room.label), outline_m: room.parts[0][0].map(place) });

  const tools = {
    name: { hint: 'Choose a room, then write its name or set its kind.', pick(at) {
      const room = roomAt(at);
      if (!room) return say('No room is there.');
      picked = [room];
      element('edit-name').value = room.name === String(room.id) ? '' : room.name;
      element('edit-kind').value = room.kind;
      element('edit-room').hidden = false;
      element('edit-name').focus();
      return say(`Room ${room.name}.`);
    } },
    join: { hint: 'Choose two rooms that are one.', pick(at) {
      const room = roomAt(at);
      if (!room || room === picked[0]) return say(room ? 'Choose another room.' : 'No room is there.');
      picked.push(room);
      if (picked.length < 2) return say(`Room ${room.name}, and which other?`);
      return add({ edit: 'join_rooms', rooms: picked.map(anchor) });
    } },
    split: { hint: 'Choose both ends of the cut, at two walls of one room.', pick: ends((line) => {
      const room = roomAt([(line[0][0] + line[1][0]) / 2, (line[0][1] + line[1][1]) / 2]);
      return room ? { edit: 'split_room', room: anchor(room), line_m: line } : 'No room lies between.';
    }) },
    shut: { hint: 'Choose a door or passage that is wall.', pick: atDoor('shut_door') },
    open: { hint: 'Choose a window that is a door, or a door that was shut.', pick: atDoor('open_door') },
    door: { hint: 'Choose both jambs of the new door.', pick: ends((line) => ({ edit: 'add_door', jambs_m: line })) },
    furniture: { hint: 'Choose furniture that is wall.', pick(at) {
      const piece = data.furniture.find((one) => covers(one.rings, at));
      return piece ? add({ edit: 'furniture_to_wall', at_m: place(at) }) : say('No furniture is there.');
    } },
    pillar: { hint: 'Choose a pillar that is furniture.', pick(at) {
      const is = data.rooms.some((room) => room.parts.some((part) => part.slice(1).some((hole) => inside(hole, at))));
      return is ? add({ edit: 'wall_to_furniture', at_m: place(at) }) : say('No pillar stands there.');
    } },
  };
  function ends(statement) {
    return (at) => {
      picked.push(place(at));
      if (picked.length < 2) return say('And the other end?');
      const [a, b] = picked;
      if (Math.hypot(a[0] - b[0], a[1] - b[1]) < 0.05) { picked.pop(); return say('Too near: choose another end.'); }
      const made = statement([a, b]);
      if (typeof made === 'string') { picked = []; return say(made); }
      return add(made);
    };
  }
  function atDoor(edit) {
    return (at) => {
      const door = nearest(data.doors, (one, point) => toSegment(one.jambs, point), at);
      return door ? add({ edit, at_m: place(door.at) }) : say('No door is there.');
    };
  }

  const words = (one) => {
    const rooms = (one.rooms || (one.room ? [one.room] : [])).map((room) => room.id || '?').join(' and ');
    return [one.edit.replace(/_/g, ' '), rooms, one.name || one.kind || ''].filter(Boolean).join(' ');
  };
  function say(text) { element('edit-hint').textContent = text; }
  function add(one) {
    edits.push(one);
    undone.length = 0;
    picked = [];
    redraw();
    say(`${words(one)}: done. ${tools[tool].hint}`);
  }
  function redraw() {
    const style = { pane: 'missions', color: '#a2337c', weight: 3, interactive: false };
    const latLng = ([x, y]) => [y, x];
    marks.clearLayers();
    for (const one of edits.slice(data.edits.length)) {
      const line = one.line_m || one.jambs_m;
      if (line) L.polyline(line.map(latLng), style).addTo(marks);
      for (const at of [one.at_m, ...(one.rooms || (one.room ? [one.room] : [])).map((room) => room.at_m)]) {
        if (at) L.circleMarker(latLng(at), { ...style, radius: 8 }).addTo(marks);
      }
    }
    for (const at of picked) if (Array.isArray(at)) L.circleMarker(latLng(at), { ...style, radius: 4 }).addTo(marks);
    element('edit-list').replaceChildren(...edits.map((one) => {
      const item = document.createElement('li');
      item.textContent = words(one);
      return item;
    }));
    element('edit-undo').disabled = edits.length === 0;
    element('edit-redo').disabled = undone.length === 0;
    element('edit-room').hidden = tool !== 'name' || !picked.length;
  }
  function undo() { if (edits.length) { undone.push(edits.pop()); picked = []; redraw(); say('Undone.'); } }
  function redo() { if (undone.length) { edits.push(undone.pop()); redraw(); say('Done again.'); } }
  const text = () => `{"format": "roomatlas-edits", "version": 1, "frame": "building", "edits": [${
    edits.map((one) => `\n ${JSON.stringify(one)}`).join(',')}\n]}\n`;
  function save() {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text()], { type: 'application/json' }));
    link.download = 'edits.json';
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    say('Saved: roomatlas assemble STORE --edits edits.json draws the plan so.');
  }

  const isOn = () => !element('edit-bar').hidden;
  function pick(at) {
    if (!isOn()) return;
    tools[tool].pick(at);
    if (picked.length) redraw();
  }
  element('edit').addEventListener('click', () => {
    element('edit-bar').hidden = !element('edit-bar').hidden;
    element('edit').setAttribute('aria-expanded', String(isOn()));
    element('map').classList.toggle('editing', isOn());
    if (isOn()) marks.addTo(map); else marks.remove();
    redraw();
    say(tools[tool].hint);
  });
  for (const choice of document.querySelectorAll('input[name="edit-tool"]')) {
    choice.addEventListener('change', () => { tool = choice.value; picked = []; redraw(); say(tools[tool].hint); });
  }
  element('edit-room').addEventListener('submit', (event) => {
    event.preventDefault();
    const [room] = picked;
    const [name, kind] = [element('edit-name').value.trim(), element('edit-kind').value];
    const isNamed = name && name !== room.name;
    if (isNamed) edits.push({ edit: 'name_room', room: anchor(room), name });
    if (kind !== room.kind) edits.push({ edit: 'set_room_kind', room: anchor(room), kind });
    undone.length = 0;
    picked = [];
    redraw();
    say(isNamed || kind !== room.kind ? `Room ${room.id}: done.` : 'Nothing was changed.');
  });
  element('edit-undo').addEventListener('click', undo);
  element('edit-redo').addEventListener('click', redo);
  element('edit-save').addEventListener('click', save);
  map.on('click', (event) => pick([event.latlng.lng, event.latlng.lat]));
  // By keyboard: arrows move the map below the cross, Enter chooses what it is on.
  element('map').addEventListener('keydown', (event) => {
    if (!isOn()) return;
    const key = event.key.toLowerCase();
    if (key === 'enter') pick([map.getCenter().lng, map.getCenter().lat]);
    else if ((event.ctrlKey || event.metaKey) && key === 'z') (event.shiftKey ? redo : undo)();
    else if ((event.ctrlKey || event.metaKey) && key === 'y') redo();
    else return;
    event.preventDefault();
  });
  return { text };
}
