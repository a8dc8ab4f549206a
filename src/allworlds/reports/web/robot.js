"use strict";
// What a robot does and senses, and what it concludes; not a word of pages here.
//
// A world is {sigma, alpha, vertex, percepts, start, hand, pick, states, spots}: the two permutations,
// for each dart its vertex and what is sensed by whoever has arrived by it, the markers in the hand,
// how many numbers the robot can write (0: none), and for each dart the spot where a number stands;
// null where there is none.  Of markers that are told apart the number has a bit for each one.
// An action is {move: k}, {drop: true}, {pick: true} or {write: k}.

function turn(sigma, dart, k, degree) {
  for (let left = ((k % degree) + degree) % degree; left; left -= 1) dart = sigma[dart];
  return dart;
}

function lyingAt(world, state) {
  const vertex = world.vertex[state.dart];
  return state.lying.filter((place) => place === vertex).length;
}

function begin(world) {
  return { dart: world.start, lying: [], hand: world.hand, written: [] };
}

function numberAt(world, state) {
  const found = state.written.find(([spot]) => spot === world.spots[state.dart]);
  return found ? found[1] : 0;
}

function withNumber(world, state, number) {
  const spot = world.spots[state.dart];
  const others = state.written.filter(([other]) => other !== spot);
  const written = number ? [...others, [spot, number]] : others;
  return { ...state, written: written.sort(([a], [b]) => a - b) };
}

// The least power of 2 that a number has, or lacks.
function leastBit(number, has) {
  let bit = 1;
  while ((Math.floor(number / bit) % 2 === 1) !== has) bit *= 2;
  return bit;
}

function sensed(world, state) {
  const { degree, marks, bearing } = world.percepts[state.dart];
  const left = world.spots ? numberAt(world, state) : lyingAt(world, state);
  return { degree, marks: marks + left, bearing };
}

// Why an action is not legal; empty if it is.
function refusal(world, state, action) {
  if (action.write !== undefined) {
    if (!world.states) return "there is no room for numbers";
    const legal = Number.isInteger(action.write) && action.write >= 0 && action.write < world.states;
    return legal ? "" : `the numbers are 0 to ${world.states - 1}`;
  }
  if (action.drop && !state.hand) return "there is no marker in your hand";
  if (action.pick && !world.pick) return "a marker stays where it was dropped";
  if (action.pick && !lyingAt(world, state)) return "no marker lies here";
  return "";
}

// The state after a legal action.
function step(world, state, action) {
  const { dart, lying, hand } = state;
  const vertex = world.vertex[dart];
  if (action.write !== undefined) return withNumber(world, state, action.write);
  if (action.drop) {
    const after = { ...state, lying: [...lying, vertex].sort((a, b) => a - b), hand: hand - 1 };
    if (!world.spots) return after;
    const dropped = state.written.reduce((sum, [, bits]) => sum + bits, 0);
    return withNumber(world, after, numberAt(world, state) + leastBit(dropped, false));
  }
  if (action.pick) {
    const at = lying.indexOf(vertex);
    const after = { ...state, lying: lying.filter((_, i) => i !== at), hand: hand + 1 };
    if (!world.spots) return after;
    const here = numberAt(world, state);
    return withNumber(world, after, here - leastBit(here, true));
  }
  const { degree } = world.percepts[dart];
  return { ...state, dart: world.alpha[turn(world.sigma, dart, action.move, degree)] };
}

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
      doubts.push(`of places ${place} and ${other} one is marked otherwise`);
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
  module.exports = { begin, sensed, refusal, step, notes, openDarts, estimate, isWorld };
}
