// Runs scenarios beside the page. The first message is the program, every other one a run.

import { initSync, run } from "./plm_impact.js";

self.onmessage = ({ data }) => {
  if (data instanceof WebAssembly.Module) initSync({ module: data });
  else postMessage(run(...data));
};
