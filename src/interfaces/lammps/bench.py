#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measures what a contact of pair_style plm costs, beside pair_style granular: python src/interfaces/lammps/bench.py [SCENARIO].

Two cases: spheres of one size that each touch six others and move a little, and a gas in which few touch. The styles run one after the
other, several times, and the best time of each counts, as time of a core. It needs the plug-in, which `lmp` of this Python must find: see build.py.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SIDE, STEPS, REPEATS = 16, 400, 5
# spacing of the spheres of 10 mm (m), their speed (m/s), the part of LAMMPS that counts
CASES = {"six contacts of every sphere": (0.00999, 0.1, "Pair"), "a gas, whole run": (0.0125, 1.0, "Loop")}
MATERIAL = "hertz/material 210e9 0 0.3 tangential mindlin_rescale/force NULL 0 0.3 damping velocity"
INPUT = """units si
atom_style sphere
boundary p p p
comm_modify vel yes
lattice sc {spacing}
region box block 0 {side} 0 {side} 0 {side}
create_box 1 box
create_atoms 1 box
set group all diameter 0.01 density 7850
velocity all create 1 {seed} dist gaussian
velocity all scale {temperature}
{lines}
neighbor 0.0005 bin
fix nve all nve/sphere
timestep 2e-7
run 100
run {steps}
"""
STYLES = {
    "granular": f"pair_style granular\npair_coeff * * {MATERIAL}",
    "plm": "pair_style plm friction 0.3\npair_coeff * * {scenario}",
    "plm with fix plm/energy": "pair_style plm friction 0.3\npair_coeff * * {scenario}\nfix energy all plm/energy",
}


def nanoseconds(lines: str, case: str, folder: Path) -> float:
    """Time of a core for one sphere and one step."""
    spacing, speed, part = CASES[case]
    mass, boltzmann = 7850 * 4 / 3 * 3.14159 * 5e-3**3, 1.380649e-23
    temperature = mass * speed**2 / boltzmann
    script = folder / "bench.in"
    text = INPUT.format(spacing=spacing, side=SIDE, seed=4711, temperature=temperature, lines=lines, steps=STEPS)
    script.write_text(text)
    command = [Path(sys.executable).parent / "lmp", "-log", "none", "-in", script]
    output = subprocess.run(command, capture_output=True, text=True).stdout
    pattern = r"^Pair +\| +([-+.e\d]+)" if part == "Pair" else r"^Loop time of ([-+.e\d]+)"
    times, shares = re.findall(pattern, output, re.M), re.findall(r"^([\d.]+)% CPU use", output, re.M)
    if not times:
        sys.exit(output)
    return float(times[-1]) * min(float(shares[-1]) / 100, 1.0) / (SIDE**3 * STEPS) * 1e9


def main() -> None:
    scenario = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "scenarios" / "steel-on-steel.toml").resolve()
    for case in CASES:
        best = dict.fromkeys(STYLES, float("inf"))
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(REPEATS):
                for name, lines in STYLES.items():
                    best[name] = min(best[name], nanoseconds(lines.format(scenario=scenario), case, Path(folder)))
        for name, time in best.items():
            print(f"{case}: {name:24} {time:6.0f} ns per sphere and step, {time / best['granular']:.2f} times granular")


if __name__ == "__main__":
    main()
