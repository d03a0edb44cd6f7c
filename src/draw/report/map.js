'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// How the path of a mission is drawn, as in plan.svg.
function missionStyle(i) {
  const colors = ['#d55e00', '#0072b2', '#009e73', '#cc79a7', '#b8860b', '#56b4e9', '#5b2a86', '#1f2933'];
  const dashes = ['', '8 3', '3 3'];
  return { color: colors[i % colors.length], dash: dashes[Math.floor(i / colors.length) % dashes.length] };
}

// The map: layers of the plan, walls and path between odometry and correction, selection.
function makeMap(data, onSelect) {
  const tints = { room: '#e4eff8', corridor: '#fff3cd', hall: '#c3d3ea' };
  const latLng = ([x, y]) => [y, x];
  const ring = (points) => points.map(latLng);
  const blend = (a, b, share) => [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share];

  const map = L.map('map', {
    crs: L.CRS.Simple, attributionControl: false, minZoom: -4, maxZoom: 9, zoomSnap: 0.25,
    zoomAnimation: false, fadeAnimation: false, markerZoomAnimation: false,
  });
  const home = L.latLngBounds(data.rooms.flatMap((room) => room.parts.flatMap((part) => ring(part[0]))));
  if (!home.isValid()) home.extend([0, 0]).extend([10, 10]);
  const planPane = map.createPane('plan');
  planPane.style.zIndex = 410;
  map.createPane('missions').style.zIndex = 420;
  const plan = { pane: 'plan' };
  const mission = { pane: 'missions', interactive: false };

  const rooms = L.featureGroup();
  const polygonOf = new Map();
  const labelled = [];
  const baseStyle = { color: '#39424e', weight: 1, fillOpacity: 1 };
  for (const room of data.rooms) {
    const polygon = L.polygon(room.parts.map((part) => part.map(ring)),
      { ...plan, ...baseStyle, fillColor: tints[room.kind] || tints.room });
    polygon.on('click', () => onSelect(room.id, true));
    polygon.addTo(rooms);
    polygonOf.set(room.id, polygon);
    const label = L.tooltip({ permanent: true, direction: 'center', className: 'room-label' });
    label.setLatLng(latLng(room.label)).setContent(document.createTextNode(room.name)).addTo(rooms);
    labelled.push([polygon, label]);
  }
  const bodies = (polygons, style) => L.featureGroup(polygons.map((rings) =>
    L.polygon(rings.map(ring), { ...plan, interactive: false, stroke: false, fillOpacity: 1, ...style })));
  const walls = bodies(data.walls, { fillColor: '#39424e' });
  const furniture = L.featureGroup(data.furniture.map((piece) =>
    L.polygon(piece.rings.map(ring), { ...plan, color: '#8a94a1', weight: 1, fillOpacity: 1,
      fillColor: piece.kind === 'against_wall' ? '#e1e5ea' : '#f4f5f7' })
      .bindTooltip(piece.kind === 'against_wall' ? 'furniture at a wall' : 'furniture, free-standing')));

  // Openings by their kind; leaf and arc where the leaf was seen.
  const doors = L.featureGroup();
  const arcOf = (door) => {
    const [hinge, end] = door.leaf;
    const away = (jamb) => Math.hypot(jamb[0] - hinge[0], jamb[1] - hinge[1]);
    const closed = away(door.jambs[0]) <= away(door.jambs[1]) ? door.jambs[1] : door.jambs[0];
    const [ax, ay, bx, by] = [end[0] - hinge[0], end[1] - hinge[1], closed[0] - hinge[0], closed[1] - hinge[1]];
    const turn = Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
    const points = [];
    for (let i = 0; i <= 16; ++i) {
      const angle = Math.atan2(ay, ax) + turn * i / 16;
      const radius = Math.hypot(ax, ay) + (Math.hypot(bx, by) - Math.hypot(ax, ay)) * i / 16;
      points.push([hinge[0] + radius * Math.cos(angle), hinge[1] + radius * Math.sin(angle)]);
    }
    return points;
  };
  for (const door of data.doors) {
    if (door.opening.length > 2) {
      const style = { passage: { dashArray: '4 3' }, window: { color: '#39424e' } }[door.kind] || {};
      L.polygon(ring(door.opening), { ...plan, color: '#5f6b7a', weight: 1, fillColor: '#fff', fillOpacity: 1, ...style })
        .bindTooltip(`${door.kind} ${door.id}, ${door.width_m.toFixed(2)} m`).addTo(doors);
    }
    if (door.kind === 'window') L.polyline(ring(door.jambs), { ...plan, interactive: false, color: '#39424e', weight: 1 }).addTo(doors);
    if (!door.leaf) continue;
    L.polyline(ring(door.leaf), { ...plan, interactive: false, color: '#39424e', weight: 2.5 }).addTo(doors);
    L.polyline(ring(arcOf(door)), { ...plan, interactive: false, color: '#5f6b7a', weight: 1 }).addTo(doors);
  }

  // What nobody measured is light and dashed, whatever the wall behind it is.
  const evidence = L.featureGroup();
  for (const body of data.assumed) {
    L.polygon(ring(body), { ...plan, interactive: false, color: '#fbfcfd', weight: 1, fillColor: '#fbfcfd', fillOpacity: 1 }).addTo(evidence);
  }
  const claims = {
    inferred: [{ color: '#7b8794', weight: 1.5, dashArray: '4 3' }, 'inferred: not measured'],
    unexplored: [{ color: '#5f6b7a', weight: 1.5, dashArray: '7 5' }, 'unexplored'],
  };
  for (const edge of data.edges) {
    if (!claims[edge.evidence]) continue;
    const [dashes, what] = claims[edge.evidence];
    L.polyline(ring(edge.line), { ...plan, interactive: false, color: '#fff', weight: 2, lineCap: 'butt' }).addTo(evidence);
    L.polyline(ring(edge.line), { ...plan, ...dashes }).bindTooltip(what).addTo(evidence);
  }

  const labelOf = new Map(data.rooms.map((room) => [room.id, room.label]));
  const graph = L.featureGroup();
  const graphLine = { ...plan, interactive: false, color: '#0072b2', weight: 2, dashArray: '6 4' };
  for (const door of data.doors) {
    const ends = [labelOf.get(door.a), labelOf.get(door.b)];
    if (ends[0] && ends[1]) L.polyline(ring([ends[0], door.at, ends[1]]), graphLine).addTo(graph);
  }
  for (const at of labelOf.values()) {
    L.circleMarker(latLng(at), { ...plan, interactive: false, radius: 4, color: '#0072b2', fillOpacity: 1 }).addTo(graph);
  }

  const seen = L.polyline([], { ...mission, color: '#1f2933', weight: 1.5 });
  const paths = data.paths.map((one, i) => L.polyline([], { pane: 'missions', interactive: data.paths.length > 1,
    color: missionStyle(i).color, dashArray: missionStyle(i).dash, weight: data.paths.length > 1 ? 1.6 : 1.2, opacity: 0.8 }));
  if (paths.length > 1) paths.forEach((line, i) => line.bindTooltip(document.createTextNode(`${i + 1} ${data.paths[i].name}`), { sticky: true }));
  const path = L.featureGroup(paths);
  const corrections = L.featureGroup();
  for (const visit of data.visits) {
    const [fromX, fromY] = visit.before;
    const [toX, toY] = visit.after;
    const length = Math.hypot(toX - fromX, toY - fromY);
    if (length < 0.01) continue;
    const head = Math.min(0.4, 0.3 * length);
    const angle = Math.atan2(toY - fromY, toX - fromX);
    const barb = (turn) => [toX - head * Math.cos(angle + turn), toY - head * Math.sin(angle + turn)];
    L.polyline(ring([visit.before, visit.after, barb(0.45), visit.after, barb(-0.45)]),
      { pane: 'missions', color: '#a2337c', weight: 1.5 })
      .bindTooltip(`visit ${visit.asr}: moved ${visit.moved_m.toFixed(2)} m, turned ${visit.turned_deg.toFixed(1)}°`)
      .addTo(corrections);
  }

  // Ellipses as rings: the circle that holds 95 %, stretched and turned.
  const uncertainty = L.featureGroup();
  for (const visit of data.visits) {
    if (!visit.ellipse) continue;
    const [long, short, angle] = visit.ellipse;
    const points = [];
    for (let i = 0; i < 36; ++i) {
      const [u, v] = [long * Math.cos(i * Math.PI / 18), short * Math.sin(i * Math.PI / 18)];
      points.push([visit.after[0] + u * Math.cos(angle) - v * Math.sin(angle),
        visit.after[1] + u * Math.sin(angle) + v * Math.cos(angle)]);
    }
    L.polygon(ring(points), { pane: 'missions', color: '#00795c', weight: 1.5, fillOpacity: 0.1 })
      .bindTooltip(`visit ${visit.asr}: 95 % within ${long.toFixed(2)} m`)
      .addTo(uncertainty);
  }
  const unexplored = L.featureGroup(data.unexplored.map((line) =>
    L.polyline(ring(line), { ...plan, interactive: false, color: '#fff', weight: 3 })).concat(data.unexplored.map((line) =>
    L.polyline(ring(line), { ...plan, interactive: false, color: '#5f6b7a', weight: 1.5, dashArray: '6 5' }))));

  // How far from odometry (0) to the corrected map (1) walls and path are shown.
  function setMoment(share) {
    const between = (before, after) => before.map((point, i) => latLng(blend(point, after[i], share)));
    seen.setLatLngs(data.walls_before.map((line, i) => between(line, data.walls_after[i])));
    data.paths.forEach((one, i) => paths[i].setLatLngs(between(one.before, one.after)));
    planPane.style.opacity = share === 1 ? '' : '0.25';
  }

  function showFittingLabels() {
    for (const [polygon, label] of labelled) {
      const element = label.getElement();
      if (!element) continue;
      const bounds = polygon.getBounds();
      const width = map.latLngToLayerPoint(bounds.getNorthEast()).x - map.latLngToLayerPoint(bounds.getSouthWest()).x;
      element.style.visibility = width > element.offsetWidth ? '' : 'hidden';
    }
  }

  let selected = null;
  function select(id, isFromMap) {
    if (selected) selected.setStyle(baseStyle);
    selected = polygonOf.get(id) || null;
    if (!selected) return;
    selected.setStyle({ color: '#0072b2', weight: 4 });
    selected.bringToFront();
    isMoved = true;
    if (!isFromMap) map.fitBounds(selected.getBounds().pad(1.5), { maxZoom: 6 });
  }

  const layers = [
    ['rooms', 'Rooms', rooms, true], ['walls', 'Walls', walls, true], ['doors', 'Doors', doors, true],
    ['furniture', 'Furniture', furniture, data.furniture.length > 0],
    ['evidence', 'Inferred and unexplored walls', evidence, data.edges.length > 0],
    ['unexplored', 'Unexplored', unexplored, data.unexplored.length > 0], ['graph', 'Graph of rooms', graph, false],
    ['seen', 'Walls as seen', seen, false], ['trajectory', paths.length > 1 ? 'Paths of the missions' : 'Path', path, paths.length > 1],
    ['corrections', 'Corrections', corrections, false], ['uncertainty', 'Uncertainty (95 %)', uncertainty, false],
  ];
  // The plan's bodies keep their order whatever is switched on first.
  function restack() {
    for (const layer of [furniture, walls, evidence, unexplored, doors, graph]) if (map.hasLayer(layer)) layer.bringToFront();
  }
  function show(layer, isShown) {
    if (isShown) layer.addTo(map); else layer.remove();
    restack();
    showFittingLabels();
  }
  // The map is as high as the plan needs, and shows all of it until somebody moves or zooms it.
  const container = map.getContainer();
  const fitting = { padding: [12, 12], animate: false };
  let isMoved = false;
  let isPrinting = false;
  function refit() {
    if (isPrinting) return;
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
  for (const [, , layer, isShown] of layers) if (isShown) show(layer, true);
  map.on('zoomend', showFittingLabels);
  window.addEventListener('beforeprint', () => {
    isPrinting = true;
    container.style.width = '180mm';
    container.style.height = '150mm';
    map.invalidateSize({ animate: false });
    map.fitBounds(home, fitting);
  });
  window.addEventListener('afterprint', () => {
    isPrinting = false;
    container.style.width = '';
    refit();
  });
  // To who does not see it the plan is one picture; its rooms are in the table.
  map.getPane('tooltipPane').setAttribute('aria-hidden', 'true');
  map.getPane('missions').setAttribute('aria-hidden', 'true');
  const picture = planPane.firstElementChild;
  if (picture) {
    picture.setAttribute('role', 'img');
    picture.setAttribute('aria-label', `Floor plan; rooms: ${data.rooms.length}, doors: ${data.doors.length}. The table of rooms lists them.`);
  }
  setMoment(1);
  return { map, layers, show, select, setMoment };
}
