# what is compiled; its public part is described in __init__.pyi
from typing import Any, final

from . import Contact as Contact
from . import Impact as Impact
from . import Table
from . import __version__ as __version__
from . import calibrate as calibrate
from . import laws as laws
from . import materials as materials
from . import run as run
from . import schema as schema

__all__ = [
    "Column",
    "Contact",
    "Impact",
    "__version__",
    "arrow_stream",
    "calibrate",
    "laws",
    "materials",
    "numeric_keys",
    "rows",
    "run",
    "schema",
    "table_of_csv",
    "validated",
]

@final
class Column:
    @property
    def __array_interface__(self) -> dict[str, Any] | None: ...
    def categories(self) -> tuple[list[str], Any] | None: ...
    def numpy(self) -> Any: ...

def arrow_stream(columns: list[tuple[str, Column]]) -> object: ...
def table_of_csv(bytes: bytes) -> Table: ...
def numeric_keys() -> list[str]: ...
def validated(contact: Contact, path: str, value: Any) -> Any: ...
def rows(contact: Contact, keys: list[tuple[str, Any]]) -> dict[str, Column]: ...
