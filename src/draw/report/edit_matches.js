'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Tools of the editor for what holds the visits together: leaves out a match of two, or says how
// two lie to each other. Statements speak of moments in the middle of the visits.
function matchTools(data, desk) {
  const element = (id) => document.getElementById(id);
  const { rounded, plus, toSegment, nearest, apart } = shapes;
  const visits = new Map(data.visits.filter((visit) => visit.middle).map((visit) => [visit.asr, visit]));
  const roomOf = new Map(data.rooms.map((room) => [room.id, room]));
  const where = (visit) => (roomOf.has(visit.room) ? `room ${roomOf.get(visit.room).name}` : 'no room');
  const matches = data.closures.filter(({ from, to }) => visits.has(from) && visits.has(to)).map((one, i) => ({ ...one, i,
    line: [visits.get(one.from).middle.at, visits.get(one.to).middle.at] }));
  const option = (value, text) => new Option(text, String(value));

  // Rooms are matched in one mission with a laser, and before it is joined with others.
  const areMatched = data.paths.length < 2 && ((data.summary.mission || {}).sensors || []).some(({ kind }) => kind === 'laser');
  for (const tool of ['reject', 'pin']) document.querySelector(`input[name="edit-tool"][value="${tool}"]`).disabled = !areMatched;

  // Matches
  const list = element('edit-matches');
  let chosen = null;
  list.append(...matches.map((one) => option(one.i, `visits ${one.from} and ${one.to} (${where(visits.get(one.from))}, ${where(visits.get(one.to))}), score ${one.score}`)));
  const times = ({ from, to }) => ({ from_time_s: visits.get(from).middle.time_s, to_time_s: visits.get(to).middle.time_s });
  const isRejected = (match) => desk.edits().some((one) => one.edit === 'reject_closure' &&
    one.from_time_s === times(match).from_time_s && one.to_time_s === times(match).to_time_s);
  function showMatches() {
    const left = matches.filter((one) => !isRejected(one));
    for (const choice of list.options) choice.hidden = choice.disabled = isRejected(matches[Number(choice.value)]);
    desk.preview({ lines: left.map(({ line }) => line), thick: chosen ? [chosen.line] : [], thin: true });
  }
  function choose(match) {
    chosen = match;
    list.value = String(match.i);
    showMatches();
    desk.say(`Match of ${list.selectedOptions[0].textContent}: Reject leaves it out.`);
  }
  list.addEventListener('change', () => choose(matches[Number(list.value)]));
  element('edit-match').addEventListener('submit', (event) => {
    event.preventDefault();
    const match = chosen || matches[Number(list.value)];
    if (!match || isRejected(match)) return desk.say('Choose a match first.');
    desk.add({ edit: 'reject_closure', ...times(match) });
    return desk.say(`Match of visits ${match.from} and ${match.to} is left out.`);
  });
  const reject = {
    hint: matches.length ? 'Choose a match of two visits, in the list or by its line.' : 'No visits were matched.',
    show() { if (matches.length) { desk.open('edit-match'); showMatches(); } },
    reset() { chosen = null; list.selectedIndex = -1; },
    isPicking: () => chosen !== null,
    byKeyboard() { list.focus({ preventScroll: true }); },
    pick(at) {  // again at the same place: the next one there
      const near = nearest(matches.filter((one) => !isRejected(one)), ({ line }) => toSegment(line, at), desk.reach());
      return near.length ? choose(near[(near.indexOf(chosen) + 1) % near.length]) : desk.say('No match is drawn there.');
    },
  };

  // Two visits, and how the second lies to the first
  const fields = ['edit-east', 'edit-north', 'edit-turn'].map(element);
  const [first, second] = ['edit-first', 'edit-second'].map(element);
  let rooms = [];
  let from = null;  // a place of the second room, to be laid on the next
  const ofRoom = (room) => [...visits.values()].filter((visit) => visit.room === room.id);
  const value = (field) => Number(field.value) || 0;
  const turned = ([x, y], angle) => [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
  /// Where the fields put a point of the second room: turned about its label, then shifted.
  function put(point) {
    const [east, north, turn] = fields.map(value);
    const centre = rooms[1].label;
    return plus(plus(centre, turned([point[0] - centre[0], point[1] - centre[1]], turn * Math.PI / 180)), [east, north]);
  }
  function showPin() {
    if (rooms.length < 2) return desk.preview({});
    return desk.preview({ lines: rooms[1].parts.flat().map((ring) => [...ring, ring[0]].map(put)), dots: from ? [from] : [] });
  }
  function taken(room) {
    const own = ofRoom(room);
    if (!own.length) return desk.say(`No visit of room ${room.name} is known.`);
    if (rooms.length === 1 && room === rooms[0] && own.length < 2) return desk.say('It was visited once: choose another room.');
    rooms.push(room);
    const select = rooms.length < 2 ? first : second;
    select.replaceChildren(...own.map((visit) => option(visit.asr, `visit ${visit.asr} in room ${room.name}`)));
    if (rooms.length < 2) return desk.say(`Room ${room.name}, and which other?`);
    if (rooms[0] === rooms[1]) select.selectedIndex = 1;
    for (const field of fields) field.value = '0';
    desk.open('edit-pin');
    showPin();
    return desk.say('They lie so now. Choose a place of the second and where it is in truth, or write it; then Pin.');
  }
  for (const field of fields) field.addEventListener('input', showPin);
  element('edit-pin').addEventListener('submit', (event) => {
    event.preventDefault();
    const [a, b] = [first, second].map((select) => visits.get(Number(select.value)));
    if (!a || !b || a === b) return desk.say('Choose two different visits.');
    const turn = value(fields[2]) * Math.PI / 180;
    const [x, y] = turned(plus(put(b.after), a.after, -1), -a.heading_rad);
    const theta = b.heading_rad + turn - a.heading_rad;
    desk.add({ edit: 'pin_visits', ...times({ from: a.asr, to: b.asr }), from_from_to:
      { x_m: rounded(x), y_m: rounded(y), theta_rad: Math.round(1e6 * Math.atan2(Math.sin(theta), Math.cos(theta))) / 1e6 } });
    return desk.say(`Visits ${a.asr} and ${b.asr} are pinned; assemble judges it by what was seen.`);
  });
  const pin = {
    hint: 'Choose two rooms that hang together.',
    reset() { rooms = []; from = null; },
    isPicking: () => rooms.length > 0,
    byKeyboard() { if (rooms.length === 2) fields[0].focus({ preventScroll: true }); },
    pickRoom: (room) => (rooms.length < 2 ? taken(room) : desk.say('Press Pin, or Esc to choose other rooms.')),
    pick(at) {
      if (rooms.length < 2) {
        const room = desk.roomAt(at);
        return room ? taken(room) : desk.say('No room is there.');
      }
      if (!from) {
        from = at;
        showPin();
        return desk.say('And where is that in truth?');
      }
      fields[0].value = rounded(value(fields[0]) + at[0] - from[0]);
      fields[1].value = rounded(value(fields[1]) + at[1] - from[1]);
      const off = apart(from, at);
      from = null;
      showPin();
      return desk.say(`Shifted by ${off.toFixed(2)} m. Pin keeps it.`);
    },
  };
  return { reject, pin };
}
