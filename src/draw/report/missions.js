'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Several missions of a building: which drove when, who saw which room, and how well they agree.
// What newer missions saw otherwise than older ones.
// seenLast: of the summary, or nothing; showOnMap(at): brings a place of the building into view
function fillChanged(seenLast, showOnMap) {
  const things = ((seenLast || {}).missions || []).flatMap((seen) => seen.things.map((thing) => ({ ...thing, mission: seen.mission })));
  document.getElementById('changed-part').hidden = things.length === 0;
  const onRow = (tr, thing) => {
    tr.className = 'clickable';
    tr.tabIndex = 0;
    tr.addEventListener('click', () => showOnMap(thing.at));
    tr.addEventListener('keydown', (event) => { if (event.key === 'Enter') showOnMap(thing.at); });
  };
  fillTable(document.getElementById('changed'), [
    { label: 'What', value: (thing) => thing.kind },
    { label: 'Seen by', value: (thing) => thing.mission },
    { label: 'Size m', value: (thing) => thing.size_m, text: (thing) => thing.size_m.toFixed(2), number: true },
    { label: 'Where m', value: (thing) => thing.at[0], text: (thing) => thing.at.map((metres) => metres.toFixed(1)).join(', '), number: true },
  ], things, { onRow });
}

// missions: of the summary's evaluation; rooms: [{ id, name }]
function fillMissions(missions, rooms) {
  const element = (id) => document.getElementById(id);
  const fixed = (value, decimals) => (typeof value === 'number' ? value.toFixed(decimals) : '–');
  const percent = (share) => (typeof share === 'number' ? `${(100 * share).toFixed(0)} %` : '–');
  const isEpoch = (seconds) => seconds > 1e8;
  const clock = (seconds) => (isEpoch(seconds) ? new Date(1000 * seconds).toISOString().slice(11, 19)
    : `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, '0')}`);
  const day = (seconds) => (isEpoch(seconds) ? new Date(1000 * seconds).toISOString().slice(0, 10) : '');
  const list = missions.list.map((mission, i) => ({ ...mission, number: i + 1,
    roomOf: new Map(mission.rooms.map((room) => [room.room, room])) }));

  const swatch = (td, mission) => {
    const style = missionStyle(mission.number - 1);
    const line = document.createElement('span');
    line.className = 'swatch';
    line.style.borderTop = `3px ${!style.dash ? 'solid' : style.dash[0] === 8 ? 'dashed' : 'dotted'} ${style.color}`;
    td.append(line, ` ${mission.name}`);
  };
  const columns = [
    { label: 'No.', value: (mission) => mission.number, number: true },
    { label: 'Mission', value: (mission) => mission.name, cell: swatch },
    { label: 'Sensor', value: (mission) => mission.sensor },
    { label: 'When', value: (mission) => mission.first_s, number: true,
      text: (mission) => `${day(mission.first_s)} ${clock(mission.first_s)} – ${clock(mission.last_s)}`.trim() },
    { label: 'Path m', value: (mission) => mission.path_length_m, text: (mission) => fixed(mission.path_length_m, 0), number: true },
    { label: 'Rooms', value: (mission) => mission.rooms.filter((room) => room.visits > 0).length, number: true },
    { label: 'Floor seen', value: (mission) => mission.seen_share, text: (mission) => percent(mission.seen_share), number: true },
    { label: 'Walls off the others\u2019 m (rms)', value: (mission) => mission.walls_rms_m, text: (mission) => fixed(mission.walls_rms_m, 3), number: true },
  ];
  if (list.some((mission) => mission.in_building)) {
    const off = (mission) => (mission.in_building ? mission.in_building.position_m.rmse : null);
    columns.push({ label: 'Off the truth m (rms)', value: off, text: (mission) => fixed(off(mission), 3), number: true });
  }
  if (list.some((mission) => mission.relations)) {
    const off = (mission) => (mission.relations ? mission.relations.after.all.translation_m.mean : null);
    columns.push({ label: 'Relations m (mean)', value: off, text: (mission) => fixed(off(mission), 3), number: true });
  }
  fillTable(element('missions'), columns, list);

  const told = (room) => {
    if (!room) return '–';
    const seen = `${percent(room.seen_share)} seen`;
    if (room.visits === 0) return seen;
    const when = `${clock(room.first_s)} – ${clock(room.last_s)}`;
    return `${room.visits === 1 ? '' : `${room.visits} visits, `}${when}; ${seen}`;
  };
  fillTable(element('who'), [
    { label: 'Room', value: (room) => room.name },
    { label: 'Missions', value: (room) => list.filter((mission) => (mission.roomOf.get(room.id) || { visits: 0 }).visits > 0).length, number: true },
    ...list.map((mission) => ({ label: `${mission.number} ${mission.name}`, number: true,
      value: (room) => (mission.roomOf.get(room.id) || {}).first_s,
      text: (room) => told(mission.roomOf.get(room.id)) })),
  ], rooms);

  fillTable(element('pairs'), [
    { label: 'Missions', value: (pair) => 1000 * pair.missions[0] + pair.missions[1], text: (pair) => pair.missions.join(' and '), number: true },
    { label: 'Matches', value: (pair) => pair.accepted, number: true },
    { label: 'Refused', value: (pair) => pair.refused, number: true },
    { label: 'Off m (rms)', value: (pair) => pair.rms_m, text: (pair) => fixed(pair.rms_m, 3), number: true },
    { label: 'Off deg (rms)', value: (pair) => pair.rms_deg, text: (pair) => fixed(pair.rms_deg, 2), number: true },
  ], missions.pairs);
}
