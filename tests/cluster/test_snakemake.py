"""scenarios/Snakefile, as its first lines say."""

import shutil
import sys
from pathlib import Path

import pytest
from conftest import ROOT, Desk, recipe

pytest.importorskip("snakemake")


def test_the_snakefile_makes_the_table_and_goes_on_where_it_was_stopped(tmp_path: Path) -> None:
    desk = Desk(tmp_path)
    shutil.copytree(ROOT / "scenarios", tmp_path / "scenarios")
    line = recipe("snakemake").strip()
    assert line in (ROOT / "scenarios" / "Snakefile").read_text()
    # each shard starts Snakemake anew, which takes longer than its rows
    line = line.replace("shards=16", "shards=2")
    desk.environment["PATH"] = f"{Path(sys.executable).parent}:{desk.environment['PATH']}"
    desk.run(line)
    assert desk.is_whole()
    # as after an interrupted run: one shard and the summary are missing, and nothing is computed twice
    before = (tmp_path / "big" / "table.csv").stat().st_ino
    (tmp_path / "big" / "shard-1-of-2.done").unlink()
    (tmp_path / "big" / "summary.json").unlink()
    desk.run(line)
    assert (tmp_path / "big" / "summary.json").exists()
    assert (tmp_path / "big" / "table.csv").stat().st_ino == before
    assert desk.is_whole()


def test_two_scenarios_do_not_write_into_the_same_folder(tmp_path: Path) -> None:
    desks = [Desk(tmp_path, points=20), Desk(tmp_path, points=30, name="other")]
    shutil.copytree(ROOT / "scenarios", tmp_path / "scenarios")
    for desk in desks:
        desk.environment["PATH"] = f"{Path(sys.executable).parent}:{desk.environment['PATH']}"
        line = recipe("snakemake").strip().replace("big", desk.name).replace("shards=16", "shards=1")
        desk.run(line)
    assert all(desk.is_whole() for desk in desks)
    desk.run(line.replace("shards=1", "shards=1 out=elsewhere"))
    tables = [tmp_path / folder / "table.csv" for folder in ("other", "elsewhere")]
    assert tables[0].read_bytes() == tables[1].read_bytes()
