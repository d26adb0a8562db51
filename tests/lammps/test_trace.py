"""`plm-impact check-trace` with contacts that LAMMPS computes now: models of granular walls, and `fix plm/wall`."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from runs import ROOT, STEEL, command, lammps, np

NO_FRICTION = "tangential linear_nohistory 0.0 0.0 zplane 0.0 NULL"
MODELS = {
    "hooke": (f"wall/gran granular hooke 1e7 0.5 damping coeff_restitution {NO_FRICTION}", "1e-6", 80, "0.00501"),
    "hertz": (
        f"wall/gran granular hertz/material 210e9 0.5 0.3 damping coeff_restitution {NO_FRICTION}",
        "5e-7",
        100,
        "0.00501",
    ),
    "coarse": (f"wall/gran granular hooke 1e7 1.0 damping coeff_restitution {NO_FRICTION}", "6e-6", 40, "0.005035"),
}


def trace(plugin: Path, folder: Path, model: str, dt: str, steps: int, height: str) -> Path:
    file = folder / "trace.txt"
    variables = {"dt": dt, "n": str(steps), "height": height, "model": model, "file": str(file)}
    lammps(plugin, "trace.in", **variables)
    return file


@pytest.mark.parametrize("name", MODELS)
def test_traces_are_those_of_the_repository(plugin: Path, tmp_path: Path, name: str) -> None:
    made = np.loadtxt(trace(plugin, tmp_path, *MODELS[name]))
    kept = np.loadtxt(ROOT / f"tests/reference/lammps_{name}.txt")
    assert (np.abs(made - kept).max(axis=0) <= 1e-6 * np.abs(kept).max(axis=0)).all()


def test_fix_of_the_law_agrees_with_its_scenario(plugin: Path, tmp_path: Path) -> None:
    file = trace(plugin, tmp_path, f"plm/wall plane 0 scenario {STEEL}", "1e-7", 500, "0.00501")
    words = [command(), "check-trace", file, STEEL, "--json", "--pictures", "none"]
    checked = json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    for name in ("restitution", "contact_time_s", "peak_force_N", "peak_indentation_m"):
        assert checked["trace"][name] == pytest.approx(checked["law"][name], rel=5e-3)
