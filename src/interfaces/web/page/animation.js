// Ball and dent along the trace of an impact: a drawing that plays, steps and is moved by keys. Depths are drawn larger than the ball.

import { element, svgElement } from "./element.js";
import { quantity } from "./scale.js";

// The drawing: its size, the height of the surface, the radius of the ball, and the deepest dent [px].
const [WIDTH, HEIGHT, SURFACE, BALL, DEEPEST] = [320, 190, 130, 52, 34];
// Pictures before first contact and after separation, and how far the ball moves in each [px].
const [FLIGHT, STRIDE] = [16, 3];
const PLAY_MS = 4000;
const isReduced = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Makes the animation in `place`; `moved(row)` is called with the row of the trace that is shown. */
export function makeAnimation(place, moved) {
  const dent = svgElement("path", { class: "body" });
  const ball = svgElement("circle", { class: "ball", cx: WIDTH / 2, r: BALL });
  const svg = svgElement("svg", { id: "ball", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  svg.append(dent, ball);
  const play = element("button", { type: "button", id: "play" }, "Play");
  const back = element("button", { type: "button", id: "step-back", ariaLabel: "One step back" }, "◂");
  const forth = element("button", { type: "button", id: "step-forth", ariaLabel: "One step forth" }, "▸");
  const time = element("input", { type: "range", id: "moment", min: 0, value: 0, ariaLabel: "Moment of the impact" });
  const said = element("p", { className: "moment" });
  const scale = element("p", { className: "quiet" });
  place.append(svg, element("div", { className: "player" }, play, back, forth, time), said, scale);
  let rows = [];
  let size = 1;
  let frame = null;
  let begun = 0;

  const last = () => rows.length - 1 + 2 * FLIGHT;

  /** Shows another impact, at its deepest point. */
  function show(curves) {
    const deepest = rows.length === 0 || !frame;
    rows = curves.rows;
    const most = Math.max(...rows.map((row) => row.dent), ...rows.map((row) => row.indentation));
    const radius = curves.summary.peak_contact_radius_m / curves.summary.contact_radius_over_R;
    size = DEEPEST / most;
    const factor = Math.round((size * radius) / BALL);
    scale.textContent = factor > 1 ? `Depths are drawn ${factor} times as large as the ball.` : "";
    time.max = last();
    if (deepest)
      time.value =
        FLIGHT + rows.findIndex((row) => row.indentation === Math.max(...rows.map((one) => one.indentation)));
    draw();
  }

  function draw() {
    const at = Number(time.value) - FLIGHT;
    const row = rows[Math.min(Math.max(at, 0), rows.length - 1)];
    const gap = at < 0 ? -at * STRIDE : Math.max(0, at - rows.length + 1) * STRIDE;
    const isBefore = at < 0;
    const depth = isBefore ? 0 : row.dent * size;
    const bottom = SURFACE + depth - gap;
    ball.setAttribute("cy", bottom - BALL);
    const deepest = Math.max(0, ...rows.slice(0, Math.max(at, 0) + 1).map((row) => row.dent)) * size;
    const half = Math.sqrt(Math.max(2 * BALL * deepest - deepest * deepest, 0));
    const middle = WIDTH / 2;
    const rim = `L${middle - half},${SURFACE} Q${middle},${SURFACE + 2 * depth} ${middle + half},${SURFACE}`;
    dent.setAttribute("d", `M0,${SURFACE} ${rim} L${WIDTH},${SURFACE} V${HEIGHT} H0 Z`);
    const isAfter = at > rows.length - 1;
    const where = isBefore ? "before contact" : isAfter ? "after separation" : row.branch;
    const text = `${quantity(row.time, "s")}: indentation ${quantity(row.indentation, "m")}, force ${quantity(row.force, "N")}, ${where}`;
    said.textContent = text;
    svg.setAttribute("aria-label", `Ball and dent. ${text}`);
    time.setAttribute("aria-valuetext", text);
    moved(isBefore || isAfter ? null : row);
  }

  function step(by) {
    stop();
    time.value = Number(time.value) + by;
    draw();
  }

  function stop() {
    cancelAnimationFrame(frame);
    frame = null;
    play.textContent = "Play";
  }

  function run(now) {
    // with less motion the picture changes a few times a second, in steps
    const share = (now - begun) / PLAY_MS;
    const steps = isReduced() ? 8 : last();
    time.value = Math.floor(share * steps) * (last() / steps);
    draw();
    if (share >= 1) stop();
    else frame = requestAnimationFrame(run);
  }

  play.addEventListener("click", () => {
    if (frame) return stop();
    begun = performance.now() - (Number(time.value) >= last() ? 0 : (Number(time.value) / last()) * PLAY_MS);
    play.textContent = "Pause";
    frame = requestAnimationFrame(run);
  });
  back.addEventListener("click", () => step(-1));
  forth.addEventListener("click", () => step(1));
  time.addEventListener("input", () => {
    stop();
    draw();
  });
  return { show };
}
