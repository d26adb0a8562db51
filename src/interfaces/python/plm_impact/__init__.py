"""Low-velocity impact of an elastic sphere on an elastic-plastic half-space.

`Contact` is a sphere on a half-space: its `restitution`, one `impact`, its `force` for a program that moves spheres.
`impacts` is a table of impacts, `run` does any scenario, `calibrate` finds keys from measurements, `find` the values of a key
that give a wanted result. `laws`, `materials` and `schema` say what there is. Keys, units and results are those of the command `plm-impact`; all numbers are in SI units.

    import numpy as np, plm_impact as plm
    steel = dict(youngs_modulus="210 GPa", poissons_ratio=0.3)
    contact = plm.Contact(sphere=dict(radius="5 mm", density="7850 kg/m^3", **steel),
                          half_space=dict(yield_strength="345 MPa", strength_kind="flow", **steel),
                          law=dict(plm=dict(unloading_exponent="pressure-shape")))
    contact.restitution(3.0)                                    # 0.5064
    contact.impact("3 m/s").peak_force_N
    plm.impacts(contact, speed=np.linspace(0.5, 5, 100)).to_pandas()

A wrong key or value raises ValueError, a wrong type TypeError, a missing file ScenarioNotFoundError, a run that fails RuntimeError.
What is doubtful is a ModelWarning, at most one a call. Long computations use all cores, and Ctrl-C stops them.
"""

from ._core import Contact, Impact, __version__, calibrate, find, laws, materials, run, schema
from ._impacts import impacts
from ._results import Outcome, Table

__all__ = [
    "Contact",
    "Impact",
    "ModelWarning",
    "Outcome",
    "ScenarioNotFoundError",
    "Table",
    "__version__",
    "calibrate",
    "find",
    "impacts",
    "laws",
    "materials",
    "run",
    "schema",
]


class ModelWarning(UserWarning):
    """What is doubtful about a scene, about the law where it is used, or about a run."""


class ScenarioNotFoundError(FileNotFoundError, ValueError):
    """A scenario that is not there: a FileNotFoundError, and a ValueError as every other bad scenario."""
