// All tests that need a browser: it starts once for them. Each file can also be run alone.

import "./page.test.mjs";
import "./form.test.mjs";
import "./bench.test.mjs";
