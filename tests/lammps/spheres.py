"""Spheres of the tests of pair_style plm: pairs that meet, and a gas; their data files, and what LAMMPS prints of them."""

from __future__ import annotations

import re
from pathlib import Path

from runs import np, plm

DENSITY = 7850.0
GAP = 1e-8
ELASTIC = dict(youngs_modulus="210 GPa", poissons_ratio=0.3)
STRENGTH = dict(yield_strength="345 MPa", strength_kind="flow")
LAW = dict(plm=dict(unloading_exponent="pressure-shape"))


def two_balls(
    radii: tuple, densities: tuple = (DENSITY, DENSITY), strengths: tuple = (STRENGTH, STRENGTH)
) -> plm.Contact:
    """The closed form of two balls: the bodies of STEEL, with the strengths of a one-material pair."""
    sphere = dict(radius=radii[0], density=densities[0], **ELASTIC, **strengths[0])
    half_space = dict(radius=radii[1], mass="ball", density=densities[1], **ELASTIC, **strengths[1])
    return plm.Contact(sphere=sphere, half_space=half_space, law=LAW)


def write_spheres(
    path: Path, box: tuple, types: list, radii: list, density: list, places: list, velocities: list
) -> None:
    """A data file; the columns are lists of numbers, and every number is written with all its digits."""
    lines = ["spheres", "", f"{len(radii)} atoms", f"{max(types)} atom types", ""]
    lines += [f"0 {size!r} {axis}lo {axis}hi" for axis, size in zip("xyz", box)]
    lines += ["", "Atoms # sphere", ""]
    rows = zip(types, radii, density, places)
    lines += [f"{i} {kind} {2 * r!r} {rho!r} {x!r} {y!r} {z!r}" for i, (kind, r, rho, (x, y, z)) in enumerate(rows, 1)]
    lines += ["", "Velocities", ""]
    lines += [f"{i} {vx!r} {vy!r} {vz!r} 0 0 0" for i, (vx, vy, vz) in enumerate(velocities, 1)]
    path.write_text("\n".join(lines) + "\n")


def write_pairs(
    path: Path,
    radii: list,
    speeds: list,
    densities: list,
    types: tuple = (1, 1),
    angle: float = 0.0,
    shift: float = 0.0,
) -> None:
    """Pairs along x, one sphere above the other in z, of which the upper one moves at its speed, at an angle from the line of
    centres. All centres are moved by `shift` along z, through the faces of the box."""
    side = 0.06
    columns: list = [[], [], [], [], []]
    for k, ((upper, lower), speed, density) in enumerate(zip(radii, speeds, densities)):
        x = side * (k + 0.5)
        heights = [(0.03 + upper + GAP + shift) % side, (0.03 - lower + shift) % side]
        velocity = (speed * np.sin(angle), 0.0, -speed * np.cos(angle))
        new = (types, (upper, lower), density, [(x, side / 2, z) for z in heights], [velocity, (0.0, 0.0, 0.0)])
        for column, values in zip(columns, new):
            column.extend(values)
    columns[4] = [tuple(float(part) for part in velocity) for velocity in columns[4]]
    write_spheres(path, (side * len(radii), side, side), *columns)


def write_gas(
    path: Path, side: int, speed: float = 1.0, radii: tuple = (2e-3, 3e-3, 5e-3), cell: float = 0.0125, seed: int = 1
) -> None:
    """side**3 spheres of random radii with random velocities and no total momentum; two radii are the ends of all."""
    random = np.random.default_rng(seed)
    count = side**3
    radius = random.choice(radii, count) if len(radii) > 2 else random.uniform(*radii, count)
    places = (np.indices((side,) * 3).reshape(3, -1).T + 0.5) * cell
    velocity = random.normal(0.0, speed, (count, 3))
    mass = radius**3
    velocity -= (mass[:, None] * velocity).sum(0) / mass.sum()
    columns = ([1] * count, radius.tolist(), [DENSITY] * count, places.tolist(), velocity.tolist())
    write_spheres(path, (side * cell,) * 3, *columns)


LEDGER = ("kinetic", "spin", "contacts", "stored", "plastic", "friction", "rolling", "of_dents", "of_rubbing")


def ledger(output: str) -> dict:
    """The columns of the energies that gas.in prints."""
    rows = re.findall(r"^ +\d+((?: +[-+.eE\d]+){9}) *$", output, re.M)
    return dict(zip(LEDGER, np.array([row.split() for row in rows], dtype=float).T))
