"""The examples run, and a strict type checker accepts them."""

from __future__ import annotations

import inspect
import json
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import plm_impact as plm
import pytest
from conftest import ROOT

EXAMPLES = ROOT / "src" / "interfaces" / "python" / "examples"


def run(*arguments: object, **options: object) -> str:
    done = subprocess.run([sys.executable, *map(str, arguments)], capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_example_draws_e_against_v(tmp_path: Path) -> None:
    picture = tmp_path / "e.png"
    assert "restitution" in run(EXAMPLES / "restitution.py", picture)
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("page", "heading"),
    [
        ("README.md", "## Python\n"),
        ("src/registry.md", "## The Python module\n"),
        ("scenarios/tables.md", "## From Python\n"),
    ],
)
def test_python_of_pages_runs_without_warnings(page: str, heading: str) -> None:
    _, block = (ROOT / page).read_text().split(heading)[1].split("\n## ")[0].split("```python\n")
    # `pip install .` brings NumPy and no other package
    others = ["pandas", "polars", "pyarrow", "xarray", "duckdb", "matplotlib"]
    alone = f"import sys; sys.modules.update(dict.fromkeys({others}))\n"
    run("-W", "error", "-c", alone + block.split("```")[0], cwd=ROOT)


def test_ten_lines_of_the_page_read_a_run(command: Path, tmp_path: Path) -> None:
    subprocess.run([command, "run", ROOT / "scenarios" / "steel-on-steel.toml"], cwd=tmp_path, check=True)
    section = (ROOT / "scenarios" / "tables.md").read_text().split("### Read `summary.json`")[1]
    printed = run("-c", section.split("```python\n")[1].split("```")[0], cwd=tmp_path)
    summary = json.loads((tmp_path / "plots" / "steel-on-steel" / "summary.json").read_text())
    assert printed.startswith(f"e = {summary['restitution']} interval: {summary['restitution_interval']}\n")
    assert f"\n{summary['peak_force_N']} N is the maximum of " in printed


def test_wheel_has_licences_of_linked_crates() -> None:
    licences = metadata.distribution("plm-impact").read_text("licenses/src/interfaces/licenses.txt")
    assert licences == (ROOT / "src" / "interfaces" / "licenses.txt").read_text()
    expression = metadata.metadata("plm-impact")["License-Expression"]
    assert "Bitstream-Vera" in expression and f": {expression}\n" in licences


def test_the_wheel_shows_the_page_for_registries() -> None:
    assert metadata.metadata("plm-impact")["Description"].strip() == (ROOT / "src" / "registry.md").read_text().strip()


def test_dask_table_matches_undivided_table() -> None:
    assert run(EXAMPLES / "dask_table.py").strip() == "40000 rows, the same as undivided: True"


@pytest.fixture(scope="module")
def mypy(tmp_path_factory: pytest.TempPathFactory) -> list[str | Path]:
    """Arguments of Python. The tests share a cache, as the types of NumPy and pandas take most of the time."""
    cache = tmp_path_factory.mktemp("mypy")
    # some functions of Dask have no type annotations
    return ["-m", "mypy", "--strict", "--allow-untyped-calls", "--ignore-missing-imports", "--cache-dir", cache]


def test_mypy_accepts_the_examples(mypy: list[str | Path], tmp_path: Path) -> None:
    run(*mypy, *EXAMPLES.glob("*.py"), cwd=tmp_path)


def test_the_types_are_those_of_the_module(tmp_path: Path) -> None:
    assert "Success" in run("-m", "mypy.stubtest", "plm_impact", cwd=tmp_path)
    assert str(inspect.signature(plm.Contact)) == "(*, sphere, half_space, **tables)"


def test_mypy_rejects_misspelt_and_assigned_results(mypy: list[str | Path], tmp_path: Path) -> None:
    program = tmp_path / "wrong.py"
    lines = ["import plm_impact as plm", "def show(impact: plm.Impact, table: plm.Table) -> None:"]
    lines += ["    print(impact.peak_force_N, impact.energy, impact.restitution)", "    print(impact.peak_forse_N)"]
    lines += ["    impact.restitution = 1.0", "    impact.peak_force_N = 1.0", "    table.shape = (1,)"]
    program.write_text("\n".join(lines) + "\n")
    done = subprocess.run([sys.executable, *mypy, program], capture_output=True, text=True, cwd=tmp_path)
    places = sorted({int(number) for number in re.findall(r"^wrong.py:(\d+): error", done.stdout, re.M)})
    assert places == [4, 5, 6, 7], done.stdout
