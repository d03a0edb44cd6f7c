'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Tool of the editor that moves a wall along its normal: choose it, then choose where it is, drag
// it, or write by how much. It snaps to the lines of other walls, else to 0.05 m.
function wallTool(data, desk) {
  const { rounded, place, apart, axes, project, plus, toSegment, nearest, middle } = shapes;
  const thickest = 0.8;  // m between the two faces of a wall
  const farthest = 5;    // m that a wall is moved
  const field = document.getElementById('edit-by');
  const edges = data.rooms.flatMap((room) => room.parts.flatMap((part) => part.flatMap((ring) =>
    straightOf(ring).map((line) => ({ room, line }))))).filter(({ line }) => apart(...line) > 0.05);
  let wall = null;  // { line, left, rooms: [left, right], faces: m to the left of the line, inLine }

  /// The straight stretches of a ring, through doors and through corners that are none.
  function straightOf(ring) {
    const centre = ring.reduce((sum, end) => plus(sum, end, 1 / ring.length), [0, 0]);
    const first = ring.reduce((far, end, i) => (apart(end, centre) > apart(ring[far], centre) ? i : far), 0);
    const points = [...ring.slice(first), ...ring.slice(0, first + 1)];
    const lines = [];
    for (let i = 0, j; i + 1 < points.length; i = j) {
      const isStraight = (end) => points.slice(i + 1, end).every((point) => toSegment([points[i], points[end]], point) < 0.03);
      for (j = i + 1; j + 1 < points.length && isStraight(j + 1); ++j);
      lines.push([points[i], points[j]]);
    }
    return lines;
  }
  const parallel = (one, axis) => {
    const { along } = axes(one);
    return Math.abs(along[0] * axis[1] - along[1] * axis[0]) < 0.035 ? along[0] * axis[0] + along[1] * axis[1] : 0;
  };
  /// The face of another room on the back of a face, beside the place: how far to its left, and the stretch that both have.
  function back(face, at) {
    const { along, left } = axes(face.line);
    const [origin, length] = [face.line[0], apart(...face.line)];
    const behind = edges.filter((edge) => parallel(edge.line, along) < 0).map((edge) => {
      const ends = edge.line.map((end) => project(along, origin, end));
      return { edge, offset: project(left, origin, middle(edge.line)), from: Math.max(0, Math.min(...ends)), to: Math.min(length, Math.max(...ends)) };
    });
    const t = project(along, origin, at);
    return nearest(behind.filter(({ offset, from, to }) => offset < 0.005 && to - from > 0.3 && from - 0.1 <= t && t <= to + 0.1),
      ({ offset }) => -offset, thickest)[0];
  }
  function wallAt(at) {
    const [face] = nearest(edges, ({ line }) => toSegment(line, at), desk.reach());
    if (!face) return null;
    const { along, left } = axes(face.line);
    const other = back(face, at);
    if (!other) return { line: face.line.map(place), left, along, rooms: [face.room, null], faces: [0] };
    const half = other.offset / 2;
    const line = [other.from, other.to].map((t) => place(plus(plus(face.line[0], along, t), left, half)));
    return { line, left, along, rooms: [face.room, other.edge.room], faces: [-half, half] };
  }
  /// By how much it would have to be moved to be in line with other walls, by a face on the same side.
  function linesOf({ line: told, left, along, faces }) {
    return edges.map(({ room, line }) => [room, parallel(line, along), project(left, told[0], middle(line))])
      .filter(([, way, offset]) => way !== 0 && Math.abs(offset) < farthest + thickest)
      .flatMap(([room, way, offset]) => faces.filter((face, i) => (i === 0) === (way > 0)).map((face) => ({ room, by: offset - face })))
      .filter(({ by }) => Math.abs(by) > 0.02);
  }
  const shifted = (by) => wall.line.map((end) => plus(end, wall.left, by));
  /// What statements before have moved it by.
  function moved() {
    let by = 0;
    for (const one of desk.edits()) {
      if (one.edit === 'move_wall' && apart(one.wall_m[0], shifted(by)[0]) < 0.01 && apart(one.wall_m[1], shifted(by)[1]) < 0.01) by += one.by_m;
    }
    return by;
  }
  /// How far to its left the wall would be at a place, snapped; and to the wall of which room.
  function snapped(at) {
    const raw = Math.max(-farthest, Math.min(farthest, project(wall.left, wall.line[0], at)));
    const [near] = nearest(wall.inLine, ({ by }) => Math.abs(by - raw), Math.min(0.3, desk.reach() / 2));
    return near || { by: Math.round(raw * 20) / 20, room: null };
  }
  const name = (room) => (room ? `room ${room.name}` : 'outside');
  function show(by) {
    desk.preview({ lines: [shifted(by)], thick: [shifted(moved())], text: `${(by - moved()).toFixed(2)} m` });
  }
  function choose(at) {
    wall = wallAt(at);
    if (!wall) return desk.say('No wall is there.');
    wall.inLine = linesOf(wall);
    field.value = '0.00';
    document.getElementById('edit-towards').textContent = `Move the wall (m), positive towards ${name(wall.rooms[0])}, negative towards ${name(wall.rooms[1])}`;
    desk.open('edit-wall');
    show(moved());
    return desk.say(`Wall between ${name(wall.rooms[0])} and ${name(wall.rooms[1])}: choose where it is, drag it, or write by how much.`);
  }
  function move(by, room) {
    const before = moved();
    const by_m = rounded(by - before);
    if (Math.abs(by_m) < 0.005) return desk.say('The wall is there already.');
    if (Math.abs(by_m) > farthest) return desk.say(`A wall is moved by ${farthest} m at most.`);
    desk.add({ edit: 'move_wall', wall_m: shifted(before).map(place), by_m });
    return desk.say(`Wall moved by ${Math.abs(by_m).toFixed(2)} m${room ? `, in line with a wall of ${name(room)}` : ''}.`);
  }
  document.getElementById('edit-wall').addEventListener('submit', (event) => {
    event.preventDefault();
    move(moved() + Number(field.value), null);
  });
  field.addEventListener('input', () => { if (wall) show(moved() + Number(field.value)); });
  return {
    hint: 'Choose a wall, then where it is.',
    reset() { wall = null; },
    isPicking: () => wall !== null,
    byKeyboard() { field.focus({ preventScroll: true }); field.select(); },
    pick(at) {
      if (!wall) return choose(at);
      const { by, room } = snapped(at);
      return move(by, room);
    },
    hover(at) { if (wall) show(snapped(at).by); },
    drag(at) {
      if (wall) return toSegment(shifted(moved()), at) <= desk.reach();
      if (!wallAt(at)) return false;
      choose(at);
      return true;
    },
    drop(at) {
      const { by, room } = snapped(at);
      move(by, room);
    },
  };
}
