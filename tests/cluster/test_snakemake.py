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
    # as after an interrupted run: one shard and the summary are missing, and nothing is computed twice
    before = (tmp_path / "big" / "table.csv").stat().st_ino
    (tmp_path / "big" / "shard-5-of-16.done").unlink()
    (tmp_path / "big" / "summary.json").unlink()
    desk.run(line)
    assert (tmp_path / "big" / "summary.json").exists()
    assert (tmp_path / "big" / "table.csv").stat().st_ino == before
    assert desk.is_whole()
