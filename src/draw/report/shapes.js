'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Points, lines and rings of the plan, in building metres.
const shapes = {
  rounded: (value) => Math.round(value * 1000) / 1000,
  place: ([x, y]) => [shapes.rounded(x), shapes.rounded(y)],
  apart: (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1]),
  middle: ([a, b]) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
  plus: (point, by, share = 1) => [point[0] + share * by[0], point[1] + share * by[1]],
  /// The way along a line, and what is to the left of it: unit vectors.
  axes([a, b]) {
    const length = shapes.apart(a, b) || 1;
    const along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    return { along, left: [-along[1], along[0]] };
  },
  project: (axis, from, point) => axis[0] * (point[0] - from[0]) + axis[1] * (point[1] - from[1]),
  inside: (ring, [x, y]) => ring.reduce((is, a, i) => {
    const b = ring[(i + 1) % ring.length];
    return (a[1] > y) !== (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) ? !is : is;
  }, false),
  covers: (rings, at) => rings.filter((ring) => shapes.inside(ring, at)).length % 2 === 1,
  toSegment([a, b], at) {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const share = Math.max(0, Math.min(1, (dx * (at[0] - a[0]) + dy * (at[1] - a[1])) / (dx * dx + dy * dy || 1)));
    return shapes.apart(at, [a[0] + share * dx, a[1] + share * dy]);
  },
  /// Those within reach, the nearest first.
  nearest: (things, distance, reach) => things.map((thing) => [distance(thing), thing])
    .filter(([apart]) => apart <= reach).sort((a, b) => a[0] - b[0]).map(([, thing]) => thing),
};
