// Shows the reply to a run: warnings, numbers, pictures, files.

import { download, element } from "./element.js";
import { csvTable, elements, headline } from "./numbers.js";
import { picture } from "./picture.js";

const byId = (id) => document.getElementById(id);
// So many rows of a long table are shown.
const SHOWN = 10;
let hasResults = false;

/** Shows the results of a scenario; while a value moves, the pictures and files are those before. */
export function showResults({ kind, warnings, blocks, contradiction, files, curve }, isMoving) {
  const cautions = [...warnings, ...(contradiction ? [contradiction] : [])];
  byId("warnings").replaceChildren(...cautions.map((text) => element("li", text)));
  byId("warnings").hidden = cautions.length === 0;
  const table = files["table.csv"];
  byId("numbers").replaceChildren(...elements(blocks), ...(table ? [csvTable("table.csv", table, SHOWN)] : []));
  if (!isMoving) showFiles({ ...files, ...curve });
  for (const id of ["pictures", "files"]) byId(id).classList.toggle("before", isMoving);
  byId("results").classList.remove("old");
  hasResults = true;
  // this is what a screen reader says of a change, and what stays in view
  byId("state").textContent = `${kind.replace("_", " ")} ${headline(blocks, kind)}`;
  byId("state").classList.remove("refused");
}

function showFiles(all) {
  const pictures = Object.entries(all).filter(([name]) => name.endsWith(".svg"));
  byId("pictures").replaceChildren(...pictures.map(([name, svg]) => picture(name, svg)));
  const buttons = Object.entries(all).map(([name, content]) => {
    const button = element("button", { type: "button" }, name);
    button.addEventListener("click", () => download(name, content));
    return button;
  });
  byId("files").replaceChildren("Download: ", ...buttons.flatMap((button) => [button, " "]));
  byId("files").hidden = false;
}

/** Marks the results as those of a scenario before the one that was refused. */
export function markStale() {
  byId("results").classList.add("old");
  byId("state").textContent = hasResults ? "Invalid scenario; showing previous results." : "Invalid scenario.";
  byId("state").classList.add("refused");
}
