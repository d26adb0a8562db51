"""Tables and outcomes: what the functions of the module return."""

from __future__ import annotations

import base64
import functools
import importlib
import json
import math
from collections.abc import Iterable, Iterator, Mapping
from html import escape
from typing import TYPE_CHECKING, Any, NoReturn

from . import _core

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Table:
    """A table of named columns. `table["restitution"]` is a read-only NumPy array in the shape of the table; `to_dict` returns
    all columns, `to_pandas` and `to_polars` a DataFrame, `to_xarray` a Dataset whose dimensions are the keys that vary. The
    table itself is Arrow data, which polars, pyarrow, DuckDB and `pandas.DataFrame.from_arrow` read without a copy. A table
    can be pickled. In the order of the rows the last index of the shape varies fastest.
    """

    def __init__(
        self,
        shape: tuple[int, ...],
        columns: Mapping[str, _core.Column],
        keys: Mapping[str, tuple[int, ...]] | None = None,
    ) -> None:
        self._shape = shape
        self._columns = columns
        # the shape of each key before it was broadcast
        self._shapes = keys or {}

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the table: that of the keys, broadcast against each other."""
        return self._shape

    def __len__(self) -> int:
        return math.prod(self.shape)

    def __getitem__(self, name: str, /) -> NDArray[Any]:
        if name not in self:
            raise KeyError(f'no column "{name}"; there are {", ".join(self)}')
        return self._columns[name].numpy().reshape(self.shape)

    def __contains__(self, name: str, /) -> bool:
        return name in self._columns

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def keys(self) -> list[str]:
        """The names of the columns."""
        return list(self._columns)

    _ipython_key_completions_ = keys

    def to_dict(self) -> dict[str, NDArray[Any]]:
        """All columns as NumPy arrays, by name."""
        return {name: self[name] for name in self}

    def to_numpy(self) -> NDArray[np.void]:
        """All columns as one structured NumPy array."""
        import numpy

        columns = {name: self[name] for name in self}
        # words as texts of one length, which NumPy writes to a file
        columns = {name: column.astype(str) if column.dtype == object else column for name, column in columns.items()}
        whole = numpy.empty(self.shape, [(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            whole[name] = column
        return whole

    def to_pandas(self) -> Any:
        """The table as a `pandas.DataFrame`, with a row for each case. Words such as the status are categories."""
        pandas = import_optional("pandas", "to_pandas")

        def series(column: _core.Column) -> Any:
            words = column.categories()
            return column.numpy() if words is None else pandas.Categorical.from_codes(words[1], words[0])

        return pandas.DataFrame({name: series(column) for name, column in self._columns.items()})

    def to_polars(self) -> Any:
        """The table as a `polars.DataFrame`, with a row for each case, without a copy of its numbers."""
        return import_optional("polars", "to_polars").DataFrame(self)

    def to_arrow(self) -> Any:
        """The table as a `pyarrow.Table`, without a copy of its numbers."""
        return import_optional("pyarrow", "to_arrow").table(self)

    def to_xarray(self) -> Any:
        """The table as an `xarray.Dataset` in its shape. The keys are coordinates; one that varies along an axis alone names
        the dimension.
        """
        axes = range(len(self.shape))
        along = {
            name: [axis for axis, length in zip(axes[len(axes) - len(shape) :], shape) if length != 1]
            for name, shape in self._shapes.items()
        }
        names = ["case"] if len(axes) == 1 else [f"dim_{axis}" for axis in axes]
        for name, varying in reversed(along.items()):
            if len(varying) == 1:
                names[varying[0]] = name
        coordinates: dict[str, Any] = {}
        results: dict[str, Any] = {}
        for name, column in self.to_dict().items():
            if name in along and len(self):
                place = tuple(slice(None) if axis in along[name] else 0 for axis in axes)
                coordinates[name] = [names[axis] for axis in along[name]], column[place]
            else:
                results[name] = names, column
        return import_optional("xarray", "to_xarray").Dataset(results, coordinates)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        # the Arrow standard allows a producer to ignore the requested types
        return _core.arrow_stream(list(self._columns.items()))

    def __array__(self, *_arguments: Any, **_keywords: Any) -> NoReturn:
        # NumPy and pandas.DataFrame would make one column of the names
        ways = "write table.to_numpy() for a structured array, table.to_pandas() for pandas"
        raise TypeError(f"a table has columns: {ways}")

    def __repr__(self) -> str:
        shape = "" if len(self.shape) == 1 else f" in the shape {list(self.shape)}"
        return f"<plm_impact.Table: {len(self)} rows{shape} of {', '.join(self)}>"

    def _repr_html_(self) -> str:
        columns, count = [column.numpy() for column in self._columns.values()], len(self)
        ends = range(count) if count <= 2 * HEAD_ROWS else [*range(HEAD_ROWS), *range(count - HEAD_ROWS, count)]
        rows: list[list[object]] = [[row, *(field(column[row]) for column in columns)] for row in ends]
        if len(rows) < count:
            rows.insert(HEAD_ROWS, ["\u2026"] * (1 + len(columns)))
        head = line("th", ["", *self])
        body = "".join(line("td", row) for row in rows)
        return f"<table><thead>{head}</thead><tbody>{body}</tbody></table><p>{count} rows, shape {self.shape}</p>"


class Outcome:
    """The results of a scenario: `files` are the files that the command writes, as bytes by name, `tables` the tables among
    them, `pictures` the pictures (PNG), and `warnings` those about scene, model and run. An outcome can be pickled.
    """

    def __init__(self, warnings: list[str], text: str, files: dict[str, bytes], table: Table | None) -> None:
        self.warnings = warnings
        self.files = files
        self._text = text
        self._table = table

    def _ending(self, ending: str) -> dict[str, bytes]:
        return {name[: -len(ending)]: data for name, data in self.files.items() if name.endswith(ending)}

    def __getstate__(self) -> dict[str, Any]:
        # what is made from the files is made again
        return {name: self.__dict__[name] for name in ("warnings", "files", "_text", "_table")}

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The results: `summary.json` as a dict."""
        summary: dict[str, Any] = json.loads(self.files["summary.json"])
        return summary

    @property
    def pictures(self) -> dict[str, bytes]:
        """The pictures by name, without `.png`."""
        return self._ending(".png")

    @functools.cached_property
    def tables(self) -> dict[str, Table]:
        """The tables by name: `trace`, `impacts`, or the `table` of a sweep or of random cases, and the `traces` of a sweep."""
        tables = {name: _core.table_of_csv(data) for name, data in self._ending(".csv").items()}
        return tables if self._table is None else {**tables, "table": self._table}

    @functools.cached_property
    def trace(self) -> NDArray[np.void] | None:
        """The trace as a structured array; `None` for a scenario without one."""
        trace = self.files.get("trace.csv")
        return None if trace is None else _core.table_of_csv(trace).to_numpy()

    def __repr__(self) -> str:
        return f"<plm_impact.Outcome>\n{self._text.rstrip()}"

    def _repr_html_(self) -> str:
        return html_of(repr(self), next(iter(self.pictures.values()), None))


# rows of a table that a notebook shows at its begin, and at its end
HEAD_ROWS = 5


def field(value: Any) -> str:
    """A value of a table as a notebook shows it; empty where there is none."""
    if isinstance(value, str):
        return value
    return "" if math.isnan(value) else f"{value:.6g}"


def line(tag: str, cells: Iterable[object]) -> str:
    """A line of a table in HTML."""
    return "<tr>" + "".join(f"<{tag}>{escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"


def html_of(text: str, picture: bytes | None) -> str:
    """A text with its columns, and a picture (PNG) below it, for notebooks."""
    shown = f"<pre>{escape(text)}</pre>"
    if picture is None:
        return shown
    return f'{shown}<img style="max-width: 100%" src="data:image/png;base64,{base64.b64encode(picture).decode()}">'


def import_optional(name: str, method: str) -> Any:
    """A package that only this method needs."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(
            f"{method} needs {name}: pip install {name}; to_dict gives NumPy arrays without it"
        ) from error
