// A chart that moves: curves from the numbers of the program, values under the pointer, finger or keys, and a point that may be chosen.

import { svgElement } from "./element.js";
import { makeScale, prefixed, quantity } from "./scale.js";

// The heights of a chart over its width, the least height, and margins in letters.
const SHAPE = 0.62;
const MARGIN = { left: 4.2, right: 1.2, top: 0.8, bottom: 3.2 };

/**
 * Makes a chart in `place`. `draw(state)` shows a state: axes `x` and `y` with title, unit, low, high and isLog; `curves` with name,
 * points and number; `marks` with a point and a name; `about`, what the picture shows in words. `isByX` reads the curves along x
 * alone. `pick(x)` is called when the user chooses a place by click, drag or Enter.
 */
export function makeChart(place, { id, isByX, pick }) {
  const svg = svgElement("svg", { id, role: "img", tabindex: 0, class: pick ? "chart picks" : "chart" });
  const read = document.createElement("output");
  read.className = "read";
  read.id = `${id}-read`;
  svg.setAttribute("aria-describedby", read.id);
  place.append(svg, read);
  let state = null;
  let scales = null;
  // the place under the pointer: the curve and its point
  let cursor = null;
  let isDragged = false;

  function draw(newState) {
    state = newState;
    svg.setAttribute("aria-label", state.about);
    const letter = parseFloat(getComputedStyle(place).fontSize) * 0.85;
    const width = Math.max(place.clientWidth, 240);
    const height = Math.max(width * SHAPE, 200);
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    svg.setAttribute("font-size", letter);
    const [left, right] = [MARGIN.left * letter, width - MARGIN.right * letter];
    const [top, bottom] = [MARGIN.top * letter, height - MARGIN.bottom * letter];
    const x = makeScale(state.x, [left, right], 4 * letter);
    const y = makeScale(state.y, [bottom, top], 2.5 * letter);
    scales = { x, y, left, right, top, bottom };
    svg.replaceChildren(...axes(letter, height), ...curves(), ...marks(), ...shownCursor());
    if (!cursor) read.textContent = state.hint ?? "";
  }

  function axes(letter, height) {
    const { x, y, left, right, top, bottom } = scales;
    const [ofX, ofY] = [axisUnit(state.x), axisUnit(state.y)];
    const made = [svgElement("rect", { class: "area", x: left, y: top, width: right - left, height: bottom - top })];
    for (const { value, text } of ofX.ticks(x)) {
      const at = x.at(value);
      made.push(svgElement("line", { class: "grid", x1: at, x2: at, y1: top, y2: bottom }));
      made.push(
        svgElement("text", { class: "tick-x", x: at, y: bottom + 1.3 * letter, "text-anchor": "middle" }, text),
      );
    }
    for (const { value, text } of ofY.ticks(y)) {
      const at = y.at(value);
      made.push(svgElement("line", { class: "grid", x1: left, x2: right, y1: at, y2: at }));
      made.push(svgElement("text", { x: left - 0.4 * letter, y: at + 0.35 * letter, "text-anchor": "end" }, text));
    }
    const middle = (top + bottom) / 2;
    const turned = { x: 0, y: 0, "text-anchor": "middle", transform: `translate(${letter},${middle}) rotate(-90)` };
    made.push(
      svgElement("text", { x: (left + right) / 2, y: height - 0.5 * letter, "text-anchor": "middle" }, ofX.title),
      svgElement("text", turned, ofY.title),
    );
    return made;
  }

  // the unit with a prefix for a linear axis; a logarithmic one has the unit alone
  function axisUnit(axis) {
    const { factor, unit } = axis.isLog ? { factor: 1, unit: axis.unit } : prefixed(axis.high, axis.unit);
    const title = unit ? `${axis.title} (${unit})` : axis.title;
    if (axis.isLog) return { title, ticks: (scale) => scale.ticks };
    const scaled = { low: axis.low / factor, high: axis.high / factor };
    const ticks = (scale) => {
      const ends = [scale.at(axis.low), scale.at(axis.high)];
      const room = axis === state.x ? 60 : 36;
      return makeScale(scaled, ends, room).ticks.map(({ value, text }) => ({ value: value * factor, text }));
    };
    return { title, ticks };
  }

  function curves() {
    const { x, y } = scales;
    return state.curves.map(({ points, number }) => {
      const path = points.map(([a, b]) => `${x.at(a).toFixed(2)},${y.at(b).toFixed(2)}`).join(" ");
      return svgElement("polyline", { class: `curve c${number}`, points: path });
    });
  }

  function marks() {
    return state.marks.map(({ at: [a, b], number, name }) =>
      svgElement("circle", {
        class: `mark c${number}`,
        cx: scales.x.at(a),
        cy: scales.y.at(b),
        r: 6,
        "aria-label": name,
      }),
    );
  }

  function shownCursor() {
    if (!cursor || !state.curves[cursor.curve]?.points[cursor.at]) return [];
    const [a, b] = state.curves[cursor.curve].points[cursor.at];
    const [cx, cy] = [scales.x.at(a), scales.y.at(b)];
    const name = state.curves.length > 1 ? `${state.curves[cursor.curve].name}: ` : "";
    read.textContent = `${name}${state.y.title} ${quantity(b, state.y.unit)} at ${state.x.title.toLowerCase()} ${quantity(a, state.x.unit)}`;
    return [
      svgElement("line", { class: "hair", x1: cx, x2: cx, y1: scales.top, y2: scales.bottom }),
      svgElement("circle", { class: "cursor", cx, cy, r: 4 }),
    ];
  }

  // where a pointer is, in the units of the drawing
  function position(event) {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [Math.min(Math.max(point.x, scales.left), scales.right), point.y];
  }

  function nearest([px, py]) {
    let best = null;
    let least = Infinity;
    state.curves.forEach(({ points }, curve) =>
      points.forEach(([a, b], at) => {
        const [dx, dy] = [scales.x.at(a) - px, scales.y.at(b) - py];
        // along x the place is the column of the pointer, and the curve the nearest in it
        const distance = isByX ? dx * dx * 1e6 + dy * dy : dx * dx + dy * dy;
        if (distance < least) [best, least] = [{ curve, at }, distance];
      }),
    );
    return best;
  }

  function show(found) {
    cursor = found;
    if (state) draw(state);
  }

  function choose(event) {
    if (pick && state) pick(scales.x.value(position(event)[0]));
  }

  svg.addEventListener("pointerdown", (event) => {
    if (!state || event.button > 0) return;
    isDragged = Boolean(pick);
    svg.setPointerCapture(event.pointerId);
    show(nearest(position(event)));
    // a finger may have come to scroll: that is known when it moves
    if (isDragged && event.pointerType !== "touch") choose(event);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!state) return;
    show(nearest(position(event)));
    if (isDragged) choose(event);
  });
  svg.addEventListener("pointerup", (event) => {
    if (isDragged) choose(event);
    isDragged = false;
  });
  svg.addEventListener("pointercancel", () => (isDragged = false));
  svg.addEventListener("pointerleave", () => !isDragged && show(null));
  svg.addEventListener("blur", () => show(null));
  svg.addEventListener("keydown", (event) => {
    if (!state?.curves.length) return;
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: 1, ArrowDown: -1, PageUp: 20, PageDown: -20 }[event.key];
    if (step) {
      event.preventDefault();
      const { curve = 0, at = Math.floor(state.curves[0].points.length / 2) } = cursor ?? {};
      const last = state.curves[curve].points.length - 1;
      show({ curve, at: Math.min(Math.max(at + step, 0), last) });
    } else if (event.key === "Enter" && cursor && pick) pick(state.curves[cursor.curve].points[cursor.at][0]);
    else if (event.key === "Escape") show(null);
  });
  new ResizeObserver(() => state && draw(state)).observe(place);
  return { draw };
}
