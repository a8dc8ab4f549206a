"use strict";
// Keys and buttons step along a walk; without this script the list of its steps is all there.

const KEYS = { ArrowLeft: "back", ArrowRight: "next", Home: "first", End: "last" };

function makeViewer(viewer) {
  const items = [...viewer.querySelectorAll(".walk > li")];
  const list = viewer.querySelector(".walk");
  const now = viewer.querySelector(".now");
  const last = items.length - 1;
  const frames = [...viewer.querySelectorAll("[data-follows]")].map((frame) => {
    const edges = new Map();
    for (const edge of frame.querySelectorAll("[data-darts]")) {
      for (const dart of edge.dataset.darts.split(" ")) edges.set(dart, edge);
    }
    return { frame, edges, follows: frame.dataset.follows };
  });
  let current = 0;

  function draw({ frame, edges, follows }) {
    for (const one of frame.querySelectorAll(".walked, .last, .here")) {
      one.classList.remove("walked", "last", "here");
    }
    for (const item of items.slice(0, current + 1)) {
      if ("moved" in item.dataset) edges.get(item.dataset[follows]).classList.add("walked");
    }
    const { moved } = items[current].dataset;
    const dart = items[current].dataset[follows];
    if (moved !== undefined) edges.get(dart).classList.add("last");
    frame.querySelector(`[data-dart="${dart}"]`).classList.add("here");
  }

  function show(step) {
    items[current].removeAttribute("aria-current");
    current = Math.max(0, Math.min(last, step));
    const item = items[current];
    item.setAttribute("aria-current", "step");
    frames.forEach(draw);
    const words = [...item.children].slice(1).map((part) => part.textContent);
    now.textContent = `Step ${current} of ${last}: ${words.join("; ")}`;
    // Only the list is scrolled, never the page.
    const top = item.offsetTop - list.offsetTop;
    if (top < list.scrollTop) list.scrollTop = top;
    const below = top + item.offsetHeight - list.clientHeight;
    if (below > list.scrollTop) list.scrollTop = below;
  }

  function go(where) {
    show({ first: 0, back: current - 1, next: current + 1, last }[where]);
  }

  viewer.classList.add("stepping");
  for (const part of viewer.querySelectorAll(".controls, .keys, .last-key")) part.hidden = false;
  for (const button of viewer.querySelectorAll("[data-go]")) {
    button.addEventListener("click", () => go(button.dataset.go));
  }
  items.forEach((item, step) => {
    item.querySelector(".step").addEventListener("click", (event) => {
      event.preventDefault();
      show(step);
    });
  });
  const parting = items.findIndex((item) => item.classList.contains("parting"));
  const target = items.findIndex((item) => `#${item.id}` === location.hash);
  show(target >= 0 ? target : parting >= 0 ? parting : last);
  return { viewer, go };
}

const viewers = [...document.querySelectorAll(".viewer")].map(makeViewer);
let latest = viewers[0];

document.addEventListener("keydown", (event) => {
  const where = KEYS[event.key];
  if (!where || event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
  const inside = viewers.find(({ viewer }) => viewer.contains(event.target));
  // Elsewhere on the page Home and End scroll, as ever.
  const anywhere = event.target === document.body && event.key.startsWith("Arrow");
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
