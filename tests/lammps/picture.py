"""Draws the pictures of plots/lammps from runs of LAMMPS, and notes their numbers: UPDATE=1 pytest tests/lammps (needs matplotlib)."""

import re
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from runs import INPUTS, ROOT, STEEL, lammps, plm, table
from spheres import DENSITY, write_gas
from test_lammps import RADII, closed_form, energies, write_rain

COLOURS = dict(zip(RADII, ("#0072b2", "#e69f00", "#009e73")))


def draw(plugin: Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        data, out = Path(folder) / "rain.data", Path(folder) / "rain"
        radius, speed = write_rain(data, 2000)
        output = lammps(plugin, "rain.in", data=data, out=out, scenario=STEEL, dt="4e-8", half=800, wall="plane 0")
        rows = table(Path(f"{out}.dump"))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), dpi=100, layout="constrained")
    grid = np.geomspace(0.45, 5.2, 200)
    left.plot(grid, closed_form().restitution(grid), color="black", lw=1, label="closed form, every radius")
    for size, colour in COLOURS.items():
        of_size = np.flatnonzero(radius == size)[::8]
        label = f"LAMMPS, radius {1e3 * size:g} mm"
        left.plot(speed[of_size], rows[of_size, 4] / speed[of_size], ".", ms=4, color=colour, label=label)
    # the output has the row between the two halves twice
    kinetic, _, stored, plastic = np.delete(energies(output), 17, axis=0).T
    time = 1e6 * 4e-8 * 50 * np.arange(kinetic.size)
    parts = [kinetic, stored, plastic]
    right.stackplot(
        time,
        np.array(parts) / kinetic[0],
        labels=["kinetic", "stored in contacts", "gone into dents"],
        colors=["#56b4e9", "#f0e442", "#d55e00"],
    )
    right.set(
        xlabel="time [µs]",
        ylabel="share of the energy",
        title="Where the energy of the rain is",
        ylim=(0, 1.02),
        xlim=(0, time[-1]),
    )
    right.legend(loc="lower left")
    left.set(
        xlabel="impact speed [m/s]", ylabel="restitution e", title="2000 steel spheres of three sizes on a steel wall"
    )
    left.legend(frameon=False)
    left.grid(alpha=0.3)
    figure.savefig(ROOT / "plots/lammps/rain.png")
    # tests/program/report/external_pictures.rs compares these numbers with those of the program
    lines = [f"{speed:g},{float(closed_form().restitution(speed)):.6g}" for speed in (1.0, 2.0, 3.0, 4.0)]
    noted = ROOT / "tests/reference/rain_picture.csv"
    noted.write_text("\n".join(["speed_m_per_s,restitution", *lines, ""]))


GAS_RADIUS, GAS_SIDE, GAS_CELL, GAS_SPEED = 5e-3, 6, 0.0135, 1.0
GAS_STEP, GAS_STEPS, GAS_EVERY = 6e-7, 400_000, 1000


def two_steel_balls() -> plm.Contact:
    steel = dict(
        youngs_modulus="210 GPa", poissons_ratio=0.3, density=DENSITY, yield_strength="345 MPa", strength_kind="flow"
    )
    law = dict(plm=dict(unloading_exponent="pressure-shape"))
    sphere, half_space = dict(radius=GAS_RADIUS, **steel), dict(radius=GAS_RADIUS, mass="ball", **steel)
    return plm.Contact(sphere=sphere, half_space=half_space, law=law)


def cooling(plugin: Path, folder: Path, style: str, coeff: str, last: str = "") -> tuple:
    """Time and kinetic energy of the gas."""
    script = folder / "gas.in"
    script.write_text(
        (INPUTS / "gas_cools.in").read_text() + "fix energy all plm/energy\n" * bool(last) + "run ${n}\n" + last
    )
    output = lammps(
        plugin,
        str(script),
        data=folder / "gas.data",
        style=style,
        coeff=coeff,
        dt=GAS_STEP,
        n=GAS_STEPS,
        every=GAS_EVERY,
    )
    rows = re.findall(r"^ +(\d+) +([-+.eE\d]+) *$", output, re.M)
    steps, kinetic = np.array(rows, dtype=float).T
    return GAS_STEP * steps, kinetic


def draw_gas(plugin: Path) -> None:
    mass = DENSITY * 4 / 3 * np.pi * GAS_RADIUS**3
    # the normal speed of collisions in a gas of this speed in each direction, averaged over the energy that they lose
    typical = 1.5 * np.sqrt(np.pi) * GAS_SPEED
    impact = two_steel_balls().impact(typical)
    constant, duration = impact.restitution, impact.contact_time_s
    stiffness = mass / 2 * (np.pi**2 + np.log(constant) ** 2) / duration**2
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_gas(folder / "gas.data", GAS_SIDE, GAS_SPEED, (GAS_RADIUS,) * 3, GAS_CELL)
        dump = f"write_dump all custom {folder}/last id x y z f_energy[1] modify sort id"
        time, ours = cooling(plugin, folder, "plm", f"* * {STEEL}", dump)
        spring = (
            f"* * hooke {float(stiffness)!r} {constant!r} damping coeff_restitution tangential linear_nohistory 0 0"
        )
        _, theirs = cooling(plugin, folder, "granular", spring)
        spheres = table(folder / "last")
    # Haff (1983) with the collision rate of Enskog: dT/dt = -(1 - e^2) rate T/3
    number = 1 / GAS_CELL**3
    packing = number * 4 / 3 * np.pi * GAS_RADIUS**3
    contact_value = (1 - packing / 2) / (1 - packing) ** 3
    speed = np.sqrt(2 * ours[0] / (3 * mass * GAS_SIDE**3))
    rate = 4 * number * (2 * GAS_RADIUS) ** 2 * np.sqrt(np.pi) * speed * contact_value
    haff = (1 + time * (1 - constant**2) * rate / 6) ** -2
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), dpi=100, layout="constrained")
    left.loglog(1e3 * time[1:], ours[1:] / ours[0], color="#d55e00", label="pair_style plm: e of each collision")
    left.loglog(
        1e3 * time[1:], theirs[1:] / theirs[0], color="#0072b2", label=f"pair_style granular: e = {constant:.3f}"
    )
    left.loglog(1e3 * time[1:], haff[1:], "k--", lw=1, label=f"Haff's law: e = {constant:.3f}")
    left.set(
        xlabel="time [ms]",
        ylabel="kinetic energy, over that at the start",
        title=f"{GAS_SIDE**3} steel spheres collide",
    )
    left.legend(frameon=False)
    left.grid(alpha=0.3, which="both")
    order = np.argsort(spheres[:, 2])
    points = right.scatter(
        *(1e3 * spheres[order][:, [1, 3]].T),
        c=1e3 * spheres[order, 4],
        s=330,
        cmap="inferno",
        edgecolor="black",
        lw=0.5,
    )
    figure.colorbar(points, label="plastic work of a sphere [mJ]")
    right.set(xlabel="x [mm]", ylabel="z [mm]", title="Where the energy has gone", aspect="equal")
    figure.savefig(ROOT / "plots/lammps/gas.png")
    # tests/program/report/external_pictures.rs compares these numbers with those of the program
    lines = [f"{speed:g},{float(two_steel_balls().restitution(speed)):.6g}" for speed in (0.1, 0.5, 1.0, 2.0)]
    noted = ROOT / "tests/reference/gas_picture.csv"
    noted.write_text("\n".join(["speed_m_per_s,restitution", *lines, ""]))
