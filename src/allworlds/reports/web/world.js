"use strict";
// What a robot does and senses in a world; not a word of pages here.
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

// A percept in words, as the world's lighthouse has them.
function said(world, { degree, marks, bearing }) {
  const marker = world.labels ? `label ${marks}` : marks > 1 ? `marks ${marks}` : "marked";
  const parts = [`degree ${degree}`];
  if (marks || world.labels) parts.push(marker);
  if (bearing !== null) parts.push(`bearing ${bearing}`);
  return parts.join(", ");
}

function named(action) {
  if (action.write !== undefined) return `write ${action.write}`;
  return action.drop ? "drop" : action.pick ? "pick" : `move ${action.move}`;
}

// The action of that name.
function actionNamed(name) {
  const [what, k] = name.split(" ");
  return { [what]: k === undefined ? true : Number(k) };
}

if (typeof module !== "undefined") {
  module.exports = { begin, sensed, refusal, step, said, named, actionNamed };
}
