"use strict";
// What a robot concludes; not a word of pages here.
//
// The notes of a robot: a map of its log in which every arrival is a place of its own, but for what
// follows from the log, and from the conclusions.
//
// `first` is what was sensed at the start, `steps` holds {action, percept}; a conclusion is a pair
// of darts that are one.  A dart is named by its place, and by its number there: 0 is that by
// which the robot arrived, others follow clockwise.  A place has the number of the step that first
// came to it.
//
// What comes back: `places`, each {name, percept, darts}, a dart as {name, end}, where `end` is the
// name of the dart at the other end, or null; `here`, the robot's dart; and `wrong`, why the
// conclusions cannot be, if they cannot.  A name is "PLACE.NUMBER".
function notes(first, steps, conclusions, movable) {
  const percepts = [first];
  const link = [[0, 0]]; // to which place each belongs, and by how much it is turned against it
  const edges = [];
  const doubts = [];
  let here = [0, 0];
  steps.forEach(({ action, percept }, i) => {
    percepts.push(percept);
    link.push([i + 1, 0]);
    if (action.move === undefined) {
      link[i + 1] = here;
      return;
    }
    const degree = percepts[here[0]].degree;
    edges.push([[here[0], (here[1] + action.move) % degree], [i + 1, 0]]);
    here = [i + 1, 0];
  });

  function settled([place, number]) {
    const { degree } = percepts[place];
    let at = [place, ((number % degree) + degree) % degree];
    while (link[at[0]][0] !== at[0]) {
      const [above, turned] = link[at[0]];
      at = [above, (at[1] + turned) % degree];
    }
    return at;
  }

  function same(a, b) {
    const [[place, i], [other, j]] = [settled(a), settled(b)].sort((x, y) => x[0] - y[0]);
    const [one, two] = [percepts[place], percepts[other]];
    if (place === other) {
      if (i !== j) doubts.push(`two darts of place ${place} would be one`);
      return false;
    }
    if (one.degree !== two.degree) {
      doubts.push(`places ${place} and ${other} have degrees ${one.degree} and ${two.degree}`);
      return false;
    }
    const shift = (i - j + one.degree) % one.degree;
    if (!movable && one.marks !== two.marks) {
      doubts.push(`other marks or labels are sensed at place ${other} than at place ${place}`);
    }
    if (one.bearing !== null && two.bearing !== null) {
      if ((two.bearing + shift - one.bearing) % one.degree) {
        doubts.push(`the marker at places ${place} and ${other} would point along two darts`);
      }
    }
    link[other] = [place, shift];
    return true;
  }

  // A dart has one other end: those that the log, or a conclusion, gives it are one.
  function follow() {
    for (;;) {
      const ends = new Map();
      let more = false;
      for (const edge of edges) {
        for (const [from, to] of [edge, [...edge].reverse()]) {
          const name = settled(from).join(".");
          if (name === settled(to).join(".")) doubts.push(`dart ${name} would lead to itself`);
          if (ends.has(name)) {
            if (settled(ends.get(name)).join(".") !== settled(to).join(".")) {
              more = same(ends.get(name), to) || more;
            }
          } else ends.set(name, to);
        }
      }
      if (!more || doubts.length) return ends;
    }
  }

  // After a conclusion that cannot be, what stands till then is shown.
  let ends = follow();
  let made = 0;
  for (const [a, b] of conclusions) {
    if (doubts.length) break;
    same(a, b);
    ends = follow();
    made += 1;
  }
  const named = (dart) => settled(dart).join(".");
  const places = percepts
    .map((percept, place) => ({ name: place, percept }))
    .filter(({ name }) => link[name][0] === name)
    .map(({ name, percept }) => ({
      name,
      percept,
      darts: [...Array(percept.degree).keys()].map((i) => {
        const dart = `${name}.${i}`;
        return { name: dart, end: ends.has(dart) ? named(ends.get(dart)) : null };
      }),
    }));
  return { places, here: named(here), wrong: doubts[0] || "", made };
}

// The darts of which the notes do not tell where they lead.
function openDarts({ places }) {
  return places.flatMap(({ darts }) => darts.filter(({ end }) => end === null));
}

// The complete notes as {sigma, alpha, here}; null where they are not complete.
function estimate(known) {
  if (known.wrong || openDarts(known).length) return null;
  const names = known.places.flatMap(({ darts }) => darts.map(({ name }) => name));
  const number = new Map(names.map((name, i) => [name, i]));
  const sigma = [];
  for (const { darts } of known.places) {
    darts.forEach((_, i) => sigma.push(number.get(darts[(i + 1) % darts.length].name)));
  }
  const alpha = known.places.flatMap(({ darts }) => darts.map(({ end }) => number.get(end)));
  return { sigma, alpha, here: number.get(known.here) };
}

// Whether an estimate is the world with the robot at that dart: one walk along both maps.
function isWorld({ sigma, alpha, here }, world, dart) {
  if (sigma.length !== world.sigma.length) return false;
  const image = new Map([[here, dart]]);
  const queue = [here];
  for (const d of queue) {
    for (const [next, true_] of [
      [sigma[d], world.sigma[image.get(d)]],
      [alpha[d], world.alpha[image.get(d)]],
    ]) {
      if (!image.has(next)) {
        image.set(next, true_);
        queue.push(next);
      } else if (image.get(next) !== true_) return false;
    }
  }
  return new Set(image.values()).size === world.sigma.length;
}

if (typeof module !== "undefined") {
  module.exports = { notes, openDarts, estimate, isWorld };
}
