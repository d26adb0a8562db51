"""Draws plots/lammps/rain.png from a run of LAMMPS, and notes its numbers: UPDATE=1 pytest tests/lammps (needs matplotlib)."""

import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from runs import ROOT, STEEL, lammps, table
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
