"use strict";
// Answers, line by line, what the scripts of the page say; the tests ask.
const { begin, sensed, refusal, step, said, named, actionNamed } = require(`${process.argv[2]}/world.js`);
const { notes, openDarts, estimate, isWorld } = require(`${process.argv[2]}/robot.js`);
const { place, box } = require(`${process.argv[2]}/spots.js`);
const readline = require("readline");

function after(world, state, action) {
  const why = refusal(world, state, action);
  if (why) return null;
  const next = step(world, state, action);
  return [next, sensed(world, next)];
}

const ANSWERS = {
  begin: ({ world }) => [begin(world), sensed(world, begin(world))],
  steps: ({ world, asked }) => asked.map(([state, action]) => after(world, state, action)),
  said: ({ world, percepts }) => percepts.map((percept) => said(world, percept)),
  actions: ({ names }) => names.map((name) => [actionNamed(name), named(actionNamed(name))]),
  notes: ({ first, steps, conclusions, movable, world, dart }) => {
    const known = notes(first, steps, conclusions, movable);
    const found = estimate(known);
    return {
      open: openDarts(known).length,
      places: known.places.length,
      wrong: known.wrong,
      estimate: found,
      right: found && world ? isWorld(found, world, dart) : null,
    };
  },
  // The spots after each step, as the page has them, with the places that are there then.
  spots: ({ first, steps, conclusions }) => {
    const spots = new Map();
    return [...Array(steps.length + 1).keys()].map((made) => {
      const { places } = notes(first, steps.slice(0, made), conclusions[made] || [], false);
      place(spots, places);
      const ends = places.map(({ name, darts }) => [name, darts[0].end]);
      return { spots: Object.fromEntries(spots), ends, box: box(spots, places) };
    });
  },
};

readline.createInterface({ input: process.stdin }).on("line", (line) => {
  const { what, ...given } = JSON.parse(line);
  console.log(JSON.stringify(ANSWERS[what](given)));
});
