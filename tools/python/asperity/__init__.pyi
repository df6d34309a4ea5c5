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

# ---- from here on: tests/python/stubs TOOLS FOLDER --write ----

class _EachOptions(TypedDict, total=False):
    config: _Name | None
    memory: _Quantity | None
    output: _Name | None
    progress: Literal["auto", "always", "never", None]
    time: bool | None
    verbose: bool | None

class AcfOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    remove_form: _Value | None
    lambda_s: _Quantity | None
    lambda_c: _Quantity | None
    correlation: Literal["auto", "drawn", "estimate", None]
    max_lag: _Value | None
    biased: bool | None
    taper: bool | None
    absolute: bool | None
    add: _Value | None
    levels: _Value | None
    direction: _Quantity | None
    threads: _Value | None
    no_history: bool | None

class ContactOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    shape: _Value | None
    size: _Quantity | None
    counter: _Data | None
    boundary: Literal["free", "periodic", "periodic_x", "periodic_y", None]
    radius: _Quantity | None
    radius_x: _Quantity | None
    radius_y: _Quantity | None
    young: _Quantity | None
    poisson: _Value | None
    load: _Quantity | None
    mean_pressure: _Quantity | None
    approach: _Quantity | None
    yield_: _Quantity | None
    limit_pressure: _Quantity | None
    add: _Value | None
    accuracy: _Value | None
    plasticity: Literal["cut", "j2", None]
    hardening: _Value | None
    depths: _Quantity | None
    increments: _Value | None
    unload: bool | None
    each: _Name | None
    tolerance: _Value | None
    max_convolutions: _Value | None
    report: _Name | None
    threads: _Value | None
    no_history: bool | None

class ConvertOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    separator: Literal["auto", "blank", "tab", "comma", "semicolon", None]
    decimal: Literal["auto", "point", "comma", None]
    xyz: _Value | None
    missing: _Value | None | list[_Value]
    size: _Quantity | None
    unit: _Value | None
    to_order: Literal["xy", "yx", None]
    surface: bool | None
    variable: _Value | None
    no_history: bool | None

class FilterOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    remove_form: _Value | None | list[_Value]
    lambda_s: _Quantity | None | list[_Quantity]
    lambda_c: _Quantity | None | list[_Quantity]
    closing: _Quantity | None | list[_Quantity]
    opening: _Quantity | None | list[_Quantity]
    median: _Quantity | None | list[_Quantity]
    outliers: _Value | None | list[_Value]
    fill: Literal["laplace", "mean", "least", None] | list[Literal["laplace", "mean", "least", None]]
    scale: _Value | None | list[_Value]
    crop: _Value | None | list[_Value]
    decimate: _Value | None | list[_Value]
    refine: _Value | None | list[_Value]
    spacing: _Value | None | list[_Value]
    rotate: _Quantity | None | list[_Quantity]
    mirror: Literal["x", "y", "both", None] | list[Literal["x", "y", "both", None]]
    make_periodic: _Value | None | list[_Value]
    steps: _Value | None
    threads: _Value | None
    no_history: bool | None

class _DrawOptions(_EachOptions, total=False):
    shape: _Value | None
    size: _Quantity | None
    rq: _Quantity | None
    rms_slope: _Value | None
    exact_rq: bool | None
    periodic: bool | None
    add: _Value | None
    model: Literal["exponential", "gaussian", "matern", "stretched-exponential", "self-affine", "exponential-cosine", None]
    length: _Quantity | None
    length_level: _Value | None
    angle: _Quantity | None
    smoothness: _Value | None
    exponent: _Value | None
    hurst: _Value | None
    rolloff: _Quantity | None
    cutoff: _Quantity | None
    wavelength: _Quantity | None
    acf: _Data | None
    psd: _Data | None
    skewness: _Value | None
    kurtosis: _Value | None
    marginal: _Data | None
    lags: _Value | None
    acf_tolerance: _Value | None
    formulation: Literal["symmetric", "oriented", "patir", None]
    method: Literal["newton-krylov", "spectral", "filter", None]
    infeasible: Literal["auto", "error", "nearest", None]
    tolerance: _Value | None
    kernel: _Data | None
    like: _Data | None
    variable: _Value | None
    remove_form: _Value | None
    lambda_s: _Quantity | None
    lambda_c: _Quantity | None
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    report: _Name | None
    stream: _Value | None
    threads: _Value | None
    no_history: bool | None

class GenerateOptions(_DrawOptions, total=False):
    count: _Value | None
    first: _Value | None
    seed: _Value | None

class KernelOptions(_EachOptions, total=False):
    model: Literal["exponential", "gaussian", "matern", "stretched-exponential", "self-affine", "exponential-cosine", None]
    length: _Quantity | None
    length_level: _Value | None
    angle: _Quantity | None
    smoothness: _Value | None
    exponent: _Value | None
    hurst: _Value | None
    rolloff: _Quantity | None
    cutoff: _Quantity | None
    wavelength: _Quantity | None
    acf: _Data | None
    psd: _Data | None
    skewness: _Value | None
    kurtosis: _Value | None
    marginal: _Data | None
    lags: _Value | None
    acf_tolerance: _Value | None
    formulation: Literal["symmetric", "oriented", "patir", None]
    method: Literal["newton-krylov", "spectral", None]
    infeasible: Literal["auto", "error", "nearest", None]
    tolerance: _Value | None
    rq: _Quantity | None
    rms_slope: _Value | None
    spacing: _Quantity | None
    shape: _Value | None
    size: _Quantity | None
    periodic: bool | None
    report: _Name | None
    no_history: bool | None

class PdfOptions(_EachOptions, total=False):
    variable: _Value | None
    remove_form: _Value | None
    lambda_s: _Quantity | None
    lambda_c: _Quantity | None
    correlation: Literal["auto", "drawn", "estimate", None]
    estimate: Literal["histogram", "kernel", "quantiles", None]
    bins: _Value | None
    bandwidth: _Value | None
    rows: _Value | None
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    threads: _Value | None

class PlotOptions(_EachOptions, total=False):
    kind: Literal["map", "surface", "profile", "acf", "psd", "pdf", "qq", "abbott", "contact", "sweep", "von-mises", "section", "maxima", "features", None]
    variable: _Value | None
    section: _Value | None
    title: _Value | None
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    labels: _Value | None
    pruning: Literal["HEIGHT", "SHARE%", None]
    scale_bar: bool | None
    columns: _Value | None
    pixels: _Value | None
    to: Literal["png", "svg", "pdf", None]
    x_range: _Quantity | None
    y_range: _Quantity | None
    depth_range: _Quantity | None
    range: _Value | None
    scale_by: _Value | None
    above: _Quantity | None

class PsdOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    remove_form: _Value | None
    lambda_s: _Quantity | None
    lambda_c: _Quantity | None
    window: Literal["auto", "none", "hann", None]
    threads: _Value | None
    no_history: bool | None

class ReportOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    remove_form: _Value | None
    lambda_s: _Quantity | None
    lambda_c: _Quantity | None
    correlation: Literal["auto", "drawn", "estimate", None]
    title: _Value | None
    threads: _Value | None

class StatsOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    remove_form: _Value | None
    lambda_s: _Quantity | None
    lambda_c: _Quantity | None
    correlation: Literal["auto", "drawn", "estimate", None]
    parameters: _Value | None
    profile: Literal["x", "y", None]
    quantiles: _Value | None
    material_ratio: _Value | None
    pruning: Literal["HEIGHT", "SHARE%", None]
    sal_level: _Value | None
    errors: Literal["theory", "none", None]
    direction: _Quantity | None
    compare: bool | None
    threads: _Value | None

class StressOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    depths: _Quantity | None
    section: _Value | None
    maximum: bool | None
    of: Literal["von_mises", "max_shear", "principal", None]
    below: _Quantity | None
    add: _Value | None
    points: _Data | None
    components: _Value | None
    above: _Quantity | None
    resolution: Literal["adapted", "full", None]
    poisson: _Value | None
    body: _Value | None
    friction: _Value | None
    friction_angle: _Quantity | None
    report: _Name | None
    threads: _Value | None
    no_history: bool | None

class ValidateOptions(_EachOptions, total=False):
    from_: Literal["auto", "netcdf", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text", "gwyddion", None]
    channel: _Value | None
    from_order: Literal["xy", "yx", None]
    variable: _Value | None
    acf: _Data | None
    rq: _Quantity | None
    skewness: _Value | None
    kurtosis: _Value | None
    significance: _Value | None
    threads: _Value | None

@overload
def acf(dataset: _Surface, *, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> _Dataset:
    """Autocorrelation and correlation lengths of a surface."""
@overload
def acf(dataset: _Surfaces, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> _Dataset: ...
@overload
def acf(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> _Dataset: ...
@overload
def acf(*, files_from: _Data, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> _Dataset: ...
@overload
def acf(*, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> Stage[_Dataset]: ...
@overload
def acf(dataset: _Surface, *, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> pd.DataFrame: ...
@overload
def acf(dataset: _Surfaces, *others: _Surface | _Surfaces, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> pd.DataFrame: ...
@overload
def acf(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> pd.DataFrame: ...
@overload
def acf(*, files_from: _Data, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> pd.DataFrame: ...
@overload
def acf(*, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> Stage[pd.DataFrame]: ...

@overload
def contact(dataset: _Surface, **options: Unpack[ContactOptions]) -> _Dataset:
    """Press two rough bodies together."""
@overload
def contact(dataset: _Surfaces, *others: _Surface | _Surfaces, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(*, files_from: _Data, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(*, smooth: Literal[True], **options: Unpack[ContactOptions]) -> _Dataset: ...
@overload
def contact(**options: Unpack[ContactOptions]) -> Stage[_Dataset]: ...
@overload
def contact(dataset: _Surface, *, sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(dataset: _Surfaces, *others: _Surface | _Surfaces, sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(*, files_from: _Data, sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(*, smooth: Literal[True], sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
@overload
def contact(*, sweep: _Quantity, **options: Unpack[ContactOptions]) -> Stage[pd.DataFrame]: ...

@overload
def convert(dataset: _Surface, *, to: Literal["auto", "netcdf"] | None = ..., **options: Unpack[ConvertOptions]) -> _Dataset:
    """Import and export maps of other programs."""
@overload
def convert(*, to: Literal["auto", "netcdf"] | None = ..., **options: Unpack[ConvertOptions]) -> Stage[_Dataset]: ...
@overload
def convert(dataset: _Surface, *, to: Literal["vti", "vtr", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text"], **options: Unpack[ConvertOptions]) -> bytes: ...
@overload
def convert(*, to: Literal["vti", "vtr", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text"], **options: Unpack[ConvertOptions]) -> Stage[bytes]: ...

@overload
def filter(dataset: _Surface, **options: Unpack[FilterOptions]) -> _Dataset:
    """Level, filter, fill, cut and resample maps."""
@overload
def filter(dataset: _Surfaces, *others: _Surface | _Surfaces, **options: Unpack[FilterOptions]) -> _Dataset: ...
@overload
def filter(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[FilterOptions]) -> _Dataset: ...
@overload
def filter(*, files_from: _Data, **options: Unpack[FilterOptions]) -> _Dataset: ...
@overload
def filter(**options: Unpack[FilterOptions]) -> Stage[_Dataset]: ...

def generate(**options: Unpack[GenerateOptions]) -> _Dataset:
    """Draw random rough surfaces."""

def kernel(**options: Unpack[KernelOptions]) -> _Dataset:
    """Solve the autocorrelation equations for a kernel."""

@overload
def pdf(dataset: _Surface, **options: Unpack[PdfOptions]) -> pd.DataFrame:
    """Distribution of the heights of a surface."""
@overload
def pdf(dataset: _Surfaces, *others: _Surface | _Surfaces, **options: Unpack[PdfOptions]) -> pd.DataFrame: ...
@overload
def pdf(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[PdfOptions]) -> pd.DataFrame: ...
@overload
def pdf(*, files_from: _Data, **options: Unpack[PdfOptions]) -> pd.DataFrame: ...
@overload
def pdf(**options: Unpack[PdfOptions]) -> Stage[pd.DataFrame]: ...

@overload
def plot(dataset: _Surface, **options: Unpack[PlotOptions]) -> Document:
    """Figures of datasets, as png, svg or pdf."""
@overload
def plot(dataset: _Surfaces, *others: _Surface | _Surfaces, **options: Unpack[PlotOptions]) -> Document: ...
@overload
def plot(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[PlotOptions]) -> Document: ...
@overload
def plot(**options: Unpack[PlotOptions]) -> Stage[Document]: ...

@overload
def psd(dataset: _Surface, *, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> _Dataset:
    """Power spectral density of a surface."""
@overload
def psd(dataset: _Surfaces, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> _Dataset: ...
@overload
def psd(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> _Dataset: ...
@overload
def psd(*, files_from: _Data, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> _Dataset: ...
@overload
def psd(*, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> Stage[_Dataset]: ...
@overload
def psd(dataset: _Surface, *, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> pd.DataFrame: ...
@overload
def psd(dataset: _Surfaces, *others: _Surface | _Surfaces, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> pd.DataFrame: ...
@overload
def psd(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> pd.DataFrame: ...
@overload
def psd(*, files_from: _Data, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> pd.DataFrame: ...
@overload
def psd(*, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> Stage[pd.DataFrame]: ...

@overload
def report(dataset: _Surface, **options: Unpack[ReportOptions]) -> Document:
    """A dataset as one html page."""
@overload
def report(**options: Unpack[ReportOptions]) -> Stage[Document]: ...

@overload
def stats(dataset: _Surface, **options: Unpack[StatsOptions]) -> pd.DataFrame:
    """Surface and profile parameters with standard errors."""
@overload
def stats(dataset: _Surfaces, *others: _Surface | _Surfaces, **options: Unpack[StatsOptions]) -> pd.DataFrame: ...
@overload
def stats(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[StatsOptions]) -> pd.DataFrame: ...
@overload
def stats(*, files_from: _Data, **options: Unpack[StatsOptions]) -> pd.DataFrame: ...
@overload
def stats(**options: Unpack[StatsOptions]) -> Stage[pd.DataFrame]: ...

@overload
def stress(dataset: _Surface, *, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> _Dataset:
    """Stress below the surface of a contact."""
@overload
def stress(dataset: _Surfaces, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(*, files_from: _Data, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(*, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> Stage[_Dataset]: ...
@overload
def stress(dataset: _Surface, *, result: Literal["maxima"], **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(dataset: _Surfaces, *others: _Surface | _Surfaces, result: Literal["maxima"], **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["maxima"], **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(*, files_from: _Data, result: Literal["maxima"], **options: Unpack[StressOptions]) -> pd.DataFrame: ...
@overload
def stress(*, result: Literal["maxima"], **options: Unpack[StressOptions]) -> Stage[pd.DataFrame]: ...

@overload
def validate(dataset: _Surface, **options: Unpack[ValidateOptions]) -> pd.DataFrame:
    """Test whether surfaces have the prescribed properties."""
@overload
def validate(dataset: _Surfaces, *others: _Surface | _Surfaces, **options: Unpack[ValidateOptions]) -> pd.DataFrame: ...
@overload
def validate(dataset: _Surface, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[ValidateOptions]) -> pd.DataFrame: ...
@overload
def validate(*, files_from: _Data, **options: Unpack[ValidateOptions]) -> pd.DataFrame: ...
@overload
def validate(**options: Unpack[ValidateOptions]) -> Stage[pd.DataFrame]: ...

@type_check_only
class _Acf:
    variable: Result[str]
    surfaces: Result[float]
    taper: Result[str]
    marginal: Result[str]
    variance: Result[float]
    skewness: Result[float]
    kurtosis: Result[float]
    warnings: Result[str]
    def __getattr__(self, name: str) -> Result[Any]: ...
    @overload
    def __call__(self, *, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> _Dataset: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[AcfOptions]) -> _Dataset: ...
    @overload
    def __call__(self, *, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["profiles", "lengths"], **options: Unpack[AcfOptions]) -> pd.DataFrame: ...

@type_check_only
class _Contact:
    load: Result[float]
    mean_pressure: Result[float]
    approach: Result[float]
    max_pressure: Result[float]
    area: Result[float]
    area_corrected: Result[float]
    perimeter: Result[float]
    plastic_area: Result[float]
    mean_gap: Result[float]
    stiffness: Result[float]
    area_share: Result[float]
    reduced_pressure: Result[float]
    kappa: Result[float]
    reduced_gap: Result[float]
    sphere_roughness: Result[float]
    plasticity_index: Result[float]
    nayak_alpha: Result[float]
    rms_slope: Result[float]
    rms_height: Result[float]
    elastic_energy: Result[float]
    plastic_work: Result[float]
    dent: Result[float]
    plastic_volume: Result[float]
    max_plastic_strain: Result[float]
    dissipated_energy: Result[float]
    stored_energy: Result[float]
    patches: Result[float]
    largest_patch: Result[float]
    percolates_x: Result[bool]
    percolates_y: Result[bool]
    hertz_pressure: Result[float]
    hertz_radius_x: Result[float]
    hertz_radius_y: Result[float]
    hertz_half_width: Result[float]
    hertz_approach: Result[float]
    flattening_load: Result[Any]
    radius_x: Result[Any]
    radius_y: Result[Any]
    young: Result[Any]
    poisson: Result[Any]
    composite_modulus: Result[Any]
    boundary: Result[str]
    approach_datum: Result[Any]
    prescribed: Result[str]
    variable: Result[str]
    counter: Result[str]
    limit_pressure: Result[Any]
    plasticity: Result[str]
    yield: Result[Any]
    hardening: Result[str]
    layer_edges: Result[Any]
    increments: Result[float]
    increment_error: Result[float]
    evaluations: Result[float]
    plastic_residual: Result[float]
    tolerance: Result[Any]
    converged: Result[bool]
    residual: Result[float]
    stiffness_residual: Result[float]
    stiffness_converged: Result[bool]
    load_residual: Result[float]
    slope_growth: Result[float]
    accuracy: Result[Any]
    refinement: Result[float]
    grid_errors_seconds: Result[float]
    convolutions: Result[float]
    preconditionings: Result[float]
    levels: Result[float]
    setup_seconds: Result[float]
    seconds: Result[float]
    radius: Result[float]
    hertz_radius: Result[float]
    warnings: Result[str]
    @overload
    def __call__(self, **options: Unpack[ContactOptions]) -> _Dataset: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, *, sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, sweep: _Quantity, **options: Unpack[ContactOptions]) -> pd.DataFrame: ...

@type_check_only
class _Convert:
    @overload
    def __call__(self, *, to: Literal["auto", "netcdf"] | None = ..., **options: Unpack[ConvertOptions]) -> _Dataset: ...
    @overload
    def __call__(self, *, to: Literal["vti", "vtr", "gwyddion-text", "gsf", "gwy", "nrrd", "npy", "sdf", "sdf-ascii", "sur", "esri", "x3p", "text"], **options: Unpack[ConvertOptions]) -> bytes: ...

@type_check_only
class _Filter:
    form_degree: Result[Any]
    filled_share: Result[Any]
    warnings: Result[str]
    @overload
    def __call__(self, **options: Unpack[FilterOptions]) -> _Dataset: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[FilterOptions]) -> _Dataset: ...

@type_check_only
class _Generate:
    rms: Result[Any]
    exact_rq: Result[bool]
    seed: Result[Any]
    stream: Result[Any]
    surface: Result[Any]
    rng: Result[str]
    heights: Result[str]
    method: Result[str]
    skewness_expected: Result[float]
    kurtosis_expected: Result[float]
    acf_error_expected: Result[float]
    seconds: Result[float]
    warnings: Result[str]

@type_check_only
class _Kernel:
    target: Result[str]
    length: Result[Any]
    level: Result[Any]
    angle: Result[Any]
    smoothness: Result[Any]
    exponent: Result[Any]
    hurst: Result[Any]
    wavelength: Result[Any]
    cutoff: Result[Any]
    rolloff: Result[Any]
    rms: Result[Any]
    rms_slope: Result[Any]
    heights: Result[str]
    skewness: Result[Any]
    kurtosis: Result[Any]
    lags: Result[Any]
    period: Result[Any]
    corner: Result[Any]
    formulation: Result[str]
    method: Result[str]
    tolerance: Result[Any]
    acf_tolerance: Result[Any]
    converged: Result[bool]
    reason: Result[str]
    answer: Result[str]
    residual: Result[float]
    error: Result[float]
    change: Result[float]
    tail: Result[float]
    feasibility: Result[float]
    hermite_tail: Result[float]
    newton_iterations: Result[float]
    residuals: Result[float]
    jacobian_products: Result[float]
    solver: Result[str]
    seconds: Result[float]
    least_acf: Result[float]
    mirrored_error: Result[float]
    preconditionings: Result[float]
    warnings: Result[str]

@type_check_only
class _Pdf:
    @overload
    def __call__(self, **options: Unpack[PdfOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[PdfOptions]) -> pd.DataFrame: ...

@type_check_only
class _Plot:
    @overload
    def __call__(self, **options: Unpack[PlotOptions]) -> Document: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[PlotOptions]) -> Document: ...

@type_check_only
class _Psd:
    degrees_of_freedom: Result[float]
    relative_error: Result[float]
    variable: Result[str]
    surfaces: Result[float]
    window: Result[str]
    warnings: Result[str]
    @overload
    def __call__(self, *, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> _Dataset: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[PsdOptions]) -> _Dataset: ...
    @overload
    def __call__(self, *, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["profiles", "radial"], **options: Unpack[PsdOptions]) -> pd.DataFrame: ...

@type_check_only
class _Report:
    def __call__(self, **options: Unpack[ReportOptions]) -> Document: ...

@type_check_only
class _Stats:
    @overload
    def __call__(self, **options: Unpack[StatsOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[StatsOptions]) -> pd.DataFrame: ...

@type_check_only
class _Stress:
    max_von_mises: Result[float]
    max_shear: Result[float]
    max_principal: Result[float]
    max_x: Result[float]
    max_y: Result[float]
    max_depth: Result[float]
    max_below: Result[Any]
    poisson: Result[Any]
    friction: Result[Any]
    friction_angle: Result[Any]
    resolution: Result[str]
    above: Result[Any]
    section_x: Result[Any]
    section_y: Result[Any]
    accurate_depth: Result[float]
    seconds: Result[float]
    warnings: Result[str]
    @overload
    def __call__(self, *, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> _Dataset: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["dataset"] | None = ..., **options: Unpack[StressOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, *, result: Literal["maxima"], **options: Unpack[StressOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, result: Literal["maxima"], **options: Unpack[StressOptions]) -> pd.DataFrame: ...

@type_check_only
class _Validate:
    @overload
    def __call__(self, **options: Unpack[ValidateOptions]) -> pd.DataFrame: ...
    @overload
    def __call__(self, other: _Surface | _Surfaces, /, *others: _Surface | _Surfaces, **options: Unpack[ValidateOptions]) -> pd.DataFrame: ...

@type_check_only
class _Accessor:
    acf: _Acf
    contact: _Contact
    convert: _Convert
    filter: _Filter
    generate: _Generate
    kernel: _Kernel
    pdf: _Pdf
    plot: _Plot
    psd: _Psd
    report: _Report
    stats: _Stats
    stress: _Stress
    validate: _Validate
