// Shows the reply to a run: warnings, numbers, pictures, files.

import { download, element } from "./element.js";
import { blocks, csvTable, lastStep, shortened } from "./numbers.js";
import { picture } from "./picture.js";

const at = (id) => document.getElementById(id);
// So many rows of a long table are shown.
const SHOWN = 10;
let areThere = false;

/** Shows the results of a scenario. */
export function showResults({ kind, warnings, text, contradiction, files, curve }) {
  const cautions = [...warnings, ...(contradiction ? [contradiction] : [])];
  at("warnings").replaceChildren(...cautions.map((text) => element("li", text)));
  at("warnings").hidden = cautions.length === 0;
  const table = files["table.csv"];
  at("numbers").replaceChildren(...blocks(text), ...(table ? [csvTable("table.csv", table, SHOWN)] : []));
  const all = { ...files, ...curve };
  const pictures = Object.entries(all).filter(([name]) => name.endsWith(".svg"));
  at("pictures").replaceChildren(...pictures.map(([name, svg]) => picture(name, svg)));
  const buttons = Object.entries(all).map(([name, content]) => {
    const button = element("button", { type: "button" }, name);
    button.addEventListener("click", () => download(name, content));
    return button;
  });
  at("files").replaceChildren("Download: ", ...buttons.flatMap((button) => [button, " "]));
  at("files").hidden = false;
  at("results").classList.remove("old");
  areThere = true;
  // this is what a screen reader says of a change, and what stays in view
  const lines = text.trim().split("\n");
  const line = lines.find((line) => /^(last )?restitution/.test(line));
  const short = line ? shortened(line) : kind === "indentation" ? lastStep(text.trim()) : lines[0].split(/ {2,}/).join(" ");
  at("state").textContent = `${kind.replace("_", " ")} ${short}`.trim();
  at("state").classList.remove("refused");
}

/** Marks the results as those of a scenario before the one that was refused. */
export function outdate() {
  at("results").classList.add("old");
  at("state").textContent = areThere ? "Refused; the results are older." : "The scenario is refused.";
  at("state").classList.add("refused");
}
