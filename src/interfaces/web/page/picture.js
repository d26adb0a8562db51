// Pictures, and the room that they have.

import { element } from "./element.js";

// Pictures are drawn for a narrow place, the key below the axes, where there is less room than this [px].
const NARROW = 640;

/** Whether pictures in this place are to be narrow. */
export const isNarrow = (place) => place.clientWidth < NARROW;

/** Calls `changed()` when that has become otherwise. */
export function onRoom(place, changed) {
  let before = isNarrow(place);
  new ResizeObserver(() => {
    if (isNarrow(place) === before) return;
    before = !before;
    changed();
  }).observe(place);
}

/** A picture of that name. */
export function picture(name, svg) {
  const drawn = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  const title = name.replace(".svg", "").replaceAll("_", " ");
  drawn.setAttribute("role", "img");
  drawn.setAttribute("aria-label", `picture: ${title}. ${words(drawn).join("; ")}`);
  const frame = element("div", { className: "picture" });
  frame.append(document.importNode(drawn, true));
  return element("figure", { id: `picture-${title.replaceAll(" ", "-")}` }, frame);
}

// The words in a picture, without the numbers of its axes: title, names of axes and curves, values of points.
function words(drawn) {
  const texts = [...drawn.querySelectorAll("text")].map((one) => one.textContent.trim());
  return texts.filter((text) => /\p{L}{2}/u.test(text));
}
