// Pictures: as they are drawn, or, where there is little room, the key below the axes, so that letters can be read.

import { element } from "./element.js";

// A picture that is narrower than this is divided [px].
const NARROW = 640;
let drawn = [];
let isNarrow = false;

const observer = new ResizeObserver(([{ target }]) => {
  if (drawn.length > 0 && isNarrow !== isIn(target)) draw(target);
});

/** Draws pictures, given as [[name, svg], ...], and draws them anew when their room changes. */
export function drawIn(place, pictures) {
  drawn = pictures;
  observer.observe(place);
  draw(place);
}

const isIn = (place) => place.clientWidth < NARROW;

function draw(place) {
  isNarrow = isIn(place);
  place.replaceChildren(...drawn.map(([name, svg]) => figure(name, svg)));
}

function figure(name, svg) {
  const picture = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  const title = name.replace(".svg", "").replaceAll("_", " ");
  picture.setAttribute("role", "img");
  picture.setAttribute("aria-label", `picture: ${title}`);
  const frame = element("div", { className: "picture" });
  frame.append(...(isNarrow ? divided(picture) : [picture]));
  return element("figure", { id: `picture-${title.replaceAll(" ", "-")}` }, frame);
}

// The part with the axes, and the part beside it, which is the key.
function divided(picture) {
  const [, , width, height] = picture.getAttribute("viewBox").split(" ").map(Number);
  const edge = rightEdge(picture);
  const beside = [...picture.children].map(extent).filter(({ left }) => left > edge);
  if (beside.length === 0) return [picture];
  const margin = 0.01 * width;
  const start = Math.min(...beside.map(({ left }) => left)) - margin;
  const top = Math.min(...beside.map(({ top }) => top)) - margin;
  const bottom = Math.max(...beside.map(({ bottom }) => bottom)) + margin;
  const key = picture.cloneNode(true);
  picture.setAttribute("viewBox", `0 0 ${start} ${height}`);
  key.setAttribute("viewBox", `${start} ${top} ${width - start} ${bottom - top}`);
  key.setAttribute("aria-label", `${picture.getAttribute("aria-label")}: key`);
  key.style.width = `${(100 * (width - start)) / start}%`;
  for (const one of [picture, key]) for (const side of ["width", "height"]) one.removeAttribute(side);
  return [picture, key];
}

// The right edge of the axes: of the first outline, which ends where it begins.
function rightEdge(picture) {
  const corners = [...picture.querySelectorAll("polyline")].map((line) => line.getAttribute("points").trim().split(" "));
  const outline = corners.find((points) => points.length === 5 && points[0] === points[4]);
  return Number(outline[1].split(",")[0]);
}

// Where a shape or a text lies; a text at least this far.
function extent(shape) {
  const number = (name) => Number(shape.getAttribute(name));
  const [x, y, r, size] = [number("x"), number("y"), number("r"), number("font-size")];
  if (shape.tagName === "text") {
    const left = shape.getAttribute("text-anchor") === "start" ? x : x - size;
    return { left, top: y - size, bottom: y + size };
  }
  if (shape.tagName === "circle") return { left: number("cx") - r, top: number("cy") - r, bottom: number("cy") + r };
  if (shape.tagName === "rect") return { left: x, top: y, bottom: y + number("height") };
  const points = shape.getAttribute("points").trim().split(" ").map((point) => point.split(",").map(Number));
  const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
  return { left: Math.min(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
}
