"""Low-velocity impact of an elastic sphere on an elastic-plastic half-space.

`Contact` is a sphere on a half-space, `impacts` a table of its impacts, `run` does any scenario. Keys, units and results are
those of the command `plm-impact`; all numbers are in SI units.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._core import Contact, Impact, Outcome, Table, __version__, impacts, laws, materials, run, schema

if TYPE_CHECKING:
    from collections.abc import Mapping
    from os import PathLike
    from typing import Any

    from numpy.typing import ArrayLike

__all__ = [
    "Contact",
    "Impact",
    "Outcome",
    "Table",
    "__version__",
    "calibrate",
    "impacts",
    "laws",
    "materials",
    "run",
    "schema",
]


def calibrate(
    scenario: str | PathLike[str] | Mapping[str, Any],
    data: Mapping[str, ArrayLike] | None = None,
    /,
    *,
    set: Mapping[str, Any] | None = None,
) -> Outcome:
    """Finds keys of a scenario from measurements, as `plm-impact calibrate` does.

    `data` has columns with the names that a file of measurements has, such as `speed_m_per_s` and `restitution`; they take
    the place of the file. NaN stands for a quantity that was not measured.
    """
    if not data:
        return run(scenario, set=set)
    # imported here, so that the import of the module is fast
    import csv
    from pathlib import Path
    from tempfile import TemporaryDirectory

    import numpy as np

    columns = np.broadcast_arrays(*(np.atleast_1d(np.asarray(column, dtype=float)) for column in data.values()))
    with TemporaryDirectory() as folder:
        file = Path(folder) / "data.csv"
        with file.open("w", newline="", encoding="utf-8") as text:
            rows = csv.writer(text)
            rows.writerow(data)
            # repr has all digits, so that reading gives the same number
            rows.writerows(["" if np.isnan(value) else repr(float(value)) for value in row] for row in zip(*columns))
        return run(scenario, set={**(set or {}), "calibrate.data": str(file)})
