"""pair_style plm on several ranks, across restart files, and where contacts cross the faces of the box."""

from __future__ import annotations

from pathlib import Path

import pytest
from runs import STEEL, assert_same_on_four_ranks, changed, lammps, np, table
from spheres import ledger, write_gas, write_spheres


def test_ranks_and_restart_keep_every_bit(plugin: Path, tmp_path: Path) -> None:
    """A dense gas, in which some spheres touch at any time."""
    write_gas(tmp_path / "gas.data", 3, radii=(4e-3, 4.5e-3, 5e-3), cell=0.0103)
    run = dict(scenario=STEEL, dt="2e-7", every=500, half=2000, newton="on", style="plm friction 0.3 rolling 1e5 0.05")
    accounts = ledger(lammps(plugin, "gas.in", data=tmp_path / "gas.data", out=tmp_path / "one", **run))
    one = (tmp_path / "one.dump").read_text()
    lammps(plugin, "gas.in", ranks=2, data=tmp_path / "gas.data", out=tmp_path / "two", **run)
    assert (tmp_path / "two.dump").read_text() == one
    assert accounts["stored"][4] > 0.0, "some spheres touch at the restart"
    for ranks in (1, 2):
        again = ledger(lammps(plugin, "gas_again.in", ranks=ranks, out=tmp_path / "one", **run))
        assert (tmp_path / "one.again").read_text() == one, f"restart on {ranks} ranks"
        for name, account in again.items():
            # the output has the row between the two halves twice
            assert account == pytest.approx(accounts[name][5:], rel=1e-10, abs=1e-18), name
    # from where spheres touch
    assert_same_on_four_ranks(plugin, "gas_again.in", tmp_path / "one", **run | {"every": 50, "half": 100})


def test_restart_with_other_laws_is_refused(plugin: Path, tmp_path: Path) -> None:
    write_gas(tmp_path / "gas.data", 2)
    run = dict(dt="2e-7", every=100, half=100, newton="on", out=tmp_path / "one")
    lammps(plugin, "gas.in", data=tmp_path / "gas.data", scenario=STEEL, style="plm", **run)
    other = tmp_path / "other.toml"
    other.write_text(STEEL.read_text().replace('"345 MPa"', '"200 MPa"'))
    for scenario, style in ((other, "plm"), (STEEL, "plm friction 0.3")):
        output = lammps(plugin, "gas_again.in", fails=True, scenario=scenario, style=style, **run)
        assert "with other scenarios of pair_style plm, or with or without friction or rolling" in output


@pytest.mark.parametrize("newton", ["on", "off"])
def test_write_restart_keeps_contacts_across_faces(plugin: Path, tmp_path: Path, newton: str) -> None:
    """Spheres cross the faces of the box while they touch. write_restart makes new ghost atoms; with the neighbour list of the run
    LAMMPS would then lose the histories of these contacts (pair_style granular does)."""
    random, cell, side = np.random.default_rng(3), 0.0101, 4
    places = (np.indices((side,) * 3).reshape(3, -1).T + random.uniform(-1e-5, 1e-5, (side**3, 3))) * cell
    columns = ([1] * side**3, [5.05e-3] * side**3, [7850.0] * side**3)
    speeds = random.normal(0.0, 0.5, (side**3, 3)).tolist()
    size = side * cell
    write_spheres(tmp_path / "faces.data", (size,) * 3, *columns, (places % size).tolist(), speeds)
    run = dict(data=tmp_path / "faces.data", scenario=STEEL, style="plm friction 0.3", dt="1e-7", newton=newton)
    ends = []
    for name, middle in (("whole", ""), ("restart", "write_restart ${out}.restart"), ("plain", "run 0")):
        script = changed(tmp_path, "gas.in", ("write_restart ${out}.restart", middle))
        output = lammps(plugin, script, out=tmp_path / name, every=150, half=150, **run)
        assert ledger(output)["stored"][1] > 0.0, "some spheres touch at the restart"
        ends.append((tmp_path / f"{name}.dump").read_text())
    assert ends[0] == ends[1] == ends[2]
    lammps(plugin, "gas_again.in", out=tmp_path / "restart", every=150, half=150, **run)
    assert np.abs(table(tmp_path / "restart.again") - table(tmp_path / "whole.dump")).max() < 1e-9
