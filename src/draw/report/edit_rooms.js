'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Tools of the editor for rooms, doors and furniture.
function roomTools(data, desk) {
  const element = (id) => document.getElementById(id);
  const { place, covers, toSegment, nearest, apart, middle } = shapes;
  let picked = [];  // rooms or ends of a line, for a statement that needs two
  const dots = () => desk.preview({ dots: picked.filter(Array.isArray) });

  function ends(hint, statement) {
    return { hint, reset() { picked = []; }, isPicking: () => picked.length > 0, pick(at) {
      picked.push(place(at));
      dots();
      if (picked.length < 2) return desk.say('And the other end?');
      const [a, b] = picked;
      if (apart(a, b) < 0.05) { picked.pop(); return desk.say('Too near: choose another end.'); }
      const made = statement([a, b]);
      if (typeof made !== 'string') return desk.add(made);
      desk.reset();
      return desk.say(made);
    } };
  }
  function atDoor(hint, edit) {
    return { hint, pick(at) {
      const [door] = nearest(data.doors, (one) => toSegment(one.jambs, at), desk.reach());
      return door ? desk.add({ edit, at_m: place(door.at) }) : desk.say('No door is there.');
    } };
  }
  function take(room) {
    picked = [room];
    element('edit-name').value = room.name === String(room.id) ? '' : room.name;
    element('edit-kind').value = room.kind;
    desk.open('edit-room');
    element('edit-name').focus({ preventScroll: true });
    desk.say(`Room ${room.name}.`);
  }
  element('edit-room').addEventListener('submit', (event) => {
    event.preventDefault();
    const [room] = picked;
    const [name, kind] = [element('edit-name').value.trim(), element('edit-kind').value];
    const made = [];
    if (name && name !== room.name) made.push({ edit: 'name_room', room: desk.anchor(room), name });
    if (kind !== room.kind) made.push({ edit: 'set_room_kind', room: desk.anchor(room), kind });
    desk.add(...made);
    desk.say(made.length ? `Room ${room.id}: done.` : 'Nothing was changed.');
  });

  return {
    name: { hint: 'Choose a room, then write its name or set its kind.', reset() { picked = []; },
      isPicking: () => picked.length > 0, pickRoom: take, pick(at) {
        const room = desk.roomAt(at);
        return room ? take(room) : desk.say('No room is there.');
      } },
    join: { hint: 'Choose two rooms that are one.', reset() { picked = []; }, isPicking: () => picked.length > 0,
      pickRoom(room) {
        if (room === picked[0]) return desk.say('Choose another room.');
        picked.push(room);
        if (picked.length < 2) return desk.say(`Room ${room.name}, and which other?`);
        return desk.add({ edit: 'join_rooms', rooms: picked.map(desk.anchor) });
      },
      pick(at) {
        const room = desk.roomAt(at);
        return room ? this.pickRoom(room) : desk.say('No room is there.');
      } },
    split: ends('Choose both ends of the cut, at two walls of one room.', (line) => {
      const room = desk.roomAt(middle(line));
      return room ? { edit: 'split_room', room: desk.anchor(room), line_m: line } : 'No room lies between.';
    }),
    shut: atDoor('Choose a door or passage that is wall.', 'shut_door'),
    open: atDoor('Choose a window that is a door, or a door that was shut.', 'open_door'),
    door: ends('Choose both jambs of the new door.', (line) => ({ edit: 'add_door', jambs_m: line })),
    furniture: { hint: 'Choose furniture that is wall.', pick(at) {
      const piece = data.furniture.find((one) => covers(one.rings, at));
      return piece ? desk.add({ edit: 'furniture_to_wall', at_m: place(at) }) : desk.say('No furniture is there.');
    } },
    pillar: { hint: 'Choose a pillar that is furniture.', pick(at) {
      const is = data.rooms.some((room) => room.parts.some((part) => part.slice(1).some((hole) => shapes.inside(hole, at))));
      return is ? desk.add({ edit: 'wall_to_furniture', at_m: place(at) }) : desk.say('No pillar stands there.');
    } },
  };
}
