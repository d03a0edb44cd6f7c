'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Things by the cells that their boxes touch: what is at a place is asked at every move of a pointer.
// entries: [{ box: [west, south, east, north], ... }], in metres
function placeIndex(entries) {
  const finest = 4;  // m; each level has cells twice as long, and a thing is where it touches few
  const levels = new Map();
  function each(level, [west, south, east, north], use) {
    const cell = (value) => Math.floor(value / (finest * Math.pow(2, level)));
    for (let i = cell(west); i <= cell(east); ++i) for (let j = cell(south); j <= cell(north); ++j) use(`${i} ${j}`);
  }
  for (const entry of entries) {
    const [west, south, east, north] = entry.box;
    const level = Math.max(0, Math.ceil(Math.log2(Math.max(east - west, north - south) / finest)));
    if (!levels.has(level)) levels.set(level, new Map());
    const cells = levels.get(level);
    each(level, entry.box, (key) => { if (cells.has(key)) cells.get(key).push(entry); else cells.set(key, [entry]); });
  }
  /// Those whose boxes come as near as the reach; of one level in the order in which they were given.
  return function near([x, y], reach = 0) {
    const found = new Set();
    for (const [level, cells] of levels) {
      each(level, [x - reach, y - reach, x + reach, y + reach], (key) => {
        for (const entry of cells.get(key) || []) {
          const [west, south, east, north] = entry.box;
          if (x >= west - reach && x <= east + reach && y >= south - reach && y <= north + reach) found.add(entry);
        }
      });
    }
    return [...found];
  };
}

function boxOf(lines) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const line of lines) {
    for (const [x, y] of line) {
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
  }
  return box;
}
