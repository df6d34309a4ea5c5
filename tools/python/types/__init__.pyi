# The types of the module, for pyright, mypy and editors: options and results of the tools.
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import IO, Any, Generic, Literal, Protocol, TypeAlias, TypedDict, TypeVar, Unpack, overload, type_check_only

import numpy as np
import pandas as pd
import xarray as xr

from . import stage as stage
from ._accessor import Result as Result
from .errors import BadData as BadData
from .errors import NoFile as NoFile
from .errors import NotConverged as NotConverged
from .errors import ToolError as ToolError
from .errors import ToolWarning as ToolWarning
from .errors import UsageError as UsageError

__version__: str

_R = TypeVar("_R", covariant=True)
_Array: TypeAlias = np.ndarray[Any, Any]
_Name: TypeAlias = str | os.PathLike[str]
_Surface: TypeAlias = _Name | bytes | bytearray | memoryview | IO[bytes] | IO[str] | xr.Dataset | xr.DataArray | pd.DataFrame
_Surfaces: TypeAlias = Sequence[_Surface] | Mapping[str, _Surface] | Iterator[_Surface]
_Data: TypeAlias = _Surface | _Array | Mapping[str, Sequence[float] | _Array]
_Value: TypeAlias = str | float | Sequence[str] | Sequence[float] | _Array | Si
_Quantity: TypeAlias = str | Si | xr.DataArray | _Pint | Sequence[str] | Sequence[_Pint] | Literal[0]

@type_check_only
class _Pint(Protocol):
    @property
    def magnitude(self) -> Any: ...
    def to(self, other: Any, /) -> Any: ...

@type_check_only
class Si:
    value: Any

@type_check_only
class Document(bytes):
    media: str
    def save(self, name: _Name) -> None: ...

@type_check_only
class _Dataset(xr.Dataset):
    @property
    def asp(self) -> _Accessor: ...

class Stage(Generic[_R]):
    tool: str
    options: dict[str, Any]
    def __call__(self, *datasets: _Surface | _Surfaces) -> _R: ...

_First: TypeAlias = _Surface | Stage[Any]

@overload
def pipe(first: Stage[_R], /) -> _R: ...
@overload
def pipe(first: _First, last: Stage[_R], /) -> _R: ...
@overload
def pipe(first: _First, second: Stage[Any], last: Stage[_R], /) -> _R: ...
@overload
def pipe(first: _First, second: Stage[Any], third: Stage[Any], last: Stage[_R], /) -> _R: ...
@overload
def pipe(
    first: _First, second: Stage[Any], third: Stage[Any], fourth: Stage[Any], fifth: Stage[Any], /, *others: Stage[Any]
) -> Any: ...
def dataset(
    heights: _Array | xr.DataArray | Sequence[Sequence[float]],
    size: _Quantity | None = ...,
    unit: str = ...,
    periodic: bool | Literal["x", "y"] = ...,
) -> _Dataset: ...
def si(value: float | Sequence[float] | _Array) -> Si: ...
@overload
def ensemble(
    *, count: int, first: int = ..., seed: int | None = ..., processes: int | None = ..., **options: Unpack[_DrawOptions]
) -> Iterator[_Dataset]: ...
@overload
def ensemble(
    last: Stage[_R], /, *, count: int, first: int = ..., seed: int | None = ..., processes: int | None = ...
) -> Iterator[_R]: ...
@overload
def ensemble(
    draw: Stage[Any], last: Stage[_R], /, *, count: int, first: int = ..., seed: int | None = ..., processes: int | None = ...
) -> Iterator[_R]: ...
@overload
def ensemble(
    draw: Stage[Any], second: Stage[Any], last: Stage[_R], /, *, count: int, first: int = ..., seed: int | None = ...,
    processes: int | None = ...
) -> Iterator[_R]: ...
@overload
def ensemble(
    *stages: Stage[Any], count: int, first: int = ..., seed: int | None = ..., processes: int | None = ...
) -> Iterator[Any]: ...
