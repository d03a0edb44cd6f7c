'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a report's data, as shapes of painter.js by layer, in metres; `tip` is what is said
// of a shape that is pointed at.
const planShapes = {
  /// Of the plan as it is.
  plan(data) {
    const tints = { room: '#e4eff8', corridor: '#fff3cd', hall: '#c3d3ea' };
    const dark = '#39424e';
    const line = (...points) => ({ lines: [points], isRing: false });
    const rings = (lines) => ({ lines, isRing: true });
    const arcOf = (door) => {
      const [hinge, end] = door.leaf;
      const away = (jamb) => Math.hypot(jamb[0] - hinge[0], jamb[1] - hinge[1]);
      const closed = away(door.jambs[0]) <= away(door.jambs[1]) ? door.jambs[1] : door.jambs[0];
      const [ax, ay, bx, by] = [end[0] - hinge[0], end[1] - hinge[1], closed[0] - hinge[0], closed[1] - hinge[1]];
      const turn = Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
      return Array.from({ length: 17 }, (_, i) => {
        const angle = Math.atan2(ay, ax) + turn * i / 16;
        const radius = Math.hypot(ax, ay) + (Math.hypot(bx, by) - Math.hypot(ax, ay)) * i / 16;
        return [hinge[0] + radius * Math.cos(angle), hinge[1] + radius * Math.sin(angle)];
      });
    };
    const outline = { passage: { stroke: '#5f6b7a', dash: [4, 3] }, window: { stroke: dark } };
    const opened = data.doors.filter((door) => door.opening.length > 2);
    const leaved = data.doors.filter((door) => door.leaf);
    const claims = {
      inferred: [{ stroke: '#7b8794', width: 1.5, dash: [4, 3] }, 'inferred: not measured'],
      unexplored: [{ stroke: '#5f6b7a', width: 1.5, dash: [7, 5] }, 'unexplored'],
    };
    const claimed = data.edges.filter((edge) => claims[edge.evidence]);
    const labelOf = new Map(data.rooms.map((room) => [room.id, room.label]));
    const graphLine = { stroke: '#0072b2', width: 2, dash: [6, 4] };
    const dot = ([x, y]) => Array.from({ length: 12 }, (_, i) => [x + 0.15 * Math.cos(i * Math.PI / 6), y + 0.15 * Math.sin(i * Math.PI / 6)]);
    return {
      rooms: data.rooms.flatMap((room) => room.parts.map((part) => ({ ...rings(part), fill: tints[room.kind] || tints.room, stroke: dark, width: 1 }))),
      furniture: data.furniture.map((piece) => ({ ...rings(piece.rings), stroke: '#8a94a1', width: 1, fill: piece.kind === 'against_wall' ? '#e1e5ea' : '#f4f5f7',
        tip: piece.kind === 'against_wall' ? 'furniture at a wall' : 'furniture, free-standing' })),
      walls: data.walls.map((body) => ({ ...rings(body), fill: dark })),
      // What nobody measured is light and dashed, whatever the wall behind it is.
      evidence: [...data.assumed.map((body) => ({ ...rings([body]), fill: '#fbfcfd', stroke: '#fbfcfd', width: 1 })),
        ...claimed.map((edge) => ({ ...line(...edge.line), stroke: '#fff', width: 2, cap: 'butt' })),
        ...claimed.map((edge) => ({ ...line(...edge.line), ...claims[edge.evidence][0], tip: claims[edge.evidence][1] }))],
      unexplored: [...data.unexplored.map((points) => ({ ...line(...points), stroke: '#fff', width: 3 })),
        ...data.unexplored.map((points) => ({ ...line(...points), stroke: '#5f6b7a', width: 1.5, dash: [6, 5] }))],
      // Openings by their kind; leaf and arc where the leaf was seen.
      doors: [...opened.map((door) => ({ ...rings([door.opening]), fill: '#fff', stroke: '#5f6b7a', width: 1, ...outline[door.kind],
        tip: `${door.kind} ${door.id}, ${door.width_m.toFixed(2)} m` })),
      ...data.doors.filter((door) => door.kind === 'window').map((door) => ({ ...line(...door.jambs), stroke: dark, width: 1 })),
      ...leaved.map((door) => ({ ...line(...door.leaf), stroke: dark, width: 2.5 })),
      ...leaved.map((door) => ({ ...line(...arcOf(door)), stroke: '#5f6b7a', width: 1 }))],
      graph: [...data.doors.filter((door) => labelOf.has(door.a) && labelOf.has(door.b))
        .map((door) => ({ ...line(labelOf.get(door.a), door.at, labelOf.get(door.b)), ...graphLine })),
      ...[...labelOf.values()].map((at) => ({ ...rings([dot(at)]), fill: '#0072b2' }))],
    };
  },

  /// Of the mission, walls and paths between odometry (share 0) and the corrected map (1).
  moved(data, share) {
    const between = (before, after) => before.map(([x, y], i) => [x + (after[i][0] - x) * share, y + (after[i][1] - y) * share]);
    const isAlone = data.paths.length < 2;
    const stretch = 200;  // points, of a path in one shape: paths are long, and seen in part
    return {
      seen: data.walls_before.map((wall, i) => ({ lines: [between(wall, data.walls_after[i])], stroke: '#1f2933', width: 1.5 })),
      trajectory: data.paths.flatMap((one, k) => {
        const { color, dash } = missionStyle(k);
        const points = between(one.before, one.after);
        return Array.from({ length: Math.ceil(points.length / stretch) }, (_, i) => ({ lines: [points.slice(i * stretch, (i + 1) * stretch + 1)],
          stroke: color, dash, width: isAlone ? 1.2 : 1.6, tip: isAlone ? undefined : `${k + 1} ${one.name}` }));
      }),
    };
  },
  /// What the correction did to the visits, and how sure it is of them.
  visits(data) {
    const arrow = ({ before, after }) => {
      const length = Math.hypot(after[0] - before[0], after[1] - before[1]);
      const head = Math.min(0.4, 0.3 * length);
      const angle = Math.atan2(after[1] - before[1], after[0] - before[0]);
      const barb = (turn) => [after[0] - head * Math.cos(angle + turn), after[1] - head * Math.sin(angle + turn)];
      return [before, after, barb(0.45), after, barb(-0.45)];
    };
    // Ellipses as rings: the circle that holds 95 %, stretched and turned.
    const ellipse = ({ after, ellipse: [long, short, angle] }) => Array.from({ length: 36 }, (_, i) => {
      const [u, v] = [long * Math.cos(i * Math.PI / 18), short * Math.sin(i * Math.PI / 18)];
      return [after[0] + u * Math.cos(angle) - v * Math.sin(angle), after[1] + u * Math.sin(angle) + v * Math.cos(angle)];
    });
    return {
      corrections: data.visits.filter(({ before, after }) => Math.hypot(after[0] - before[0], after[1] - before[1]) >= 0.01)
        .map((visit) => ({ lines: [arrow(visit)], stroke: '#a2337c', width: 1.5,
          tip: `visit ${visit.asr}: moved ${visit.moved_m.toFixed(2)} m, turned ${visit.turned_deg.toFixed(1)}°` })),
      uncertainty: data.visits.filter((visit) => visit.ellipse).map((visit) => ({ lines: [ellipse(visit)], isRing: true, fill: '#00795c1a',
        stroke: '#00795c', width: 1.5, tip: `visit ${visit.asr}: 95 % within ${visit.ellipse[0].toFixed(2)} m` })),
    };
  },
};
