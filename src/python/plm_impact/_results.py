"""Tables and outcomes: what the functions of the module return."""

import json
import math

from . import _core


class Table:
    """A table of named columns. `table["restitution"]` is a read-only NumPy array in the shape of the table; `to_dict` returns
    all columns, `to_pandas` a `pandas.DataFrame`. The table itself is Arrow data, which polars, pyarrow, DuckDB and
    `pandas.DataFrame.from_arrow` read without a copy. A table can be pickled. In the order of the rows the last index of the
    shape varies fastest.
    """

    def __init__(self, shape, columns):
        self.shape = shape
        self._columns = columns

    def __len__(self):
        return math.prod(self.shape)

    def __getitem__(self, name):
        if name not in self:
            raise KeyError(f'no column "{name}"; there are {", ".join(self)}')
        return self._columns[name].numpy().reshape(self.shape)

    def __contains__(self, name):
        return name in self._columns

    def __iter__(self):
        return iter(self._columns)

    def keys(self):
        """The names of the columns."""
        return list(self._columns)

    _ipython_key_completions_ = keys

    def to_dict(self):
        """All columns as NumPy arrays, by name."""
        return {name: self[name] for name in self}

    def to_numpy(self):
        """All columns as one structured NumPy array."""
        import numpy

        columns = self.to_dict()
        whole = numpy.empty(self.shape, [(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            whole[name] = column
        return whole

    def to_pandas(self):
        """The table as a `pandas.DataFrame`, with a row for each case."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_pandas needs pandas") from error
        return pandas.DataFrame({name: column.numpy() for name, column in self._columns.items()})

    def to_arrow(self):
        """The table as a `pyarrow.Table`, without a copy of its numbers."""
        try:
            import pyarrow
        except ImportError as error:
            ways = "polars.DataFrame and duckdb take the table itself, and to_pandas gives a DataFrame"
            raise ImportError(f"to_arrow needs pyarrow; {ways}") from error
        return pyarrow.table(self)

    def __arrow_c_stream__(self, requested_schema=None):
        # the Arrow standard allows a producer to ignore the requested types
        return _core.arrow_stream(list(self._columns.items()))

    def __array__(self, *_arguments, **_keywords):
        # NumPy and pandas.DataFrame would make one column of the names
        ways = "write table.to_numpy() for a structured array, table.to_pandas() for pandas"
        raise TypeError(f"a table has columns: {ways}")

    def __repr__(self):
        shape = "" if len(self.shape) == 1 else f" in the shape {list(self.shape)}"
        return f"<plm_impact.Table: {len(self)} rows{shape} of {', '.join(self)}>"


class Outcome:
    """The results of a scenario: `files` are the files that the command writes, as bytes by name, `tables` the tables among
    them, `pictures` the pictures (PNG), and `warnings` those about scene, model and run. An outcome can be pickled.
    """

    def __init__(self, warnings, text, files, table):
        self.warnings = warnings
        self.files = files
        self._text = text
        self._table = table

    def _ending(self, ending):
        return {name[: -len(ending)]: data for name, data in self.files.items() if name.endswith(ending)}

    @property
    def summary(self):
        """The results: `summary.json` as a dict."""
        return json.loads(self.files["summary.json"])

    @property
    def pictures(self):
        """The pictures by name, without `.png`."""
        return self._ending(".png")

    @property
    def tables(self):
        """The tables by name: `trace`, `impacts`, or the `table` of a sweep or of random cases."""
        tables = {name: _core.table_of_csv(data) for name, data in self._ending(".csv").items()}
        return tables if self._table is None else {**tables, "table": self._table}

    @property
    def trace(self):
        """The trace as a structured array; `None` for a scenario without one."""
        trace = self.files.get("trace.csv")
        return None if trace is None else _core.table_of_csv(trace).to_numpy()

    def __repr__(self):
        return f"<plm_impact.Outcome>\n{self._text.rstrip()}"

    def _repr_png_(self):
        return next(iter(self.pictures.values()), None)
