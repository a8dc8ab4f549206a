// Algorithm 1 in JavaScript, as a generator, over lines of JSON.
//
//     allworlds check --exec 'node examples/javascript/algorithm1.js' --edges 4
//
// `yield k` leaves by the k-th dart clockwise from the dart of entry, and gives what is sensed
// behind it; `yield { sigma, alpha, here }` is a checkpoint.
"use strict";

function* explore(first) {
  // The explored part S. The darts of a vertex are consecutive and clockwise; alpha[d] === d is
  // an open dart, of which nobody knows yet where it leads.
  const sigma = [];
  const alpha = [];
  const expected = []; // what a robot senses that arrives by a dart

  const add = (percept) => {
    const entry = alpha.length;
    for (let k = 0; k < percept.degree; k++) {
      sigma.push(entry + ((k + 1) % percept.degree));
      alpha.push(entry + k);
      expected.push(percept);
    }
    return entry;
  };

  const ring = (dart) => {
    const darts = [dart];
    for (let d = sigma[dart]; d !== dart; d = sigma[d]) darts.push(d);
    return darts;
  };

  const join = (one, other) => {
    alpha[one] = other;
    alpha[other] = one;
  };

  // The first dart clockwise from `dart` that leads one step nearer to the vertex of `goal`.
  const nearer = (dart, goal) => {
    const steps = new Map(ring(goal).map((d) => [d, 0]));
    const queue = [goal];
    for (const at of queue) {
      for (const d of ring(at)) {
        if (steps.has(alpha[d])) continue;
        for (const e of ring(alpha[d])) steps.set(e, steps.get(d) + 1);
        queue.push(alpha[d]);
      }
    }
    return ring(dart).find((d) => steps.get(alpha[d]) === steps.get(d) - 1);
  };

  add(first);
  for (let d = 0; d < first.degree; d++) {
    expected[d] = { ...first, bearing: mod(first.bearing - d, first.degree) };
  }
  let here = 0;
  for (;;) {
    const goal = alpha.findIndex((dart, d) => dart === d); // the oldest open dart
    if (goal < 0) return { sigma, alpha, here };
    while (!ring(here).includes(goal)) {
      const dart = nearer(here, goal);
      yield ring(here).indexOf(dart);
      here = alpha[dart];
    }
    const seen = yield ring(here).indexOf(goal);

    // Behind the goal lies a new vertex, unless the robot came in by the other half of an edge
    // that is open, too. Each such hypothesis predicts all that is sensed on the way home; at v0,
    // where the lighthouse tells the darts apart, it is proved. The darts of v0 come first, so the
    // robot has not moved yet if the twin is one of them.
    let turned = 0; // where the robot stands behind the goal, clockwise from the dart of entry
    let closed = false;
    for (let twin = goal + 1; twin < alpha.length && !closed; twin++) {
      if (alpha[twin] !== twin || !same(expected[twin], seen)) continue;
      const motions = [];
      let at = twin;
      let agrees = true;
      while (agrees && !ring(at).includes(0)) {
        const dart = nearer(at, 0);
        const motion = ring(at).indexOf(dart);
        const percept = yield motion - (motions.length ? 0 : turned);
        motions.push(motion);
        at = alpha[dart];
        agrees = same(percept, expected[at]);
      }
      if (agrees) {
        join(goal, twin);
        here = at;
        closed = true;
      } else {
        // Back by the same edges: out by the dart of entry, then each motion undone.
        yield 0;
        for (let k = motions.length - 1; k > 0; k--) yield -motions[k];
        turned = motions[0];
      }
    }
    if (!closed) {
      const entry = add(seen);
      join(goal, entry);
      here = entry + turned;
    }
    yield { sigma, alpha, here };
  }
}

const mod = (a, n) => ((a % n) + n) % n;

const same = (one, other) =>
  one.degree === other.degree && one.marks === other.marks && one.bearing === other.bearing;

// What follows speaks with allworlds: one JSON object a line.
let walk;
require("node:readline")
  .createInterface({ input: process.stdin })
  .on("line", (line) => {
    const message = JSON.parse(line);
    if ("episode" in message) walk = explore(message.percept); // another world: all is forgotten
    let { done, value } = "episode" in message ? walk.next() : walk.next(message.percept);
    while (!done && typeof value === "object") { // a checkpoint, which has no reply
      process.stdout.write(JSON.stringify({ checkpoint: value }) + "\n");
      ({ done, value } = walk.next());
    }
    process.stdout.write(JSON.stringify(done ? { estimate: value } : { move: value }) + "\n");
  });
