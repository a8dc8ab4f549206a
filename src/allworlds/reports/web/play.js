// The page in which the reader is the robot: it shows what world.js and robot.js say, and passes
// clicks on.

const world = JSON.parse(document.getElementById("play-json").textContent);
const SVG = "http://www.w3.org/2000/svg";
const movable = world.hand > 0;
const changing = movable || world.states > 0; // the robot makes marks itself

let states, log, conclusions, chosen, uncovered, claimed;
let spots; // of the places in the notes: see spots.js
let seen = () => {}; // makes the notes as large as there is room for

function element(name, attributes, ...children) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const at = (id) => document.getElementById(id);
const round = (x) => Math.round(x * 10) / 10;
const polar = (x, y, r, angle) => [round(x + r * Math.cos(angle)), round(y + r * Math.sin(angle))];

// Something that acts when it is clicked, or when Enter or the space bar is pressed on it.
function acting(made, label, act) {
  made.setAttribute("role", "button");
  made.setAttribute("tabindex", "0");
  made.setAttribute("aria-label", label);
  made.addEventListener("click", act);
  made.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    act();
  });
  return made;
}

// ---------------------------------------------------------------- what is sensed

const now = () => sensed(world, states[states.length - 1]);

// The place where the robot stands; dart 0 is behind it, in the direction that it has in the notes.
function drawSensed(behind) {
  const { degree, marks, bearing } = now();
  const [cx, cy, reach] = [150, 150, 100];
  const way = (k) => behind + (2 * Math.PI * k) / degree;
  const parts = [];
  for (let k = 0; k < degree; k += 1) {
    const [x, y] = polar(cx, cy, reach, way(k));
    const line = { x1: cx, y1: cy, x2: x, y2: y };
    const seat = { cx: x, cy: y, r: round(Math.min(17, (reach * 2.8) / degree)) };
    const dart = element(
      "g",
      { class: k === bearing ? "exit pointed" : "exit" },
      element("line", { ...line, class: "reach" }),
      element("line", line),
      element("circle", seat),
      element("text", { x, y }, String(k)),
    );
    if (k === bearing) {
      const [fx, fy] = polar(cx, cy, 52, way(k));
      const turned = round((way(k) * 180) / Math.PI);
      const head = { d: "M14 0 L-4 9 L-4 -9 Z", class: "flag" };
      dart.append(element("path", { ...head, transform: `translate(${fx} ${fy}) rotate(${turned})` }));
    }
    const label = k ? `move ${k}` : log.length ? "move 0: back" : "move 0";
    parts.push(acting(dart, label, () => act({ move: k })));
  }
  const here = element(
    "g",
    { class: marks && !world.labels ? "vertex marked" : "vertex" },
    element("circle", { cx, cy, r: 20 }),
    element("text", { x: cx, y: cy }, world.labels ? marks : marks > 1 ? `×${marks}` : marks ? "●" : ""),
  );
  const drawn = { viewBox: "0 0 300 300", width: 300, height: 300, class: "map", role: "group" };
  at("sensed").replaceChildren(
    element("svg", { ...drawn, "aria-label": `You sense: ${said(world, now())}` }, ...parts, here),
  );
  at("sensed-words").textContent = `You sense: ${said(world, now())}.`;
}

// ---------------------------------------------------------------- the notes

const known = () => notes(log.first, log, conclusions, changing);

// Where each dart is drawn: round the spot of its place, clockwise.
function seated({ places }) {
  place(spots, places);
  const seats = new Map();
  for (const { name, darts } of places) {
    const { x, y, turned, far: room } = spots.get(name);
    darts.forEach((dart, k) => {
      seats.set(dart.name, { x, y, far: room, angle: turned + (2 * Math.PI * k) / darts.length });
    });
  }
  return seats;
}

function edgePath(a, b) {
  const [ax, ay] = polar(a.x, a.y, a.far + 4, a.angle);
  const [bx, by] = polar(b.x, b.y, b.far + 4, b.angle);
  const loop = a.x === b.x && a.y === b.y;
  const bend = loop ? 75 : 34 + 0.35 * Math.hypot(bx - ax, by - ay);
  const [px, py] = polar(a.x, a.y, a.far + bend, a.angle);
  const [qx, qy] = polar(b.x, b.y, b.far + bend, b.angle);
  return `M${a.x} ${a.y} L${ax} ${ay} C${px} ${py} ${qx} ${qy} ${bx} ${by} L${b.x} ${b.y}`;
}

function drawNotes() {
  const map = known();
  const seats = seated(map);
  drawSensed(seats.get(map.here).angle);
  const parts = [];
  for (const { darts } of map.places) {
    for (const { name, end } of darts) {
      const a = seats.get(name);
      if (end === null) {
        const [x2, y2] = polar(a.x, a.y, a.far + 14, a.angle);
        parts.push(element("line", { x1: a.x, y1: a.y, x2, y2, class: "open-dart" }));
      } else if (name < end) {
        parts.push(element("path", { class: "edge walked", d: edgePath(a, seats.get(end)) }));
      }
    }
  }
  for (const { name, percept, darts } of map.places) {
    const { x, y } = spots.get(name);
    const disc = element(
      "g",
      { class: percept.marks && !changing && !world.labels ? "vertex marked" : "vertex" },
      element("circle", { cx: x, cy: y, r: 14 }),
      element("text", { x, y }, String(name)),
    );
    darts.forEach((dart, k) => {
      const { angle, far: room } = seats.get(dart.name);
      const [dx, dy] = polar(x, y, room, angle);
      const classes = ["note-dart"];
      if (dart.name === chosen) classes.push("chosen");
      if (dart.name === map.here) classes.push("robot-here");
      if (k === percept.bearing) classes.push("pointed");
      const drawn = element(
        "g",
        { class: classes.join(" ") },
        element("circle", { cx: dx, cy: dy, r: 11 }),
        element("text", { x: dx, y: dy }, String(k)),
      );
      const label = `place ${name}, dart ${k}`;
      parts.push(acting(drawn, label, () => choose(dart.name)));
    });
    parts.push(disc);
  }
  const { left, top, width, height } = box(spots, map.places);
  const drawn = { viewBox: `${left} ${top} ${width} ${height}`, class: "map notes" };
  const svg = element("svg", { ...drawn, role: "group", "aria-label": "Your notes" }, ...parts);
  at("notes").replaceChildren(svg);
  seen = () => {
    const { x, y } = seats.get(map.here);
    follow(svg, { x: x - left, y: y - top, width, height });
  };
  seen();
  const many = openDarts(map).length;
  const open = many === 1 ? "1 dart is open" : `${many} darts are open`;
  at("notes-words").textContent = map.wrong
    ? `That cannot be: ${map.wrong}. Take the last conclusion back.`
    : chosen
      ? `Dart ${chosen} is the same as ... (click the other one).`
      : many
        ? `${open}. Arriving anywhere you draw a new place; click two darts to say that they are one.`
        : "No dart is open: your map is complete. Is it the world?";
  at("undo").disabled = !conclusions.length;
  at("claim").disabled = !estimate(map);
}

// All notes are seen while they can be read; larger ones scroll, with the robot in the middle.
const SMALLEST_NOTES = 0.55;
const HIGHEST_NOTES = 0.75; // of the window

function follow(svg, { x, y, width, height }) {
  const frame = at("notes");
  if (!frame.clientWidth) return;
  const room = Math.min(frame.clientWidth / width, (HIGHEST_NOTES * innerHeight) / height);
  const scale = Math.max(SMALLEST_NOTES, Math.min(1, room));
  svg.setAttribute("width", Math.floor(width * scale));
  svg.setAttribute("height", Math.floor(height * scale));
  frame.scrollLeft = x * scale - frame.clientWidth / 2;
  frame.scrollTop = y * scale - frame.clientHeight / 2;
}

new ResizeObserver(() => seen()).observe(at("notes"));

function choose(name) {
  if (chosen === null) chosen = name;
  else {
    const pair = [chosen, name].map((dart) => dart.split(".").map(Number));
    if (chosen !== name) conclusions.push(pair);
    chosen = null;
  }
  at("outcome").textContent = "";
  drawNotes();
}

function claim() {
  claimed = isWorld(estimate(known()), world, states[states.length - 1].dart);
  at("outcome").textContent = claimed
    ? "Right: this is the world, and you know where in it you are."
    : "It fits all that you have sensed, but it is another world: you have guessed. Walk on, or " +
      "take a conclusion back.";
  drawCosts();
}

// ---------------------------------------------------------------- the walk, and the world

const moves = () => log.filter(({ action }) => action.move !== undefined).length;

// What others walk in this world tells something of it, and so comes at the end.
function drawCosts() {
  at("costs").hidden = !claimed && !uncovered;
  const bound = world.costs.bound === null ? [] : [["the bound of this world", world.costs.bound]];
  at("cost-rows").replaceChildren(
    ...[["you", moves()], ...world.costs.others, ...bound].map(([who, cost]) => {
      const row = document.createElement("tr");
      for (const text of [who, cost.toLocaleString("en")]) row.insertCell().textContent = text;
      return row;
    }),
  );
}

function drawLog() {
  const lines = [["start", log.first], ...log.map(({ action, percept }) => [named(action), percept])];
  at("log").replaceChildren(
    ...lines.map(([action, percept]) => {
      const item = document.createElement("li");
      item.textContent = `${action}: ${said(world, percept)}`;
      return item;
    }),
  );
  at("cost").textContent = `Traversals so far: ${moves()}.`;
}

const fits = [...at("world").querySelectorAll(".frame")].map((one) => fitting(one, SMALLEST_STILL));
function fitWorld() {
  for (const fit of fits) fit(1);
}
new ResizeObserver(fitWorld).observe(at("world"));

function drawWorld() {
  at("world").hidden = !uncovered;
  fitWorld();
  at("uncover").hidden = uncovered;
  for (const one of at("world").querySelectorAll(".walked, .here")) {
    one.classList.remove("walked", "here");
  }
  log.forEach(({ action }, i) => {
    if (action.move === undefined) return;
    const { dart } = states[i + 1];
    for (const edge of at("world").querySelectorAll("[data-darts]")) {
      if (edge.dataset.darts.split(" ").includes(String(dart))) edge.classList.add("walked");
    }
  });
  const { dart } = states[states.length - 1];
  for (const seat of at("world").querySelectorAll(`[data-dart="${dart}"]`)) {
    seat.classList.add("here");
  }
}

function act(action) {
  const state = states[states.length - 1];
  const why = refusal(world, state, action);
  at("outcome").textContent = why ? `That is not possible: ${why}.` : "";
  if (why) return;
  claimed = false;
  states.push(step(world, state, action));
  log.push({ action, percept: now() });
  draw();
}

function draw() {
  drawNotes();
  drawLog();
  drawWorld();
  drawCosts();
  const state = states[states.length - 1];
  at("hand").textContent = movable ? `Markers in your hand: ${state.hand}.` : "";
  at("drop").disabled = refusal(world, state, { drop: true }) !== "";
  at("pick").disabled = refusal(world, state, { pick: true }) !== "";
}

function restart() {
  states = [begin(world)];
  log = [];
  log.first = now();
  conclusions = [];
  chosen = null;
  uncovered = false;
  claimed = false;
  spots = new Map();
  at("outcome").textContent = "";
  draw();
}

const BUTTONS = {
  drop: () => act({ drop: true }),
  pick: () => act({ pick: true }),
  write: () => act({ write: at("number").valueAsNumber }),
  undo: () => { conclusions.pop(); chosen = null; at("outcome").textContent = ""; drawNotes(); },
  claim,
  uncover: () => { uncovered = true; drawWorld(); drawCosts(); },
  restart,
};
for (const [id, pressed] of Object.entries(BUTTONS)) at(id).addEventListener("click", pressed);
for (const id of ["drop", "pick"]) at(id).hidden = !movable;
for (const id of ["number", "write"]) at(id).hidden = !world.states;
at("number").max = world.states - 1;
document.addEventListener("keydown", (event) => {
  if (event.target === at("number")) return; // it is typed there
  if (event.altKey || event.ctrlKey || event.metaKey || !/^[0-9]$/.test(event.key)) return;
  if (Number(event.key) < now().degree) act({ move: Number(event.key) });
});
at("game").hidden = false;
restart();
