"""What Python hands over, as the library takes it: dicts as TOML, arrays as doubles, measurements as CSV."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

# largest depth of dicts and lists inside of each other; no scenario needs as much
MAX_DEPTH = 16


def reject_units_and_masks(value: Any, place: str) -> None:
    """Refuses arrays with units and masked arrays, because NumPy would drop units and mask without a warning."""
    unit = 'units; pass plain numbers in SI, or a string such as "5 mm"'
    for name, what in [("units", unit), ("unit", unit), ("mask", "a mask; leave the masked values out")]:
        if hasattr(value, name) and not callable(getattr(value, name)):
            raise TypeError(f"{place}: the value has {what}")


def numbers(value: Any, place: str) -> NDArray[np.float64]:
    """Numbers in SI units as a contiguous array of doubles. Messages use `place`, the name of the numbers."""
    import numpy

    reject_units_and_masks(value, place)
    array = numpy.asarray(value)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{place}: found the type {array.dtype}, expected numbers in SI")
    return numpy.require(array, "float64", ["C", "A"])


def scenario_of(tables: Mapping[Any, Any]) -> tuple[str, list[str]]:
    """A scenario that is given as a dict: its TOML text, in which tables and keys keep the order of the dict, and overrides.
    A law that is given by its name alone becomes an override, which is where a scenario takes names of laws.
    """
    plain: list[str] = []
    rest: list[str] = []
    overrides: list[str] = []
    for name, value in tables.items():
        if not isinstance(name, str):
            raise TypeError("keys must be strings")
        text = toml(value, name)
        if isinstance(value, Mapping):
            rest += [f"[{key(name)}]", *(f"{key(inner)} = {toml(value[inner], f'{name}.{inner}')}" for inner in value)]
        elif name == "law" and isinstance(value, str):
            overrides.append(f"law={text}")
        else:
            # plain keys come before the tables; after a table they would belong to it
            plain.append(f"{key(name)} = {text}")
    return "\n".join([*plain, *rest, ""]), overrides


def toml(value: Any, place: str, depth: int = 0) -> str:
    """A value in TOML. Messages use `place`, the path of its key."""
    if depth > MAX_DEPTH:
        raise ValueError(f"{place}: too many dicts or lists inside of each other")
    if value is None:
        raise TypeError(f"{place}: found None; leave the key out")
    reject_units_and_masks(value, place)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int):
        if not -(1 << 63) <= value < 1 << 63:
            raise TypeError(f"{place}: the whole number is too large; write it as a float")
        return int.__repr__(value)
    if isinstance(value, float):
        return float.__repr__(value)
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, Mapping):
        if not all(isinstance(name, str) for name in value):
            raise TypeError(f"{place}: a key is not a text")
        items = (f"{key(name)} = {toml(inner, f'{place}.{name}', depth + 1)}" for name, inner in value.items())
        return "{ " + ", ".join(items) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(item, place, depth + 1) for item in value) + "]"
    if isinstance(value, os.PathLike):
        return toml(os.fspath(value), place, depth + 1)
    if hasattr(value, "tolist"):
        return toml(value.tolist(), place, depth + 1)
    raise TypeError(f"{place}: found {type(value).__name__}, expected a number, a text, a list or a dict")


def quoted(text: str) -> str:
    """A text with quotes. TOML escapes it as JSON does, and DEL too."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def key(name: str) -> str:
    """A key, with quotes if it needs them."""
    return name if re.fullmatch("[A-Za-z0-9_-]+", name) else quoted(name)


def csv_of(data: Any) -> str:
    """Measurements as the text of a CSV file, with the shortest digits from which the same number is read."""
    import numpy

    if hasattr(data, "column_names"):
        names = list(data.column_names)
    elif hasattr(data, "columns"):
        names = list(data.columns)
    elif hasattr(data, "keys"):
        names = list(data.keys())
    else:
        raise TypeError("data: expected a dict or a DataFrame")
    columns = []
    for name in names:
        reject_units_and_masks(data[name], name)
        columns.append(numpy.atleast_1d(numpy.asarray(data[name])))

    def field(value: Any) -> str:
        is_missing = (
            value is None or type(value).__name__ == "NAType" or (isinstance(value, float) and math.isnan(value))
        )
        return "" if is_missing else str(value)

    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names or [""])
    rows = zip(*(column.tolist() for column in numpy.broadcast_arrays(*columns)))
    writer.writerows([field(value) for value in row] for row in rows)
    return text.getvalue()
