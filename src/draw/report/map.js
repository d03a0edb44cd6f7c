'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// How the path of a mission is drawn, as in plan.svg.
function missionStyle(i) {
  const colors = ['#d55e00', '#0072b2', '#009e73', '#cc79a7', '#b8860b', '#56b4e9', '#5b2a86', '#1f2933'];
  const dashes = [undefined, [8, 3], [3, 3]];
  return { color: colors[i % colors.length], dash: dashes[Math.floor(i / colors.length) % dashes.length] };
}

// The map: layers of the plan, walls and path between odometry and correction, selection.
function makeMap(data, onSelect) {
  const latLng = ([x, y]) => [y, x];
  const point = ({ lng, lat }) => [lng, lat];
  const map = L.map('map', {
    crs: L.CRS.Simple, attributionControl: false, minZoom: -4, maxZoom: 9, zoomSnap: 0.25,
    zoomAnimation: false, fadeAnimation: false, markerZoomAnimation: false,
  });
  const container = map.getContainer();
  const outlines = data.rooms.flatMap((room) => room.parts.map((part) => part[0]));
  const box = boxOf(outlines.length ? outlines : [[[0, 0], [10, 10]]]);
  const home = L.latLngBounds([box[1], box[0]], [box[3], box[2]]);
  const planPane = map.createPane('plan');
  planPane.style.zIndex = 410;
  map.createPane('missions').style.zIndex = 420;

  const plan = makePainter(map, 'plan', ['rooms', 'furniture', 'walls', 'evidence', 'unexplored', 'doors', 'graph']);
  const missions = makePainter(map, 'missions', ['seen', 'trajectory', 'corrections', 'uncertainty']);
  const layers = [
    ['rooms', 'Rooms', true], ['walls', 'Walls', true], ['doors', 'Doors', true],
    ['furniture', 'Furniture', data.furniture.length > 0],
    ['evidence', 'Inferred and unexplored walls', data.edges.length > 0],
    ['unexplored', 'Unexplored', data.unexplored.length > 0], ['graph', 'Graph of rooms', false],
    ['seen', 'Walls as seen', false], ['trajectory', data.paths.length > 1 ? 'Paths of the missions' : 'Path', data.paths.length > 1],
    ['corrections', 'Corrections', false], ['uncertainty', 'Uncertainty (95 %)', false],
  ];
  const painterOf = (id) => (['seen', 'trajectory', 'corrections', 'uncertainty'].includes(id) ? missions : plan);
  const show = (id, isShown) => painterOf(id).show(id, isShown);

  // What is said where the pointer is.
  const tips = [];
  function set(shapesOf) {
    for (const [id, list] of Object.entries(shapesOf)) {
      painterOf(id).set(id, list);
      for (const shape of list) if (shape.tip) tips.push({ layer: id, shape, box: boxOf(shape.lines) });
    }
  }
  set(planShapes.plan(data));
  set(planShapes.visits(data));
  set(planShapes.moved(data, 1));
  const tipsNear = placeIndex(tips);
  const roomsNear = placeIndex(data.rooms.flatMap((room) => room.parts.map((part) => ({ room, part, box: boxOf([part[0]]) }))));
  const extentOf = (room) => { const [west, south, east, north] = boxOf(room.parts.map((part) => part[0])); return [east - west, north - south]; };
  plan.setLabels(data.rooms.map((room) => ({ layer: 'rooms', text: room.name, at: room.label, room_m: extentOf(room) })));
  function roomAt(at) {
    const found = roomsNear(at).find(({ part }) => shapes.covers(part, at));
    return found && found.room;
  }
  const tip = L.tooltip({ direction: 'right', offset: [12, 0] });
  function pointAt(at) {
    const reach = 5 / Math.pow(2, map.getZoom());  // px
    const isHit = ({ lines, isRing }) => (isRing && shapes.covers(lines, at)) ||
      lines.some((line) => line.some((end, i) => (i || isRing) && shapes.toSegment([line[(i || line.length) - 1], end], at) <= reach));
    const found = tipsNear(at, reach).filter(({ layer, shape }) => painterOf(layer).isShown(layer) && isHit(shape)).pop();
    container.classList.toggle('over-room', plan.isShown('rooms') && Boolean(roomAt(at)));
    if (!found) return tip.remove();
    return tip.setLatLng(latLng(at)).setContent(document.createTextNode(found.shape.tip)).addTo(map);
  }
  let pointed = null;
  map.on('mousemove', (event) => {
    if (!pointed) requestAnimationFrame(() => { if (pointed) pointAt(pointed); pointed = null; });
    pointed = point(event.latlng);
  });
  map.on('mouseout', () => { pointed = null; tip.remove(); });
  map.on('click', (event) => {
    const room = plan.isShown('rooms') && roomAt(point(event.latlng));
    if (room) onSelect(room.id, true);
  });

  // How far from odometry (0) to the corrected map (1) walls and path are shown.
  function setMoment(share) {
    for (const [id, list] of Object.entries(planShapes.moved(data, share))) missions.set(id, list);
    planPane.style.opacity = share === 1 ? '' : '0.25';
  }
  let selected = null;
  function select(id, isFromMap) {
    if (selected) selected.remove();
    const room = data.rooms.find((one) => one.id === id);
    if (!room) return;
    selected = L.polygon(room.parts.map((part) => part.map((ring) => ring.map(latLng))),
      { pane: 'missions', interactive: false, fill: false, color: '#0072b2', weight: 4 }).addTo(map);
    isMoved = true;
    if (!isFromMap) map.fitBounds(selected.getBounds().pad(1.5), { maxZoom: 6, animate: false });
  }

  // Rings a place, in building metres.
  function showPlace(at) {
    if (selected) selected.remove();
    selected = L.circleMarker(latLng(at), { pane: 'missions', interactive: false, fill: false, color: '#0072b2', weight: 4, radius: 16 }).addTo(map);
    isMoved = true;
    map.setView(latLng(at), Math.max(map.getZoom(), 5), { animate: false });
    container.scrollIntoView({ block: 'nearest' });
  }

  // The map is as high as the plan needs, and shows all of it until somebody moves or zooms it.
  const fitting = { padding: [12, 12], animate: false };
  let isMoved = false;
  function refit() {
    const shape = (home.getNorth() - home.getSouth()) / Math.max(0.1, home.getEast() - home.getWest());
    const height = Math.min(0.72 * window.innerHeight, Math.max(window.innerWidth > 960 ? 0.55 * window.innerHeight : 288, container.clientWidth * shape + 24));
    container.style.height = `${Math.round(height)}px`;
    map.invalidateSize({ animate: false });
    if (!isMoved) map.fitBounds(home, fitting);
  }
  for (const moved of ['mousedown', 'wheel', 'touchstart', 'keydown']) {
    container.addEventListener(moved, () => { isMoved = true; }, { passive: true });
  }
  map.fitBounds(home, fitting);
  refit();
  window.addEventListener('resize', refit);
  for (const [id, , isShown] of layers) if (isShown) show(id, true);
  // On paper the whole plan is lines, not points of a screen.
  window.addEventListener('beforeprint', () => {
    const margin = 0.5;  // m
    const [width, height] = [box[2] - box[0] + 2 * margin, box[3] - box[1] + 2 * margin];
    const metre_mm = Math.min(180 / width, 150 / height);
    document.getElementById('printed').innerHTML = `<svg width="${width * metre_mm}mm" height="${height * metre_mm}mm" viewBox="${box[0] - margin} ${-box[3] - margin} ${width} ${height}">` +
      `<g opacity="${planPane.style.opacity || 1}">${plan.svg(3.5 / metre_mm)}</g>${missions.svg(3.5 / metre_mm)}</svg>`;
  });
  window.addEventListener('afterprint', () => { document.getElementById('printed').replaceChildren(); });
  // To who does not see it the plan is one picture; its rooms are in the table.
  for (const pane of ['tooltipPane', 'missions']) map.getPane(pane).setAttribute('aria-hidden', 'true');
  plan.picture.setAttribute('role', 'img');
  plan.picture.setAttribute('aria-label', `Floor plan; rooms: ${data.rooms.length}, doors: ${data.doors.length}. The table of rooms lists them.`);
  return { map, layers, show, select, showPlace, setMoment, roomAt };
}
