"""Tables of impacts: which keys are meant, and how their values are broadcast."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core
from ._results import Table

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def impacts(contact: _core.Contact, /, **keys: ArrayLike) -> Table:
    """A table of impacts of a contact. Every other argument is a numeric key with its values: numbers in SI units (an angle in
    rad), arrays of numbers, or a text with a unit; arrays are broadcast against each other. The key is named by the last part
    of its path (`speed`), by all parts (`half_space_yield_strength`), or by the path itself (`**{"impact.speed": v}`):

        table = impacts(contact, speed=np.linspace(0.5, 5, 100), yield_strength=[[2e8], [3e8]])
        table["restitution"].shape                                                  # (2, 100)

    The columns are those of table.csv. First the keys, with their units (`impact_speed_m_per_s`), then `restitution`,
    `contact_time_s`, `peak_force_N`, `peak_indentation_m`, `contact_radius_over_R`, `is_outside_validity`,
    `recovered_fraction`; if a body yields, `residual_indentation_m`, `dent_diameter_m`, `plastic_fraction`, and `flat_depth_m` if
    the sphere may; if a body has a material by name, a hardness, or `strength_kind = "proof"`, the interval of e,
    `restitution_interval_low` and `restitution_interval_high`; if the half-space has a density, `wave_loss_fraction` and
    `restitution_with_waves`, and if it has a mass, `target_speed_m_per_s`; on a plate or rod, `plate_loss_fraction` or
    `rod_loss_fraction` and others; with a work of adhesion, `sticking_speed_m_per_s` and `restitution_with_adhesion`; and
    `status`, which is "ok" or says why a row has no numbers (they are NaN then, and a ModelWarning says how many).
    scenarios/results.md says what each column is.

    A number that is NaN or not allowed, such as a negative speed, spares the other rows: its row has the status "not_allowed",
    and the ModelWarning names the first such number and its index. A text that is not allowed raises ValueError.
    """
    if not keys:
        raise ValueError("no key is given; write one such as speed=[1.0, 2.0]")
    given: dict[int, tuple[str, str, Any]] = {}
    for name, value in keys.items():
        place, path = _cache.get((name, contact._law)) or resolve_key(name, contact._law)
        if place in given:
            raise ValueError(f"{path}: is given twice, as {given[place][0]} and as {name}; keep one of the two")
        given[place] = name, path, _core.validated(contact, path, value)
    # in the order of the registry, so that results do not depend on the order of the arguments
    paths, values = zip(*(given[place][1:] for place in sorted(given)))
    shapes = [getattr(value, "shape", ()) for value in values]
    shape = shapes[0]
    if any(other != shape for other in shapes):
        import numpy

        values = numpy.broadcast_arrays(*values)
        shape = values[0].shape
    columns = _core.rows(contact, list(zip(paths, values)))
    return Table(shape, columns, dict(zip(columns, shapes)))


# a name such as `radius` or `yield_strength` alone is that of the other body
LOW_PRIORITY = ["sphere.yield_strength", "sphere.hardness", "half_space.radius", "half_space.mass"]

# by name and law
_cache: dict[tuple[str, str], tuple[int, str]] = {}


def resolve_key(name: str, law: str) -> tuple[int, str]:
    """The key that the name of an argument means under a law: its place in the registry, and its path."""
    paths = _core.numeric_keys()
    found = [path for path in paths if name in (path, path.replace(".", "_"))]
    if not found:
        last = [path for path in paths if path.endswith(f".{name}")]
        # neither keys of other laws nor what a scene seldom has: it is meant where it is named in full
        laws = [path for path in last if path.startswith("law.") and not path.startswith(f"law.{law}.")]
        found = [path for path in last if path not in [*laws, *LOW_PRIORITY]] or last
    if len(found) > 1:
        names = " or ".join(path.replace(".", "_") for path in found)
        raise ValueError(f"{name}: may be {names}; write one of them")
    if not found:
        if name.endswith(("law", "method", "material")):
            ways = "make a Contact for each, or plm_impact.run a scenario with a sweep of them"
            raise TypeError(f"{name}: words are not broadcast; {ways}")
        # such a name is refused with its values
        return len(paths), name
    return _cache.setdefault((name, law), (paths.index(found[0]), found[0]))
