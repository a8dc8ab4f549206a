"use strict";
// A picture is as large as there is room for; what is written in it keeps its size.

const SMALLEST = 0.6; // A picture is made so small at most, so that its numbers have room.
const SMALLEST_STILL = 0.5; // One without a walk, in which there is less to be seen.
const HIGHEST = 0.5; // Of the window's height, so that the buttons are seen with the picture.

// A function from a zoom to nothing, which makes the picture in the frame so large.
function fitting(frame, smallest) {
  const svg = frame.querySelector("svg");
  const { width, height } = svg.viewBox.baseVal;
  return (zoom) => {
    if (!frame.clientWidth) return;
    const free = Math.min(frame.clientWidth / width, (HIGHEST * innerHeight) / height);
    const room = Math.min(1.25, Math.max(smallest, free));
    const scale = Math.min(room * zoom, 6);
    svg.style.width = `${width * scale}px`;
    svg.style.height = `${height * scale}px`;
    svg.style.setProperty("--k", 1 / scale);
  };
}

// A picture without a walk follows nothing.
for (const frame of document.querySelectorAll('[data-follows=""]')) {
  const fit = fitting(frame, SMALLEST_STILL);
  new ResizeObserver(() => fit(1)).observe(frame);
  fit(1);
}
