# SPDX-License-Identifier: Apache-2.0
"""The rows of a table on one rank, as arrays in the simulation's own memory."""

from __future__ import annotations

import operator
from typing import Any, Iterator, Optional

import numpy as np

from .errors import unknownName

__all__ = ["LocalArray", "Rows"]


class LocalArray(np.ndarray):
    """An array over the simulation's memory. Results of computations are ordinary arrays.

    After its block any access raises RuntimeError, except for conversions that read the buffer itself:
    np.asarray(a) and memoryview(a) give the values at the end of the block. Plain arrays made of it within
    the block keep these values too.
    """

    _rows: Optional["Rows"] = None

    def __array_finalize__(self, source: Any) -> None:
        # The base of a view is a LocalArray; a copy has none, and stays valid after the block.
        if isinstance(self.base, LocalArray):
            self._rows = self.base._rows

    def __getattribute__(self, name: str) -> Any:
        # Methods and attributes of numpy read the memory without a call of the functions below.
        if not name.startswith("_") or name in _MEMORY:
            self._check()
        return super().__getattribute__(name)

    def _check(self) -> None:
        if self._rows is not None and not self._rows._open:
            raise RuntimeError(ENDED.format("the array"))

    def _plain(self) -> np.ndarray:
        return self.view(np.ndarray)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        out = options.get("out")
        if out is not None:
            options["out"] = tuple(_plain(one) for one in out)
        if "where" in options:
            options["where"] = _plain(options["where"])
        result = getattr(ufunc, method)(*(_plain(one) for one in inputs), **options)
        if out is None or result is NotImplemented or result is None:
            return result
        return out[0] if len(out) == 1 else out  # `p.velocity += dv` needs the array itself

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        self._plain()
        return super().__array_function__(function, types, arguments, options)

    def __getitem__(self, key: Any) -> Any:
        self._plain()
        return super().__getitem__(key)

    def __setitem__(self, key: Any, values: Any) -> None:
        self._plain()[_plain(key)] = _plain(values)

    def copy(self, order: Any = "C") -> np.ndarray:
        return self._plain().copy(order)

    def astype(self, *arguments: Any, **options: Any) -> np.ndarray:
        return self._plain().astype(*arguments, **options)

    def __len__(self) -> int:
        return len(self._plain())

    def __repr__(self) -> str:
        if self._rows is not None and not self._rows._open:
            return "<array of a block that has ended>"
        return repr(self._plain())

    __str__ = __repr__

    def __reduce__(self) -> Any:
        return self._plain().__reduce__()

    # numpy's own comparison replaces an error by a warning and False.
    def __eq__(self, other: Any) -> Any:
        self._check()
        return super().__eq__(other)

    def __ne__(self, other: Any) -> Any:
        self._check()
        return super().__ne__(other)

    __hash__ = None  # type: ignore[assignment]

    def __bool__(self) -> bool:
        return bool(self._plain())

    def __int__(self) -> int:
        return int(self._plain())

    def __float__(self) -> float:
        return float(self._plain())

    def __complex__(self) -> complex:
        return complex(self._plain())

    def __index__(self) -> int:
        return operator.index(self._plain())

    def __copy__(self) -> np.ndarray:
        return self._plain().__copy__()

    def __deepcopy__(self, memo: Any) -> np.ndarray:
        return self._plain().__deepcopy__(memo)


# attributes with an underscore that give access to the memory
_MEMORY = ("__array__", "__array_interface__", "__array_struct__")

ENDED = "{}: its block, or its call of a function, has ended; copy values in it, or use sim.gather()"


def _plain(value: Any) -> Any:
    return value._plain() if isinstance(value, LocalArray) else value


class Rows:
    """The rows of one table on this rank, in a block `with sim.local() as p`.

    Fields are arrays over the simulation's own memory, without a copy: `p["temperature"]` or `p.temperature`.
    Iteration gives the names of the fields, and `len(p)` the number of rows.
    Outside of the block, access to the rows and to their arrays raises RuntimeError. Values of `velocity` and
    `temperature` of particles may be changed in place (`p.velocity += dv`); all other arrays are read-only.
    """

    def __init__(self, source: Any, table: str, changes: bool):
        self.__dict__.update(_source=source, _table=table, _changes=changes, _open=True, _arrays={})

    def _close(self) -> None:
        self.__dict__.update(_open=False, _arrays={})

    def _need(self, what: str) -> None:
        if not self._open:
            raise RuntimeError(ENDED.format(what))

    def __getitem__(self, field: str) -> np.ndarray:
        self._need(f"'{field}'")
        if not isinstance(field, str):
            raise TypeError(f"expected the name of a field, such as p['velocity'], got {field!r}")
        if field in self._arrays:
            return self._arrays[field]
        try:
            values = self._source.view(self._table, field, self._changes and field in self._WRITABLE)
        except KeyError:
            raise unknownName(field, self.fields(), f"table '{self._table}'") from None
        self._arrays[field] = _local(values, self)
        return self._arrays[field]

    _WRITABLE = ("velocity", "temperature")

    def __getattr__(self, field: str) -> np.ndarray:
        if field.startswith("_"):
            raise AttributeError(field)
        try:
            return self[field]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __setitem__(self, field: str, values: Any) -> None:
        array = self[field]
        if values is not array:  # `p.velocity += dv` assigns the array to itself
            array[...] = values

    def __setattr__(self, field: str, values: Any) -> None:
        try:
            self[field] = values
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __len__(self) -> int:
        """Number of rows."""
        self._need("len()")
        return self._source.rows(self._table)

    def __iter__(self) -> Iterator[str]:
        """Names of the fields."""
        return iter(self.fields())

    def __contains__(self, field: object) -> bool:
        return field in self.fields()

    def fields(self) -> list[str]:
        """Names of the fields of this table."""
        self._need("fields()")
        return [name for name, _, _, _ in self._source.fields(self._table)]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(self.fields() if self._open else ())})

    def _ipython_key_completions_(self) -> list[str]:
        return self.fields()

    def __repr__(self) -> str:
        return f"<{len(self)} rows of {self._table}>" if self._open else f"<rows of {self._table}, ended>"


def _local(values: np.ndarray, rows: Rows) -> LocalArray:
    array = values.view(LocalArray)
    array._rows = rows
    return array
