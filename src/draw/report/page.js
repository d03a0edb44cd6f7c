'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
(function () {
  const data = JSON.parse(document.getElementById('data').textContent);
  const summary = data.summary;
  const element = (id) => document.getElementById(id);
  const fixed = (value, decimals) => (typeof value === 'number' ? value.toFixed(decimals) : '–');
  const hide = (id) => { element(id).hidden = true; };

  // Facts
  const mission = summary.mission || {};
  const area = data.rooms.reduce((sum, room) => sum + room.area_m2, 0);
  const facts = [`${data.rooms.length} rooms`, `${data.doors.length} doors`, `${area.toFixed(1)} m²`];
  if (mission.path_length_m > 0) facts.push(`${mission.path_length_m.toFixed(0)} m driven`);
  const accuracy = data.accuracy;
  if (typeof accuracy.probability === 'number') {
    facts.push(`right with a probability of ${Math.min(99, 100 * accuracy.probability).toFixed(0)} %`);
  }
  const bounds = [[accuracy.within_room_m, 'of the walls of a room (1 σ)'], [accuracy.between_rooms_m, 'of the places of rooms (90 %)'],
    [accuracy.over_building_m, `over ${accuracy.extent_m.toFixed(0)} m (90 %)`]].filter(([value]) => typeof value === 'number');
  if (bounds.length) facts.push(bounds.map(([value, where]) => `± ${value.toFixed(2)} m ${where}`).join(', '));
  if (data.date) facts.push(`recorded ${data.date}`);
  element('facts').textContent = facts.join(' · ');
  if (summary.answers) {
    element('answers').textContent = `Several answers: ${summary.answers.text}.`;
  } else {
    hide('answers');
  }
  const doubts = (summary.judgement || { doubts: [] }).doubts;
  if (doubts.length) {
    element('doubts').textContent = `What speaks against it: ${doubts.map((doubt) => doubt.text).join('; ')}.`;
  } else {
    hide('doubts');
  }
  const advice = (summary.judgement || {}).advice || [];
  if (advice.length) {
    const change = (values, digits, unit) => `${fixed(values[0], digits)} to ${fixed(values[1], digits)} ${unit}`;
    element('advice').textContent = `What would help, the best first: ${advice.map((one) =>
      `${one.text} (${fixed(one.drive_m, 0)} m; the least sure place from ${change(one.place_m, 2, 'm')}, heading from ${change(one.heading_deg, 1, 'deg')})`).join('; ')}.`;
  } else {
    hide('advice');
  }
  element('origin').textContent = `Roomatlas ${data.tool_version}` +
    (mission.file ? `, from ${mission.file} (SHA-256 ${mission.sha256 || 'unknown'})` : '');

  // Rooms: table and map, each selects in the other
  const roomOf = new Map(data.rooms.map((room) => [room.id, room]));
  let roomTable = null;
  const view = makeMap(data, selectRoom);
  window.roomatlasMap = view.map;  // for scripts of others
  const editor = makeEditor(data, view);
  window.roomatlasEdits = editor.text;
  function selectRoom(id, isFromMap) {
    view.select(id, isFromMap);
    if (!isFromMap) editor.chooseRoom(roomOf.get(id));
    if (selectedRow) markRow(selectedRow, false);
    selectedRow = roomTable.rows.get(roomOf.get(id));
    markRow(selectedRow, true);
    holdTab(selectedRow);
    if (isFromMap) bringToSight(selectedRow);
  }
  /// Scrolls the table alone: the page stays where the map is.
  function bringToSight(tr) {
    const box = tr.closest('.scroll');
    const [row, sight] = [tr.getBoundingClientRect(), box.getBoundingClientRect()];
    const head = element('rooms').tHead.offsetHeight;
    if (row.top < sight.top + head) box.scrollTop -= sight.top + head - row.top;
    else if (row.bottom > sight.bottom) box.scrollTop += row.bottom - sight.bottom;
  }
  let selectedRow = null;
  function markRow(tr, isIt) {
    tr.classList.toggle('selected', isIt);
    tr.setAttribute('aria-selected', String(isIt));
  }
  // The tab key stops at one row, the arrow keys go on from there.
  let tabRow = null;
  function holdTab(tr) {
    if (tabRow) tabRow.tabIndex = -1;
    tabRow = tr;
    tr.tabIndex = 0;
  }
  function moveFocus(tr, step) {
    let next = tr;
    do next = step > 0 ? next.nextElementSibling : next.previousElementSibling; while (next && next.hidden);
    if (!next) return;
    holdTab(next);
    next.focus();
  }
  roomTable = fillTable(element('rooms'), [
    { label: 'No.', value: (room) => room.id, number: true },
    { label: 'Name', value: (room) => room.name },
    { label: 'Kind', value: (room) => room.kind },
    { label: 'Area m²', value: (room) => room.area_m2, text: (room) => fixed(room.area_m2, 1), number: true },
    { label: 'Doors', value: (room) => room.doors, number: true },
  ], data.rooms, {
    onRow(tr, room) {
      tr.className = 'clickable';
      tr.tabIndex = -1;
      tr.setAttribute('aria-selected', 'false');
      tr.dataset.room = room.id;
      tr.addEventListener('click', () => selectRoom(room.id, false));
      tr.addEventListener('keydown', (event) => {
        if (event.key === 'Enter' || event.key === ' ') selectRoom(room.id, false);
        else if (event.key === 'ArrowDown') moveFocus(tr, 1);
        else if (event.key === 'ArrowUp') moveFocus(tr, -1);
        else return;
        event.preventDefault();
      });
    },
  });
  const firstRow = () => element('rooms').querySelector('tbody tr:not([hidden])');
  if (firstRow()) holdTab(firstRow());
  element('search').addEventListener('input', (event) => {
    const words = event.target.value.toLowerCase().split(/\s+/).filter(Boolean);
    const shown = roomTable.filter((room) => {
      const text = `${room.id} ${room.name} ${room.kind}`.toLowerCase();
      return words.every((word) => text.includes(word));
    });
    if ((!tabRow || tabRow.hidden) && firstRow()) holdTab(firstRow());
    element('found').textContent = words.length ? `${shown} of ${data.rooms.length}` : '';
  });

  // Slider and layers
  const boxes = new Map();
  for (const [id, label, isShown] of view.layers) {
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.id = `layer-${id}`;
    box.checked = isShown;
    box.addEventListener('change', () => view.show(id, box.checked));
    const text = document.createElement('label');
    text.append(box, ` ${label}`);
    element('layers').appendChild(text);
    boxes.set(id, box);
  }
  element('moment').addEventListener('input', (event) => {
    const percent = Number(event.target.value);
    for (const id of ['seen', 'trajectory']) {
      if (!boxes.get(id).checked && percent < 100) boxes.get(id).click();
    }
    view.setMoment(percent / 100);
    element('moment-text').textContent = `${percent} %`;
    event.target.setAttribute('aria-valuetext',
      percent === 100 ? 'corrected' : percent === 0 ? 'odometry alone' : `${percent} % of the way to the correction`);
  });

  // Missions
  const missions = (summary.evaluation || {}).missions;
  if (missions) fillMissions(missions, data.rooms);
  if (missions) fillChanged(summary.seen_last, (at) => view.showPlace(at));
  else hide('missions-section');

  // Warnings
  const warnings = [...(mission.issues || []), ...data.issues.filter((issue) => issue.severity !== 'note').map((issue) => issue.text),
    ...((summary.evaluation && summary.evaluation.issues) || [])];
  if (!summary.correction.converged) warnings.push(`The correction did not converge: ${summary.correction.message}`);
  for (const warning of warnings) {
    const item = document.createElement('li');
    item.textContent = warning;
    element('warnings').appendChild(item);
  }
  if (!warnings.length) hide('warnings-section');
  const notes = data.issues.filter((issue) => issue.severity === 'note');
  for (const note of notes) {
    const item = document.createElement('li');
    item.textContent = note.text;
    element('notes').appendChild(item);
  }
  element('notes-count').textContent = `${notes.length} notes on how the plan was put together`;
  if (!notes.length) hide('notes-section');

  // Errors
  function bars(td, row) {
    const largest = Math.max(row.before || 0, row.after || 0) || 1;
    for (const moment of ['before', 'after']) {
      const bar = document.createElement('span');
      bar.className = `bar ${moment}`;
      bar.style.width = `${100 * (row[moment] || 0) / largest}%`;
      td.appendChild(bar);
    }
  }
  const comparison = (label) => [
    { label, value: (row) => row.what }, { label: 'Unit', value: (row) => row.unit },
    { label: 'Odometry', value: (row) => row.before, text: (row) => fixed(row.before, 3), number: true },
    { label: 'Corrected', value: (row) => row.after, text: (row) => fixed(row.after, 3), number: true },
    { label: 'Odometry (blue), corrected (orange)', cell: bars },
  ];
  const evaluation = summary.evaluation || {};
  const errors = [];
  const statistics = [['mean', 'mean'], ['median', 'median'], ['max', 'largest']];
  function addErrors(what, unit, before, after) {
    if (!before || !after || !after.count) return;
    for (const [key, word] of statistics) errors.push({ what: `${what}, ${word}`, unit, before: before[key], after: after[key] });
  }
  if (evaluation.relations) {
    const { before, after } = evaluation.relations;
    for (const subset of ['all', 'local', 'loop']) {
      addErrors(`relations (${subset}): translation`, 'm', before[subset].translation_m, after[subset].translation_m);
      addErrors(`relations (${subset}): rotation`, 'deg', before[subset].rotation_deg, after[subset].rotation_deg);
    }
  }
  if (evaluation.true_poses) {
    const { before, after } = evaluation.true_poses;
    addErrors('true poses: position', 'm', before.position_m, after.position_m);
    addErrors('true poses: heading', 'deg', before.heading_deg, after.heading_deg);
  }
  for (const chart of data.charts) {
    const picture = document.createElement('img');
    picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(chart.svg)}`;
    picture.alt = chart.title;
    element('charts').appendChild(picture);
  }
  if (errors.length) fillTable(element('errors'), comparison('Error'), errors);
  else hide('errors-section');
  const consistency = evaluation.consistency;
  if (consistency) {
    element('verdict').textContent = `Judged without truth; each figure is better when smaller. Verdict: the corrected map is ${consistency.verdict}.`;
    fillTable(element('consistency'), [...comparison('Figure'), { label: 'Vote', value: (row) => row.vote }],
      consistency.figures.map((figure) => ({ what: figure.figure, unit: figure.unit, before: figure.before, after: figure.after, vote: figure.vote || '–' })));
  } else {
    hide('consistency-section');
  }

  // Correction
  const correction = summary.correction;
  element('correction').textContent = `Model ${correction.model}: ${correction.iterations} iterations, cost ${fixed(correction.initial_cost, 1)} before and ${fixed(correction.final_cost, 1)} after.`;
  const because = (cause) => (!cause ? '–' : cause.asr ? `${cause.kind}, visit ${cause.asr}` : cause.kind);
  fillTable(element('visits'), [
    { label: 'Visit', value: (visit) => visit.asr, number: true },
    { label: 'Room', value: (visit) => (roomOf.get(visit.room) || { name: '–' }).name },
    { label: 'Moved m', value: (visit) => visit.moved_m, text: (visit) => fixed(visit.moved_m, 2), number: true },
    { label: 'Turned deg', value: (visit) => visit.turned_deg, text: (visit) => fixed(visit.turned_deg, 1), number: true },
    { label: 'Chi-square before', value: (visit) => visit.chi_square_before, text: (visit) => fixed(visit.chi_square_before, 1), number: true },
    { label: 'after', value: (visit) => visit.chi_square_after, text: (visit) => fixed(visit.chi_square_after, 1), number: true },
    { label: 'Because of', value: (visit) => because(visit.cause) },
  ], data.visits, { isLong: true });
  const chi = (value) => (value < 0 ? '–' : fixed(value, 2));
  const rejected = correction.factors.filter((factor) => factor.weight < 0.1).length;
  element('ledger-count').textContent = `${correction.factors.length} measurements, ${rejected} of them rejected; on the screen each has a line.`;
  fillTable(element('ledger'), [
    { label: 'Kind', value: (factor) => factor.kind },
    { label: 'From visit', value: (factor) => factor.from, number: true },
    { label: 'To visit', value: (factor) => factor.to, text: (factor) => (factor.to ? String(factor.to) : '–'), number: true },
    { label: 'Chi-square before', value: (factor) => factor.chi_square_before, text: (factor) => chi(factor.chi_square_before), number: true },
    { label: 'after', value: (factor) => factor.chi_square_after, text: (factor) => chi(factor.chi_square_after), number: true },
    { label: 'Weight', value: (factor) => factor.weight, text: (factor) => fixed(factor.weight, 2), number: true },
  ], correction.factors, { isLong: true, onRow(tr, factor) { if (factor.weight < 0.1) tr.className = 'rejected'; } });

  element('parameters').textContent = data.configuration;
})();
