// Chromium without a window, driven over the WebDriver protocol of chromedriver, and a server for the page.

import { spawn, spawnSync } from "node:child_process";
import { createReadStream, mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

/** Serves a folder; gives the address, and functions that stop it, start it again and end it. */
export async function serve(folder) {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const file = join(folder, path.endsWith("/") ? "index.html" : path);
    response.setHeader("content-type", TYPES[extname(file)] ?? "application/octet-stream");
    createReadStream(file)
      .on("error", () => response.writeHead(404).end())
      .pipe(response);
  });
  const listen = (port) => new Promise((ready) => server.listen(port, "127.0.0.1", ready));
  await listen(0);
  const { port } = server.address();
  const stop = () => {
    server.closeAllConnections();
    return new Promise((ended) => server.close(ended));
  };
  return { address: `http://127.0.0.1:${port}/`, stop, start: () => listen(port), end: () => server.close() };
}

// the first one has no window, and the tests need a third less processor time with it
const BROWSERS = ["chromium-headless-shell", "chromium"];

const OPTIONS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-dev-shm-usage",
  "--force-device-scale-factor=1",
  // a name that is not this machine for the browser, so that a page from there has what any page without https has
  "--host-resolver-rules=MAP plain.test 127.0.0.1",
];

/** Starts a program that prints its address. Gives the address, and a function that ends the program and its child processes. */
async function start(program, options, address) {
  const child = spawn(program, options, { stdio: ["ignore", "pipe", "pipe"], detached: true });
  const stop = () => process.kill(-child.pid);
  process.on("exit", stop);
  const end = () => {
    process.off("exit", stop);
    const ended = new Promise((ended) => child.on("close", ended));
    stop();
    return ended;
  };
  const found = await new Promise((found, failed) => {
    for (const stream of [child.stdout, child.stderr])
      stream.on("data", (text) => {
        const match = String(text).match(address);
        if (match) found(match[1]);
      });
    child.on("error", failed);
    child.on("exit", () => failed(new Error(`${program} ended`)));
  });
  return { found, end };
}

/** Starts a browser; gives functions that use it. */
export async function browse() {
  const browser = BROWSERS.find((name) => spawnSync(name, ["--version"]).status === 0);
  if (!browser) throw new Error(`no browser is installed: install ${BROWSERS.join(" or ")}`);
  const profile = mkdtempSync(join(tmpdir(), "plm-impact-browser-"));
  const options = [...OPTIONS, `--user-data-dir=${profile}`, "--remote-debugging-port=0", "about:blank"];
  const chromium = await start(browser, options, /DevTools listening on ws:\/\/([^/]*)/);
  const driver = await start("chromedriver", ["--port=0"], /successfully on port (\d+)/);
  const ask = async (method, path, body) => {
    const answer = await fetch(`http://127.0.0.1:${driver.found}${path}`, {
      method,
      body: body && JSON.stringify(body),
    });
    const { value } = await answer.json();
    if (value?.error) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  const debuggerAddress = chromium.found;
  const wanted = {
    "goog:chromeOptions": { debuggerAddress },
    "goog:loggingPrefs": { performance: "ALL", browser: "ALL" },
  };
  const { sessionId } = await ask("POST", "/session", { capabilities: { alwaysMatch: wanted } });
  const post = (path, body) => ask("POST", `/session/${sessionId}${path}`, body ?? {});
  const tell = (cmd, params) => post("/goog/cdp/execute", { cmd, params });
  const ID = "element-6066-11e4-a52e-4f735466cecf";
  const find = async (css) => (await post("/element", { using: "css selector", value: css }))[ID];
  const page = {
    tell,
    go: (url) => post("/url", { url }),
    back: () => post("/back"),
    /** The value of an expression in the page. */
    value: (expression) => post("/execute/sync", { script: `return ${expression}`, args: [] }),
    /** Waits until an expression is true; after ten minutes that is an error. */
    async until(expression) {
      for (const end = performance.now() + 600_000; performance.now() < end;) {
        if (await page.value(expression)) return;
        await new Promise((later) => setTimeout(later, 50));
      }
      const shown = await page.value("document.body.innerText");
      throw new Error(`never true: ${expression}; the page shows\n${shown}`);
    },
    click: async (css) => post(`/element/${await find(css)}/click`),
    /** Types into a field, in place of what was there: Ctrl+A, then the text. Waits until all of it is answered. */
    async type(css, text) {
      await page.send(css, `\uE009a\uE000${text}`);
      await page.until('document.getElementById("results").ariaBusy !== "true"');
    },
    /** Chooses a file, or presses keys. */
    send: async (css, text) => post(`/element/${await find(css)}/value`, { text }),
    /** The names by which a screen reader calls the elements that are seen. */
    async labels(css) {
      const seen = `[...document.querySelectorAll(${JSON.stringify(css)})].filter((one) => one.checkVisibility())`;
      const label = (one) => ask("GET", `/session/${sessionId}/element/${one[ID]}/computedlabel`);
      return Promise.all((await page.value(seen)).map(label));
    },
    /** What was noted of this kind since the last time. */
    log: (type) => post("/se/log", { type }),
    picture: async () => Buffer.from(await ask("GET", `/session/${sessionId}/screenshot`), "base64"),
    /** Width and height of the window, and whether the user likes it dark. */
    async look(width, height, isDark) {
      await tell("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
      const value = isDark ? "dark" : "light";
      await tell("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
    },
    async end() {
      await ask("DELETE", `/session/${sessionId}`);
      await driver.end();
      await chromium.end();
      rmSync(profile, { recursive: true, force: true, maxRetries: 10 });
    },
  };
  return page;
}
