// Shows the reply to a run: warnings, numbers, pictures, files.

import { download, element } from "./element.js";

const at = (id) => document.getElementById(id);

/** Shows the results of a scenario. */
export function showResults({ kind, warnings, text, contradiction, files, curve }) {
  const cautions = [...warnings, ...(contradiction ? [contradiction] : [])];
  at("warnings").replaceChildren(...cautions.map((text) => element("li", text)));
  at("warnings").hidden = cautions.length === 0;
  at("numbers").replaceChildren(table(text));
  const all = curve ? { ...files, "restitution.svg": curve } : files;
  const pictures = Object.keys(all).filter((name) => name.endsWith(".svg"));
  at("pictures").replaceChildren(...pictures.map((name) => picture(name, all[name])));
  const buttons = Object.entries(all).map(([name, content]) => {
    const button = element("button", { type: "button" }, name);
    button.addEventListener("click", () => download(name, content));
    return button;
  });
  at("files").replaceChildren("Download: ", ...buttons.flatMap((button) => [button, " "]));
  at("files").hidden = false;
  at("results").classList.remove("old");
  // this is what a screen reader says of a change
  const e = text.split("\n").find((line) => line.startsWith("restitution "));
  at("state").textContent = [kind.replace("_", " "), ...(e ?? "").split(/ {2,}/)].join(" ").trim();
}

/** Marks the results as those of a scenario before the one that was refused. */
export function outdate() {
  at("results").classList.add("old");
  at("state").textContent = "The scenario is refused; below are the results of the one before.";
}

// Lines of a name and a value become a list, any other text stays as the command prints it.
function table(text) {
  const lines = text.trimEnd().split("\n").map((line) => line.match(/^(\S.*?) {2,}(\S.*)$/));
  if (!lines.every(Boolean)) return element("pre", { tabIndex: 0 }, text);
  const list = element("dl");
  for (const [, name, values] of lines) {
    const parts = values.split(/ {2,}/).flatMap((value) => [element("span", value), " "]);
    list.append(element("dt", name), element("dd", ...parts));
  }
  return list;
}

function picture(name, svg) {
  const drawn = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  const title = name.replace(".svg", "").replaceAll("_", " ");
  drawn.setAttribute("role", "img");
  drawn.setAttribute("aria-label", `picture: ${title}`);
  // a wide picture can be moved on a narrow screen, also by keys
  const frame = element("div", { className: "frame", tabIndex: 0, role: "group", ariaLabel: title });
  frame.append(document.importNode(drawn, true));
  return element("figure", { id: `picture-${title.replaceAll(" ", "-")}` }, frame);
}
