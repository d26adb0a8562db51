# ruff: noqa: F403, F405
"""A ball on a wall in Yade, run by hand on 2026-11-22: e within 1 % of the export. Run it with the lines of the export in lines.py:

plm-impact export scenarios/steel-on-steel.toml --to yade > lines.py; yade -n -x yade.py
"""

from pathlib import Path

from yade import *

exec(Path("lines.py").read_text())  # material, functors and the time step
O.bodies.append(utils.wall(0.0, axis=2, sense=1, material=material))
ball = O.bodies.append(utils.sphere((0, 0, 5e-3 + 1e-9), 5e-3, material=material))
O.bodies[ball].state.vel = (0, 0, -3)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Wall_Sphere_ScGeom()], *functors),
    NewtonIntegrator(damping=0, gravity=(0, 0, 0)),
]
O.run(400, True)
print("restitution", O.bodies[ball].state.vel[2] / 3)
