#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measures what a contact of pair_style plm costs, beside pair_style granular: python src/interfaces/lammps/bench.py [SCENARIO].

Spheres of one size fill a periodic box, so that each touches six others, and move a little. Both styles run one after the other,
several times, and the best time of each counts. It needs the plug-in, which `lmp` of this Python must find: see build.py.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SIDE, STEPS, REPEATS = 20, 400, 3
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


def nanoseconds(lines: str, folder: Path) -> float:
    """Time of the pair style for one contact and one step."""
    # 0.1 % of overlap; some 0.1 m/s
    mass, boltzmann = 7850 * 4 / 3 * 3.14159 * 5e-3**3, 1.380649e-23
    temperature = mass * 0.1**2 / 3 / boltzmann
    text = INPUT.format(spacing=0.00999, side=SIDE, seed=4711, temperature=temperature, lines=lines, steps=STEPS)
    script = folder / "bench.in"
    script.write_text(text)
    command = [Path(sys.executable).parent / "lmp", "-log", "none", "-in", script]
    output = subprocess.run(command, capture_output=True, text=True)
    times = re.findall(r"^Pair +\| +([-+.e\d]+)", output.stdout, re.M)
    if not times:
        sys.exit(output.stdout + output.stderr)
    return float(times[-1]) / (3 * SIDE**3 * STEPS) * 1e9


def main() -> None:
    scenario = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "scenarios" / "steel-on-steel.toml").resolve()
    best = dict.fromkeys(STYLES, float("inf"))
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(REPEATS):
            for name, lines in STYLES.items():
                best[name] = min(best[name], nanoseconds(lines.format(scenario=scenario), Path(folder)))
    for name, time in best.items():
        print(f"{name:24} {time:6.0f} ns per contact and step, {time / best['granular']:.2f} times granular")


if __name__ == "__main__":
    main()
