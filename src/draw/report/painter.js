'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// A layer of the map that paints many shapes on a canvas. Shapes of one style in one part of the
// building are one path in metres, made once: a move or zoom only sets another transform. What is much
// is painted over several frames, on a second canvas that takes the first one's place when it is whole.
// shape: { layer, lines: [[x, y] ...], isRing, fill, stroke, width, dash, cap }, px and metres; drawn
// in the order of layers, and there of the styles' first shapes.
function makePainter(map, pane, layers) {
  const margin = 0.2;     // of the map's size, painted beyond each side: it can be dragged in
  const parts = 12;       // of the building along each axis: what is out of sight is left out
  const finestDash = 10;  // px a metre: below this dashes are no more than noise, and cost most
  const holder = L.DomUtil.create('div', '', map.getPane(pane));
  let [front, back] = [0, 1].map(() => L.DomUtil.create('canvas', 'leaflet-zoom-animated', holder));
  const shown = new Set();
  const groupsOf = new Map(layers.map((id) => [id, []]));
  const shapesBy = new Map(layers.map((id) => [id, []]));
  let labels = [];
  let painted = null;    // { zoom, corner, bounds }: what is on the front
  let job = null;        // what paints the back; one at a time
  let isStale = false;   // what the job paints is not the last any more
  const pointLength = 10; // px of a line that cost as much as a point of it
  let perFrame = 4000;   // points that are painted in a frame, and what lines cost beside them
  let last = 0;          // ms, when a frame of the job began

  const area = (ring) => ring.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length];
    return sum + x * nextY - nextX * y;
  }, 0);
  const lengthOf = (line) => line.reduce((sum, [x, y], i) => (i ? sum + Math.hypot(x - line[i - 1][0], y - line[i - 1][1]) : 0), 0);
  const sumOf = (values) => values.reduce((sum, value) => sum + value, 0);
  function trace(path, { lines, isRing }) {
    lines.forEach((line, k) => {
      const turned = isRing && (area(line) > 0) !== (k === 0) ? [...line].reverse() : line;  // holes run the other way
      turned.forEach(([x, y], i) => (i ? path.lineTo(x, y) : path.moveTo(x, y)));
      if (isRing) path.closePath();
    });
  }
  /// Replaces the shapes of a layer.
  function set(id, shapesOf) {
    shapesBy.set(id, shapesOf);
    const whole = boxOf(shapesOf.flatMap(({ lines }) => lines));
    const place = (value, low, high) => Math.min(parts - 1, Math.floor(parts * (value - low) / (high - low || 1)));
    const groups = new Map();
    for (const shape of shapesOf) {
      const key = JSON.stringify([shape.fill, shape.stroke, shape.width, shape.dash, shape.cap]);
      if (!groups.has(key)) groups.set(key, { style: shape, tiles: new Map() });
      const { tiles } = groups.get(key);
      const box = boxOf(shape.lines);
      const tile = parts * place((box[0] + box[2]) / 2, whole[0], whole[2]) + place((box[1] + box[3]) / 2, whole[1], whole[3]);
      if (!tiles.has(tile)) tiles.set(tile, { path: new Path2D(), box, points: 0, length: 0 });
      const one = tiles.get(tile);
      trace(one.path, shape);
      one.points += sumOf(shape.lines.map((line) => line.length));
      one.length += sumOf(shape.lines.map(lengthOf));
      one.box = boxOf([[one.box.slice(0, 2), one.box.slice(2), box.slice(0, 2), box.slice(2)]]);
    }
    groupsOf.set(id, [...groups.values()]);
    refresh();
  }
  function paintLabels(ink, scale, toX, toY, bounds) {
    ink.font = 'bold 15px "DejaVu Sans", Verdana, sans-serif';
    ink.textAlign = 'center';
    ink.textBaseline = 'middle';
    ink.lineJoin = 'round';
    ink.lineWidth = 3;
    ink.strokeStyle = '#fff';
    ink.fillStyle = '#1f2933';
    for (const label of labels) {
      const [x, y] = label.at;
      if (x < bounds[0] || x > bounds[2] || y < bounds[1] || y > bounds[3] || Math.min(...label.room_m) * scale < 16) continue;
      label.width = label.width || ink.measureText(label.text).width;
      if (label.width > label.room_m[0] * scale) continue;
      ink.strokeText(label.text, toX(x), toY(y));
      ink.fillText(label.text, toX(x), toY(y));
    }
  }
  /// Paints the back as the map lies now; yields what it has painted since, in points.
  function* painting() {
    const sharpness = window.devicePixelRatio || 1;
    const size = map.getSize();
    const pad = size.multiplyBy(margin).round();
    const corner = map.containerPointToLayerPoint(pad.multiplyBy(-1)).round();
    const full = size.add(pad.multiplyBy(2));
    const [width, height] = [Math.round(full.x * sharpness), Math.round(full.y * sharpness)];
    if (back.width !== width || back.height !== height) {
      Object.assign(back, { width, height });
      Object.assign(back.style, { width: `${full.x}px`, height: `${full.y}px` });
    }
    const scale = Math.pow(2, map.getZoom());
    const off = map.getPixelOrigin().add(corner);
    const bounds = [off.x / scale, -(off.y + full.y) / scale, (off.x + full.x) / scale, -off.y / scale];
    const now = { zoom: map.getZoom(), corner: map.layerPointToLatLng(corner), bounds };
    const ink = back.getContext('2d');
    ink.setTransform(1, 0, 0, 1, 0, 0);
    ink.clearRect(0, 0, width, height);
    const zoomed = sharpness * scale;
    ink.setTransform(zoomed, 0, 0, -zoomed, -off.x * sharpness, -off.y * sharpness);
    for (const { style, tiles } of layers.filter((one) => shown.has(one)).flatMap((id) => groupsOf.get(id))) {
      ink.fillStyle = style.fill || '';
      ink.strokeStyle = style.stroke || '';
      ink.lineWidth = (style.width || 1) / scale;
      ink.lineCap = style.cap || 'round';
      ink.lineJoin = 'round';
      ink.setLineDash(style.dash && scale >= finestDash ? style.dash.map((length) => length / scale) : []);
      for (const { path, box, points, length } of tiles.values()) {
        if (box[0] > bounds[2] || box[2] < bounds[0] || box[1] > bounds[3] || box[3] < bounds[1]) continue;
        if (style.fill) ink.fill(path);
        if (style.stroke) ink.stroke(path);
        yield points + length * scale / pointLength;
      }
    }
    ink.setLineDash([]);
    if (labels.length && shown.has(labels[0].layer)) {
      ink.setTransform(sharpness, 0, 0, sharpness, 0, 0);
      paintLabels(ink, scale, (x) => x * scale - off.x, (y) => -y * scale - off.y, bounds);
    }
    painted = now;
  }
  /// A frame's share of the job; as much as keeps frames short.
  function work(time) {
    if (last) perFrame = time - last > 25 ? Math.max(500, perFrame / 2) : Math.min(10000, perFrame * 1.5);
    last = time;
    for (let points = 0; points < perFrame;) {
      const { value, done } = job.next();
      if (done) return finish();
      points += value;
    }
    return requestAnimationFrame(work);
  }
  function finish() {
    [front, back] = [back, front];
    front.hidden = false;
    back.hidden = true;
    job = null;
    last = 0;
    follow();
    if (isStale) refresh();
  }
  /// Paints anew, from the next frame on.
  function refresh() {
    isStale = job !== null;
    if (job) return;
    job = painting();
    requestAnimationFrame(work);
  }
  /// What is on the front follows the map at once.
  function follow() {
    if (!painted) return;
    L.DomUtil.setTransform(front, map.latLngToLayerPoint(painted.corner), map.getZoomScale(map.getZoom(), painted.zoom));
    const view = map.getBounds();
    const [west, south, east, north] = painted.bounds;
    if (map.getZoom() !== painted.zoom || view.getWest() < west || view.getEast() > east || view.getSouth() < south || view.getNorth() > north) refresh();
  }
  map.on('move zoom viewreset', follow);
  map.on('moveend resize', refresh);
  return {
    picture: holder, set,
    /// What is shown, as elements of an SVG in metres with y downwards, to be printed; text of so many metres.
    svg(text_m) {
      const escaped = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
      const trail = ({ lines, isRing }) => lines.map((line) => `M${line.map(([x, y]) => `${x} ${-y}`).join('L')}${isRing ? 'Z' : ''}`).join('');
      const drawn = layers.filter((id) => shown.has(id)).flatMap((id) => shapesBy.get(id).map((shape) => `<path d="${trail(shape)}" fill="${shape.fill || 'none'}"` +
        ` fill-rule="evenodd" stroke="${shape.stroke || 'none'}" stroke-width="${shape.width || 1}" stroke-dasharray="${shape.dash || ''}" vector-effect="non-scaling-stroke"/>`));
      const named = labels.filter(({ layer, text, room_m }) => shown.has(layer) && room_m[0] > 0.62 * text_m * text.length && room_m[1] > text_m)
        .map(({ text, at }) => `<text x="${at[0]}" y="${-at[1] + 0.35 * text_m}" font-size="${text_m}" text-anchor="middle">${escaped(text)}</text>`);
      return [...drawn, ...named].join('');
    },
    isShown: (id) => shown.has(id),
    /// [{ layer, text, at, room_m: how wide and high the room is }]
    setLabels(now) { labels = now; },
    show(id, isShown) {
      if (isShown) shown.add(id); else shown.delete(id);
      refresh();
    },
  };
}
