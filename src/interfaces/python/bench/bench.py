"""Measures the calls of the module, and writes plots/bench/python.md.

python src/interfaces/python/bench/bench.py [WHEEL]
"""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import plm_impact as plm

ROWS = 1_000_000
ROUNDS = 40
PAGE = Path(__file__).parents[4] / "plots" / "bench" / "python.md"


def seconds(work: Callable[[], object], times: int = 1) -> float:
    """Seconds of one call."""
    begun = time.perf_counter()
    for _ in range(times):
        work()
    return (time.perf_counter() - begun) / times


def of_import() -> float:
    """Seconds of the import alone, in a process of its own."""
    code = "import time; t = time.perf_counter(); import plm_impact; print(time.perf_counter() - t)"
    return float(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout)


def main() -> None:
    steel = {"youngs_modulus": 210e9, "poissons_ratio": 0.3}
    contact = plm.Contact(
        sphere={"radius": 5e-3, "density": 7850, **steel}, half_space={"yield_strength": 345e6, **steel}
    )
    speeds, thousand = np.logspace(-3, 2, ROWS), np.logspace(-3, 1, 1000)
    _deep, memory = contact.force(1e-6 * thousand)
    calls: dict[str, Callable[[], object]] = {
        "`contact.restitution(3.0)`": lambda: contact.restitution(3.0),
        "`contact.restitution(v)`, 1000 speeds": lambda: contact.restitution(thousand),
        "`contact.force(d, memory)`, 1 contact": lambda: contact.force(1e-6, memory[0]),
        "`contact.force(d, memory)`, 1000 contacts": lambda: contact.force(0.9e-6 * thousand, memory),
        "`plm.impacts(contact, speed=3.0)`, all results": lambda: plm.impacts(contact, speed=3.0),
        "`plm.impacts(contact, speed=v)`, 1000 speeds": lambda: plm.impacts(contact, speed=thousand),
        "`contact.impact(3.0)`, integrated": lambda: contact.impact(3.0),
        "10^6 restitutions, `contact.restitution(v)`": lambda: contact.restitution(speeds),
        "10^6 rows with all results, `plm.impacts(contact, speed=v)`": lambda: plm.impacts(contact, speed=speeds),
    }
    best: dict[str, float] = {}
    for _ in range(ROUNDS):
        for name, call in calls.items():
            took = seconds(call, times=1 if "10^6" in name else 50)
            best[name] = min(took, best.get(name, took))
    best["`import plm_impact` (NumPy is loaded with the first array)"] = min(of_import() for _ in range(ROUNDS))
    lines = ["| what | time |", "|---|---|"]
    lines += [
        f"| {name} | {took * 1e6:.1f} us |" if took < 1e-3 else f"| {name} | {took * 1e3:.1f} ms |"
        for name, took in best.items()
    ]
    if len(sys.argv) > 1:
        lines.append(f"| size of the wheel | {Path(sys.argv[1]).stat().st_size / 1e6:.1f} MB |")
    head = f"""# The Python module

`python src/interfaces/python/bench/bench.py WHEEL` wrote this page: a steel ball on steel (law PLM) on {os.cpu_count()} cores. The calls
take turns, and the best of {ROUNDS} rounds counts. Up to 1000 values are computed in the calling thread, more of them on all
cores.

"""
    PAGE.write_text(head + "\n".join(lines) + "\n")
    print(PAGE.read_text())


if __name__ == "__main__":
    main()
