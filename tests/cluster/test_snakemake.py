"""scenarios/Snakefile, as its first lines say."""

import shutil
import sys
from pathlib import Path

import pytest
from conftest import ROOT, Desk, recipe

pytest.importorskip("snakemake")


def test_the_snakefile_makes_the_table_and_goes_on_where_it_was_stopped(tmp_path: Path) -> None:
    desk = Desk(tmp_path, points=200)
    shutil.copytree(ROOT / "scenarios", tmp_path / "scenarios")
    line = recipe("snakemake").strip()
    assert line in (ROOT / "scenarios" / "Snakefile").read_text()
    desk.environment["PATH"] = f"{Path(sys.executable).parent}:{desk.environment['PATH']}"
    desk.run(line)
    assert desk.is_whole()
    # as after an interrupted run: one shard and the table are missing, and only these are made
    before = {path.name: path.stat().st_mtime_ns for path in (tmp_path / "shards").glob("*.csv")}
    assert len(before) == 16
    (tmp_path / "shards" / "table-5-of-16.csv").unlink()
    (tmp_path / "table.csv").unlink()
    desk.run(line)
    after = {path.name: path.stat().st_mtime_ns for path in (tmp_path / "shards").glob("*.csv")}
    assert {name for name in before if before[name] != after[name]} == {"table-5-of-16.csv"}
    assert desk.is_whole()
