"""Measures the module beside the library that it calls, and writes plots/bench/python.md.

python src/python/bench/bench.py [WHEEL]
"""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import plm_impact as plm
from plm_impact._core import _measure

ROWS = 1_000_000
ROUNDS = 40
PAGE = Path(__file__).parents[3] / "plots" / "bench" / "python.md"


def seconds(work: Callable[[], object]) -> float:
    begun = time.perf_counter()
    work()
    return time.perf_counter() - begun


def of_import() -> float:
    """Seconds of the import alone, in a process of its own."""
    code = "import time; t = time.perf_counter(); import plm_impact; print(time.perf_counter() - t)"
    return float(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout)


def main() -> None:
    steel = {"youngs_modulus": 210e9, "poissons_ratio": 0.3}
    contact = plm.Contact(sphere={"radius": 5e-3, "density": 7850, **steel}, half_space={"yield_strength": 345e6, **steel})
    speeds = np.logspace(-3, 2, ROWS)
    best: dict[str, float] = {}

    def note(name: str, value: float) -> None:
        best[name] = min(value, best.get(name, value))

    for _ in range(ROUNDS):
        table, impact = _measure(contact, ROWS)
        note("rust table", table)
        note("restitution", seconds(lambda: contact.restitution(speeds)))
        note("table", seconds(lambda: plm.impacts(contact, speed=speeds)))
        for _ in range(50):
            note("rust impact", _measure(contact, 1)[1])
            note("impact", seconds(lambda: [contact.impact(3.0) for _ in range(20)]) / 20)
        note("import", of_import())
    ratio = f"{best['restitution'] / best['rust table']:.2f}"
    of_table = f"{best['table'] / best['rust table']:.2f}"
    more = (best["impact"] - best["rust impact"]) * 1e6
    lines = [
        "| what | measured | wanted |",
        "|---|---|---|",
        f"| 10^6 restitutions, `contact.restitution(v)` | {best['restitution']:.3f} s | below 0.1 s on two cores |",
        f"| over the same table in Rust ({best['rust table']:.3f} s, all results) | {ratio} | at most 1.3 |",
        f"| a table of 10^6 rows with all results, `plm.impacts`, over that in Rust, which keeps no columns | {of_table} | |",
        f"| one impact, `contact.impact(3.0)` | {best['impact'] * 1e6:.1f} us | |",
        f"| the same less what Rust takes ({best['rust impact'] * 1e6:.1f} us) | {more:.1f} us | at most 5 us |",
        f"| `import plm_impact` (NumPy is loaded with the first array) | {best['import'] * 1e3:.1f} ms | below 50 ms |",
    ]
    if len(sys.argv) > 1:
        lines.append(f"| size of the wheel | {Path(sys.argv[1]).stat().st_size / 1e6:.1f} MB | below 6 MB |")
    head = f"""# The Python module

`python src/python/bench/bench.py WHEEL` wrote this page: a steel ball on steel at a million speeds from 1 mm/s to 100
m/s, on {os.cpu_count()} cores. Python and Rust take turns, and the best of {ROUNDS} rounds counts.

"""
    PAGE.write_text(head + "\n".join(lines) + "\n")
    print(PAGE.read_text())


if __name__ == "__main__":
    main()
