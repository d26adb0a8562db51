/** Makes an element: its name, perhaps properties, and its content. */
export function element(name, ...parts) {
  const made = document.createElement(name);
  for (const part of parts) {
    if (part instanceof Node || typeof part === "string") made.append(part);
    else Object.assign(made, part);
  }
  return made;
}

/** Gives the user a text as a file. */
export function download(name, text) {
  const link = element("a", { href: URL.createObjectURL(new Blob([text])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
