"""pair_style plm with spheres whose mass is not that of their radius (frozen, rigid), and with radii that appear in a run."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from runs import STEEL, changed, lammps, np, table
from spheres import DENSITY, GAP, two_balls, write_pairs, write_spheres


def restitution(speed: float, heavier: float) -> float:
    """The closed form of a ball of 5 mm that meets a ball of the same radius and a mass so many times larger."""
    return two_balls((5e-3, 5e-3), (DENSITY, heavier * DENSITY)).restitution(speed)


def test_frozen_sphere_is_a_fixed_target(plugin: Path, tmp_path: Path) -> None:
    write_pairs(tmp_path / "pairs.data", [(5e-3, 5e-3)], [1.0], [(DENSITY, DENSITY)])
    still = (
        "fix nve all nve/sphere",
        "group still id 2\ngroup free id 1\nfix nve free nve/sphere\nfix still still freeze",
    )
    run = dict(data=tmp_path / "pairs.data", style="plm", coeff=f"* * {STEEL}", newton="on", dt="1e-8", n=15_000)
    lammps(plugin, changed(tmp_path, "pair_meet.in", still), out=tmp_path / "out", **run)
    upper, lower = table(tmp_path / "out")[:, 1:]
    assert np.all(lower == 0.0)
    # a target of 10^6 times the mass moves with 10^-6 of the speed
    assert upper[2] == pytest.approx(restitution(1.0, 1e6), abs=3e-6)
    # two free balls have another e at this speed
    assert abs(upper[2] - restitution(1.0, 1.0)) > 0.01


def test_rigid_bodies_have_their_mass(plugin: Path, tmp_path: Path) -> None:
    """A ball meets a row of three that are one rigid body, along their line: a target of three times the mass."""
    radius, x = 5e-3, 0.03
    heights = [0.05 + 2 * radius + GAP, 0.05, 0.05 - 2 * radius, 0.05 - 4 * radius]
    places = [(x, x, z) for z in heights]
    velocities = [(0.0, 0.0, -1.0)] + [(0.0, 0.0, 0.0)] * 3
    write_spheres(tmp_path / "row.data", (0.06, 0.06, 0.1), [1] * 4, [radius] * 4, [DENSITY] * 4, places, velocities)
    rigid = "group row id 2 3 4\ngroup free id 1\nfix nve free nve/sphere\nneigh_modify exclude group row row\nfix row row rigid single"
    # rigid bodies leave no degrees of freedom for the temperature that LAMMPS prints
    silent = ("thermo 1000000", "thermo 1000000\nthermo_style custom step")
    script = changed(tmp_path, "pair_meet.in", ("fix nve all nve/sphere", rigid), silent)
    run = dict(data=tmp_path / "row.data", style="plm", coeff=f"* * {STEEL}", newton="on", dt="1e-8", n=15_000)
    lammps(plugin, script, out=tmp_path / "out", **run)
    speeds = table(tmp_path / "out")[:, 3]
    assert speeds[1:] == pytest.approx([speeds[1]] * 3, abs=1e-12) and speeds[1] < 0.0
    assert speeds[0] - speeds[1] == pytest.approx(restitution(1.0, 3.0), abs=1e-6)


@pytest.mark.parametrize("style", ["pour", "deposit"])
def test_radii_that_appear_in_a_run(plugin: Path, tmp_path: Path, style: str) -> None:
    """Large spheres fall on small ones. The neighbour list is made for the large ones from the start, as no energy is lost."""
    mass = DENSITY * 4 / 3 * np.pi * 6e-3**3
    ball = f"large\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\nDiameters\n\n1 0.012\n\nMasses\n\n1 {mass!r}\n"
    (tmp_path / "large.ball").write_text(ball)
    inserted = {
        "pour": "fix new all pour 4 1 4711 vol 0.9 200 diam one 0.012 dens 7850 7850 region top vel 0 0 0 0 -3",
        "deposit": f"molecule large {tmp_path}/large.ball\nfix new all deposit 4 0 1000 4711 region top near 0.013 vz -3 -3 mol large units box",
    }[style]
    script = tmp_path / "new.in"
    script.write_text(f"""units si
atom_style sphere
boundary p p f
newton on
comm_modify vel yes
region box block 0 0.04 0 0.04 0 0.08
create_box 1 box
lattice sc 0.01
region low block 0 0.04 0 0.04 0.004 0.012 units box
create_atoms 1 region low
set group all diameter 0.004 density 7850
pair_style plm
pair_coeff * * {STEEL}
neighbor 0.0005 bin
neigh_modify delay 0 every 1 check yes
fix nve all nve/sphere
fix down all gravity 9.81 vector 0 0 -1
fix floor all plm/wall plane 0 scenario {STEEL}
fix_modify down energy yes
fix_modify floor energy yes
region top block 0 0.04 0 0.04 0.02 0.05 units box
{inserted}
fix energy all plm/energy
compute kinetic all ke
variable n equal atoms
variable total equal c_kinetic+f_down+f_floor+f_energy
timestep 2e-7
thermo_style custom step v_n v_total f_energy[2]
thermo_modify format float %.15g lost error
thermo 5000
run 100000
""")
    output = lammps(plugin, str(script))
    rows = np.array(re.findall(r"^ +\d+ +([-+.e\d]+) +([-+.e\d]+) +([-+.e\d]+) *$", output, re.M), dtype=float)
    count, total, plastic = rows.T
    assert count[0] < count[-1], output[-2000:]
    later = count == count[-1]
    assert plastic[-1] > plastic[later][0], "large spheres meet others"
    # the error of velocity Verlet
    assert np.ptp(total[later]) < 1e-5 * total[-1]
