"""A table in parts, read as scenarios/tables.md shows it."""

import csv
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SECTION = (ROOT / "scenarios" / "tables.md").read_text().split("### As a data set")[1].split("\n### ")[0]


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", SECTION, flags=re.DOTALL)


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory, command: Path) -> Path:
    """A folder with the scenarios, and with what the command of the page writes; beside it the same table as CSV."""
    folder = tmp_path_factory.mktemp("clone")
    shutil.copytree(ROOT / "scenarios", folder / "scenarios")
    path = f"{command.parent}{os.pathsep}{os.environ['PATH']}"
    (shown,) = blocks("sh")
    whole = shown.splitlines()[1]
    for line in [shown, whole.replace("--format parquet --out plots/all-laws", "--out csv")]:
        subprocess.run(line, shell=True, cwd=folder, env={**os.environ, "PATH": path}, check=True, capture_output=True)
    return folder


@pytest.mark.parametrize("code", blocks("python"), ids=["duckdb", "polars", "datafusion"])
def test_lines_of_page_match_csv_table(code: str, clone: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(clone)
    names: dict[str, object] = {}
    exec(code, names)
    found = {row["law"]: row["restitution"] for row in names["lowest"].to_dicts()}
    lowest: dict[str, float] = {}
    with open("csv/table.csv", newline="") as table:
        for row in csv.DictReader(table):
            if row["restitution"]:
                lowest[row["law"]] = min(float(row["restitution"]), lowest.get(row["law"], 1.0))
    assert len(lowest) == 12
    assert found == lowest
