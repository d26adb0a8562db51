// The bench: sliders, the two curves that move with them, the curves that are kept, and the animation.

import { makeAnimation } from "./animation.js";
import { makeChart } from "./chart.js";
import { curvesOf } from "./curves.js";
import { MOST, showKept } from "./kept.js";
import { ask, givenValues, withValue } from "./program.js";
import { digits, quantity } from "./scale.js";
import { makeSliders } from "./sliders.js";
import { written } from "./value.js";

const byId = (id) => document.getElementById(id);
const SPEED = ["impact.speed", "impact.drop_height"];

/**
 * Makes the bench. `change(path, value)` is called while the user moves a value; `keptChanged()` after the kept curves changed.
 */
export function makeBench({ fields, materials, change, keptChanged }) {
  const kept = [];
  let text = "";
  let values = {};
  let now = null;
  let moment = null;
  const speedPath = () => SPEED[now.restitution?.isHeight ? 1 : 0];
  const pick = (at) => change(speedPath(), `${written(at)} ${now.restitution.isHeight ? "m" : "m/s"}`);
  const charts = {
    restitution: makeChart(byId("live-restitution"), { id: "chart-restitution", isByX: true, pick }),
    loop: makeChart(byId("live-loop"), { id: "chart-loop", isByX: false }),
  };
  const sliders = makeSliders(byId("sliders"), { fields, materials, changed: change });
  const animation = makeAnimation(byId("animation"), (row) => {
    moment = row;
    drawLoop();
  });

  const isShown = () => now !== null;
  const shown = () => [now, ...kept.map(({ curves }) => curves)];
  const names = () => ["this scenario", ...kept.map((_, at) => `kept curve ${at + 1}`)];
  const curvesBy = (points) =>
    shown().flatMap((curves, number) =>
      curves && points(curves) ? [{ number, name: names()[number], points: points(curves) }] : [],
    );

  function drawRestitution() {
    byId("live-restitution").hidden = !now.restitution;
    if (!now.restitution) return;
    const { points, isHeight, here } = now.restitution;
    const title = isHeight ? "Drop height" : "Impact speed";
    const unit = isHeight ? "m" : "m/s";
    const [first, last] = [points[0], points.at(-1)];
    const ends = `from ${digits(first[1])} at ${quantity(first[0], unit)} to ${digits(last[1])} at ${quantity(last[0], unit)}`;
    charts.restitution.draw({
      x: { title, unit, low: first[0], high: last[0], isLog: true },
      y: { title: "Restitution", unit: "", low: 0, high: 1.05 },
      // kept ones against the other axis cannot be drawn here
      curves: curvesBy(({ restitution }) =>
        restitution?.isHeight === isHeight ? inside(restitution.points, first[0], last[0]) : null,
      ),
      marks: [{ at: here, number: 0, name: "this impact" }],
      hint: `Click or drag to set the ${title.toLowerCase()}.`,
      about: `Restitution against ${title.toLowerCase()}, ${ends}. This impact: ${digits(here[1])} at ${quantity(here[0], unit)}.${others()}`,
    });
  }

  const inside = (points, low, high) => points.filter(([at]) => at >= low * 0.999 && at <= high * 1.001);
  const others = () => (kept.length > 0 ? ` ${kept.length} kept curves beside it.` : "");

  function drawLoop() {
    if (!now) return;
    const { summary } = now;
    const curves = curvesBy(({ loop }) => loop);
    const most = (place) => Math.max(...curves.flatMap(({ points }) => points.map((point) => point[place])));
    const marks = moment ? [{ at: [moment.indentation, moment.force], number: 0, name: "this moment" }] : [];
    const dent = summary.residual_indentation_m ?? 0;
    charts.loop.draw({
      x: { title: "Indentation", unit: "m", low: 0, high: 1.05 * most(0) },
      y: { title: "Force", unit: "N", low: Math.min(0, ...now.loop.map(([, force]) => force)), high: 1.08 * most(1) },
      curves,
      marks,
      hint: "Values under the pointer, or by arrow keys.",
      about: `Force against indentation: a loop with its peak of ${quantity(summary.peak_force_N, "N")} at ${quantity(summary.peak_indentation_m, "m")}, and ${quantity(dent, "m")} left after unloading.${others()}`,
    });
  }

  // A moved speed stays on the curve on which it began, so that the axis does not jump under the pointer.
  function steady(before, curves, isSame) {
    const old = before?.restitution;
    const fresh = curves.restitution;
    if (!isSame || !old || !fresh || old.isHeight !== fresh.isHeight) return curves;
    const [low, high] = [old.points[0][0], old.points.at(-1)[0]];
    const isInside = fresh.here[0] >= low && fresh.here[0] <= high;
    return isInside ? { ...curves, restitution: { ...fresh, points: old.points } } : curves;
  }

  const bodies = (text) => SPEED.reduce((text, path) => withValue(text, path, ""), text);

  /** Shows the reply to the run of a text; a reply that is no impact hides the bench. */
  function show(reply, newText) {
    const curves = curvesOf(reply);
    byId("bench").hidden = !curves;
    if (curves) {
      now = steady(now, curves, text !== "" && bodies(text) === bodies(newText));
      [text, values] = [newText, givenValues(newText)];
      redraw();
      animation.show(now);
    } else now = null;
  }

  function redraw() {
    byId("keep").disabled = kept.length >= MOST;
    showKept({ key: byId("key"), table: byId("kept") }, kept, values, () => {
      redraw();
      keptChanged();
    });
    drawRestitution();
    drawLoop();
  }

  /** Takes kept scenarios from a link, and asks the program for their curves. */
  async function restore(texts) {
    kept.splice(
      0,
      kept.length,
      ...texts.slice(0, MOST).map((text) => ({ text, values: givenValues(text), curves: null })),
    );
    for (const one of [...kept]) {
      const curves = curvesOf(await ask("kept.toml", one.text, undefined, "none"));
      if (curves) Object.assign(one, { curves });
      else kept.splice(kept.indexOf(one), 1);
    }
    if (isShown()) redraw();
  }

  byId("keep").addEventListener("click", () => {
    if (!now || kept.length >= MOST) return;
    kept.push({ text, values, curves: now });
    redraw();
    keptChanged();
  });
  return { show, restore, fill: (values) => sliders.fill(values), texts: () => kept.map(({ text }) => text) };
}
