/** Makes an element: its name, perhaps properties, and its content. */
export function element(name, ...parts) {
  const made = document.createElement(name);
  for (const part of parts) {
    if (part instanceof Node || typeof part === "string") made.append(part);
    else Object.assign(made, part);
  }
  return made;
}

const SVG = "http://www.w3.org/2000/svg";

/** Makes an element of a drawing: its name, its attributes, and its text. */
export function svgElement(name, attributes = {}, text = "") {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

/** Gives the user a text as a file. */
export function download(name, text) {
  const link = element("a", { href: URL.createObjectURL(new Blob([text])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
