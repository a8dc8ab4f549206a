"use strict";
// Where the places of the notes are drawn. A place stays where it was first put, so that a reader
// finds it again; not a word of pages here.
//
// `places` are those of `notes` in robot.js. Spots are a map from the name of a place to {x, y,
// turned, far}: its middle, the angle of its dart 0, and how far from the middle its darts are.

const ROOM = 46; // between the darts of two neighbours

// So far from their place its darts are drawn that they do not touch.
const far = (degree) => Math.max(30, 3.8 * degree);

// Adds a spot for each place that has none: near the place that it was reached from, in the
// direction of the dart that led there, as far as there is room.
function place(spots, places) {
  for (const { name, darts } of places) {
    if (spots.has(name)) continue;
    const own = far(darts.length);
    const [from, dart] = darts[0].end === null ? [] : darts[0].end.split(".").map(Number);
    const parent = spots.get(from);
    if (parent === undefined) {
      spots.set(name, { x: 0, y: 0, turned: -Math.PI / 2, far: own });
      continue;
    }
    const { degree } = places.find((one) => one.name === from).percept;
    const ahead = parent.turned + (2 * Math.PI * dart) / degree;
    const [x, y] = free(spots, parent, ahead, own);
    spots.set(name, { x, y, turned: Math.atan2(parent.y - y, parent.x - x), far: own });
  }
  return spots;
}

// The best free middle: straight ahead and near, if it can be.
function free(spots, parent, ahead, own) {
  const near = parent.far + own + ROOM;
  for (let wider = 0; ; wider += 1) {
    let best = null;
    for (const longer of [0, 0.4, 0.8]) {
      for (const aside of [0, 1, -1, 2, -2, 3, -3, 4, -4]) {
        const reach = near * (1 + wider + longer);
        const angle = ahead + (aside * Math.PI) / 8;
        const [x, y] = [parent.x + reach * Math.cos(angle), parent.y + reach * Math.sin(angle)];
        const worth = reach + 0.3 * near * Math.abs(aside);
        if (best && best.worth <= worth) continue;
        const taken = [...spots.values()].some(
          (other) => Math.hypot(other.x - x, other.y - y) < other.far + own + ROOM / 2,
        );
        if (!taken) best = { x: Math.round(x), y: Math.round(y), worth };
      }
    }
    if (best) return [best.x, best.y];
  }
}

// The box round the spots of these places, with room for their darts and loops.
function box(spots, places) {
  const shown = places.map(({ name }) => spots.get(name));
  const left = Math.min(...shown.map((spot) => spot.x - spot.far)) - ROOM;
  const top = Math.min(...shown.map((spot) => spot.y - spot.far)) - ROOM;
  const right = Math.max(...shown.map((spot) => spot.x + spot.far)) + ROOM;
  const bottom = Math.max(...shown.map((spot) => spot.y + spot.far)) + ROOM;
  return { left, top, width: right - left, height: bottom - top };
}

if (typeof module !== "undefined") module.exports = { far, place, box };
