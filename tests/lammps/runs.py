"""Builds the plug-in and runs LAMMPS for the tests of this folder; without LAMMPS they are skipped."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest

np = pytest.importorskip("numpy")
plm = pytest.importorskip("plm_impact")
for package in ("lammps", "mpich"):
    try:
        metadata.version(package)
    except metadata.PackageNotFoundError:
        pytest.skip(f"{package} is not installed", allow_module_level=True)

ROOT = Path(__file__).resolve().parents[2]
INPUTS = Path(__file__).resolve().parent
STEEL = ROOT / "scenarios" / "steel-on-steel.toml"
BIN = Path(sys.executable).parent


def build(*arguments: str | Path) -> None:
    command = [sys.executable, ROOT / "src/interfaces/lammps/build.py", *arguments]
    if library := os.environ.get("PLM_IMPACT_TEST_LIBRARY"):
        command += ["--library", library]
    subprocess.run(command, check=True)


def is_installed() -> bool:
    """Whether the module is in the environment, and not in the sources."""
    return not Path(plm.__file__).resolve().is_relative_to(ROOT / "src")


def lammps(plugin: Path, script: str, ranks: int = 1, fails: bool | None = False, **variables: object) -> str:
    words = [word for name, value in variables.items() for word in ("-var", name, str(value))]
    start = [BIN / "mpiexec", "-n", str(ranks)] if ranks > 1 else []
    command = [*start, BIN / "lmp", "-log", "none", "-in", INPUTS / script, *words]
    environment = dict(os.environ)
    environment.pop("LAMMPS_PLUGIN_PATH", None)
    if plugin != Path():
        environment["LAMMPS_PLUGIN_PATH"] = str(plugin)
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=500)
    output = done.stdout + done.stderr
    assert fails is None or (done.returncode != 0) == fails, output[-3000:]
    return output


def assert_same_on_four_ranks(plugin: Path, script: str, out: Path, **run: object) -> None:
    """Compares the dumps. The run has to be short, because four ranks wait for each other on two cores."""
    ends = []
    for ranks in (1, 4):
        lammps(plugin, script, ranks=ranks, out=out, **run)
        ends.append(Path(f"{out}.again").read_text())
    assert ends[0] == ends[1]


def command() -> str:
    """The command of this repository, which a build has made."""
    path = os.environ.get(
        "PLM_IMPACT_TEST_COMMAND", str(ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "debug/plm-impact")
    )
    if not Path(path).exists():
        pytest.skip(f"{path} is not built: set PLM_IMPACT_TEST_COMMAND")
    return path


def table(dump: Path) -> np.ndarray:
    return np.loadtxt(dump, skiprows=9)


def changed(folder: Path, script: str, *changes: tuple[str, str]) -> str:
    """An input script of this folder with other words, each of which it has; where it is written."""
    text = (INPUTS / script).read_text()
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    made = folder / f"changed-{script}"
    made.write_text(text)
    return str(made)
