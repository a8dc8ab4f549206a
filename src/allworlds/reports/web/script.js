// Keys and buttons step along a walk; without this script the list of its steps is all there.

const KEYS = {
  ArrowLeft: "back", ArrowRight: "next", Home: "first", End: "last", " ": "play",
  "+": "in", "=": "in", "-": "out",
};
const MARKED = ["walked", "trail", "last", "here"]; // Of one step each.
const TRAIL = 3; // So many steps before the last are shown, too.

function element(svg, name, attributes, text = "") {
  const made = document.createElementNS(svg.namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

// A picture, which follows the robot in one of the worlds.
function makePicture(frame) {
  const svg = frame.querySelector("svg");
  const arrows = svg.querySelector(".arrows");
  const { follows } = frame.dataset;
  const fit = fitting(frame, SMALLEST);
  const edges = new Map();
  for (const edge of svg.querySelectorAll("[data-darts]")) {
    for (const dart of edge.dataset.darts.split(" ")) {
      edges.set(dart, [...(edges.get(dart) || []), edge]);
    }
  }
  const grown = [...svg.querySelectorAll("[data-since]")];

  function arrow(edge, dart, step) {
    const length = edge.getTotalLength();
    // The dart is the one by which it arrives: the edge is drawn from its first dart to its second.
    const back = edge.dataset.darts.split(" ")[0] === dart;
    const at = edge.getPointAtLength(length / 2);
    const ahead = edge.getPointAtLength(length / 2 + (back ? -1 : 1));
    const angle = Math.atan2(ahead.y - at.y, ahead.x - at.x);
    const outer = element(svg, "g", { transform: `translate(${at.x} ${at.y})`, class: "arrow" });
    const inner = element(svg, "g", { class: "fixed" });
    const turn = `rotate(${(angle * 180) / Math.PI})`;
    inner.append(element(svg, "path", { d: "M10 0 L-7 -7 L-7 7 Z", transform: turn }));
    const away = { x: -18 * Math.sin(angle), y: 18 * Math.cos(angle) }; // Beside the edge.
    inner.append(element(svg, "text", away, step));
    outer.append(inner);
    arrows.append(outer);
  }

  // The darts by which robots have arrived in a step: of one robot its own.
  function moved(item) {
    if (!("moved" in item.dataset)) return [];
    return (item.dataset.moved || item.dataset[follows]).split(" ");
  }

  // Which robot is where, and the words of the world.
  function drawTeam(robots, { vertices = "{}", edges: known = "{}" }) {
    for (const part of svg.querySelectorAll(".who")) part.remove();
    for (const part of svg.querySelectorAll(".told")) part.classList.remove("told");
    const here = new Map();
    for (const [robot, dart] of robots.entries()) {
      here.set(dart, [...(here.get(dart) || []), robot]);
    }
    here.delete("-");
    for (const [dart, some] of here) {
      const place = svg.querySelector(`[data-dart="${dart}"]`);
      place.append(element(svg, "text", { class: "who", y: -16 }, some.map((each) => `r${each}`).join(" ")));
    }
    for (const [vertex, words] of Object.entries(JSON.parse(vertices))) {
      const place = svg.querySelector(`[data-vertex="${vertex}"]`);
      place.classList.add("told");
      place.firstElementChild.append(element(svg, "text", { class: "who", y: 34 }, words));
    }
    for (const [dart, words] of Object.entries(JSON.parse(known))) {
      for (const edge of edges.get(dart)) {
        edge.classList.add("told");
        const at = edge.getPointAtLength(edge.getTotalLength() / 2);
        arrows.append(element(svg, "text", { class: "who", x: at.x, y: at.y }, words));
      }
    }
  }

  function draw(items, current) {
    for (const one of svg.querySelectorAll(MARKED.map((name) => `.${name}`).join())) {
      one.classList.remove(...MARKED);
    }
    arrows.replaceChildren();
    for (const [step, item] of items.slice(0, current + 1).entries()) {
      for (const dart of moved(item)) {
        for (const { classList } of edges.get(dart)) {
          classList.add("walked");
          if (step > current - TRAIL && step < current) classList.add("trail");
        }
      }
    }
    for (const dart of moved(items[current])) {
      for (const edge of edges.get(dart)) {
        edge.classList.add("last");
        arrow(edge, dart, current);
      }
    }
    const robots = items[current].dataset[follows].split(" ");
    for (const dart of new Set(robots)) {
      if (dart !== "-") svg.querySelector(`[data-dart="${dart}"]`).classList.add("here");
    }
    if (follows === "robots") drawTeam(robots, items[current].dataset);
    for (const part of grown) {
      part.classList.toggle("later", Number(part.dataset.since) > current);
      if ("until" in part.dataset) {
        part.classList.toggle("gone", Number(part.dataset.until) <= current);
      }
    }
  }

  return { frame, fit, draw };
}

function made(name, text, attributes = {}) {
  const part = document.createElement(name);
  part.textContent = text;
  for (const [key, value] of Object.entries(attributes)) part.setAttribute(key, value);
  return part;
}

const MOST_NUMBERS = 16; // So many of the numbers that can be written are offered.

// Another way than the explorer's, from the step that is shown: the reader is the robot, the world
// answers, as in world.js, and the explorer is not asked. `world.walk` holds the state at each step.
// `tell` is given the steps of that way, each time there is one more, and `back` leads back to the
// walk. What comes back is to be called with each step that is shown; null where the page has no
// such world.
function otherWay(viewer, items, tell, back) {
  const data = viewer.querySelector(".ways");
  if (!data) return null;
  const world = JSON.parse(data.textContent);
  const walked = items.slice(1).map((item) => actionNamed(item.querySelector(".motion").textContent));
  const whole = made("details", "", { class: "another" });
  const row = made("p", "", { class: "rows", role: "group", "aria-label": "Ways to go" });
  const list = made("ol", "", { class: "walk", role: "list", "aria-label": "The other way" });
  // Below the list: whoever clicks twice at one place does not go back.
  const leave = made("button", "", { type: "button" });
  let from, state;

  function offer() {
    const { degree } = sensed(world, state);
    const actions = [...Array(degree).keys()].map((k) => ({ move: k }));
    if (world.hand) actions.push({ drop: true }, { pick: true });
    for (let k = 0; k < Math.min(world.states, MOST_NUMBERS); k += 1) actions.push({ write: k });
    const buttons = actions.filter((action) => !refusal(world, state, action)).map((action) => {
      const its = !list.children.length && walked[from] && named(walked[from]) === named(action);
      const button = made("button", named(action) + (its ? " (as it did)" : ""), { type: "button" });
      button.addEventListener("click", () => go(action));
      return button;
    });
    const focused = [...row.children, leave].indexOf(document.activeElement);
    row.replaceChildren(...buttons);
    leave.textContent = `Back to step ${from}`;
    leave.hidden = !list.children.length;
    if (focused >= 0) buttons[Math.min(focused, buttons.length - 1)].focus();
  }

  function go(action) {
    state = step(world, state, action);
    const item = made("li", "");
    item.append(
      made("span", from + list.children.length + 1, { class: "step" }),
      made("span", named(action), { class: "motion" }),
      made("span", world.places[state.dart], { class: "place" }),
      made("span", `sensed: ${said(world, sensed(world, state))}`, { class: "sensed" }),
    );
    item.dataset.robot = state.dart;
    if (action.move !== undefined) item.dataset.moved = "";
    list.append(item);
    list.scrollTop = list.scrollHeight;
    offer();
    tell(from, [...list.children]);
  }

  whole.append(made("summary", "Go another way"), row, list, leave);
  leave.addEventListener("click", () => back(from));
  viewer.querySelector(".controls").before(whole);
  // On a phone the picture of the world may be behind another one.
  whole.addEventListener("toggle", () => {
    if (whole.open) viewer.querySelector(".tabs button")?.click();
    offer();
  });
  return (current) => {
    from = current;
    state = world.walk[from];
    list.replaceChildren();
    offer();
  };
}

function makeViewer(viewer) {
  const items = [...viewer.querySelectorAll(".walk > li")];
  const list = viewer.querySelector(".walk");
  const now = viewer.querySelector(".now");
  const slider = viewer.querySelector(".slider");
  const playing = viewer.querySelector(".play");
  const speed = viewer.querySelector(".speed");
  const last = items.length - 1;
  const pictures = [...viewer.querySelectorAll("[data-follows]")].map(makePicture);
  let current = 0;
  let timer = 0;
  let zoom = 1;
  const another = otherWay(viewer, items, aside, (from) => show(from));
  const wordsOf = (item) => [...item.children].slice(1).map((part) => part.textContent).join("; ");

  function show(step) {
    items[current].removeAttribute("aria-current");
    current = Math.max(0, Math.min(last, step));
    const item = items[current];
    item.setAttribute("aria-current", "step");
    for (const picture of pictures) picture.draw(items, current);
    if (another) another(current);
    now.textContent = `Step ${current} of ${last}: ${wordsOf(item)}`;
    slider.value = current;
    slider.setAttribute("aria-valuetext", now.textContent);
    // Only the list is scrolled, never the page.
    const top = item.offsetTop - list.offsetTop;
    if (top < list.scrollTop) list.scrollTop = top;
    const below = top + item.offsetHeight - list.clientHeight;
    if (below > list.scrollTop) list.scrollTop = below;
  }

  // The robot goes on from a step of the walk in another way, in the picture of the world.
  function aside(from, steps) {
    stop();
    const way = [...items.slice(0, from + 1), ...steps];
    for (const { frame, draw } of pictures) {
      if (frame.dataset.follows === "robot") draw(way, way.length - 1);
    }
    now.textContent = `Another way, step ${way.length - 1}: ${wordsOf(way[way.length - 1])}`;
  }

  function stop() {
    clearTimeout(timer);
    timer = 0;
    playing.textContent = "Play";
  }

  function tick() {
    show(current + 1);
    if (current === last) stop();
    else timer = setTimeout(tick, Number(speed.value));
  }

  function play() {
    if (timer) {
      stop();
      return;
    }
    if (current === last) show(0);
    playing.textContent = "Pause";
    timer = setTimeout(tick, Number(speed.value));
  }

  function fit() {
    for (const picture of pictures) picture.fit(zoom);
  }

  function go(where) {
    if (where === "play") play();
    else if (where === "in" || where === "out") {
      zoom = Math.max(0.5, Math.min(4, zoom * (where === "in" ? 1.25 : 0.8)));
      fit();
    } else {
      stop();
      show({ first: 0, back: current - 1, next: current + 1, last }[where]);
    }
  }

  function makeTabs() {
    const figures = [...viewer.querySelectorAll("figure")];
    const tabs = viewer.querySelector(".tabs");
    if (figures.length < 2) {
      for (const figure of figures) figure.classList.add("shown");
      return;
    }
    tabs.hidden = false;
    const buttons = figures.map((figure, chosen) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = figure.dataset.title;
      button.addEventListener("click", () => choose(chosen));
      tabs.append(button);
      return button;
    });
    function choose(chosen) {
      figures.forEach((figure, i) => figure.classList.toggle("shown", i === chosen));
      buttons.forEach((button, i) => button.setAttribute("aria-pressed", i === chosen));
      fit();
    }
    choose(0);
  }

  viewer.classList.add("stepping");
  for (const part of viewer.querySelectorAll(".controls, .keys, .trail-key, .last-key")) part.hidden = false;
  for (const button of viewer.querySelectorAll("[data-go]")) {
    button.addEventListener("click", () => go(button.dataset.go));
  }
  for (const button of viewer.querySelectorAll("[data-zoom]")) {
    button.addEventListener("click", () => go(button.dataset.zoom));
  }
  playing.addEventListener("click", play);
  slider.max = last;
  slider.addEventListener("input", () => {
    stop();
    show(Number(slider.value));
  });
  items.forEach((item, step) => {
    item.querySelector(".step").addEventListener("click", (event) => {
      event.preventDefault();
      stop();
      show(step);
    });
  });
  makeTabs();
  new ResizeObserver(fit).observe(viewer);
  fit();
  const parting = items.findIndex((item) => item.classList.contains("parting"));
  const target = items.findIndex((item) => `#${item.id}` === location.hash);
  show(target >= 0 ? target : parting >= 0 ? parting : last);
  return { viewer, go, fit };
}

const viewers = [...document.querySelectorAll(".viewer")].map(makeViewer);
let latest = viewers[0];

document.addEventListener("keydown", (event) => {
  const where = KEYS[event.key];
  if (!where || event.altKey || event.ctrlKey || event.metaKey) return;
  const { target } = event;
  // What has keys of its own keeps them: buttons the space bar, the slider and the list of speeds all.
  if (target.matches("input, select") || (where === "play" && target.matches("button, a, summary"))) {
    return;
  }
  const inside = viewers.find(({ viewer }) => viewer.contains(target));
  // Elsewhere on the page Home, End and the space bar scroll, as ever.
  const anywhere = target === document.body && event.key.startsWith("Arrow");
  latest = inside || latest;
  if (!latest || !(inside || anywhere)) return;
  event.preventDefault();
  latest.go(where);
});

async function copy(source) {
  const text = source.textContent;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // A page opened as a file may have no clipboard of its own.
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    if (!done) throw new Error("not copied");
  }
}

for (const button of document.querySelectorAll("[data-copy]")) {
  const label = button.textContent;
  button.hidden = false;
  button.addEventListener("click", async () => {
    try {
      await copy(document.getElementById(button.dataset.copy));
      button.textContent = "Copied";
    } catch {
      button.textContent = "Could not be copied";
    }
    button.focus();
    setTimeout(() => { button.textContent = label; }, 2000);
  });
}

addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("details")) details.open = true;
});
