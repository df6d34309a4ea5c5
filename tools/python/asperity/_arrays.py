"""Heights in an array, of which asperity-convert makes a surface."""
import io

import numpy as np

from . import _data
from ._stage import Stage, run_pipe

KNOWN = {np.dtype(name) for name in "f4 f8 i1 i2 i4 i8 u1 u2 u4 u8".split()}


def dataset(heights, size, unit, periodic):
    if hasattr(heights, "data_vars"):
        raise TypeError("a Dataset is a surface already; of its values give one field: dataset['name']")
    heights, size, unit = _of_dataarray(heights, size, unit)
    array = _plain(heights)
    if size is None:
        raise TypeError("size is missing: the side lengths of the surface, '3mm' or '3mm,2mm'")
    if periodic not in (True, False, "x", "y"):
        raise ValueError(f"periodic={periodic!r}: True, False, 'x' or 'y'")
    convert = Stage("convert", {"from_": "npy", "size": size, "unit": unit})
    out = run_pipe([convert], _data.Source("heights", _npy, array))
    for axis in "xy":
        if periodic == axis if isinstance(periodic, str) else periodic:
            out[axis].attrs["periodic"] = np.int32(1)
    return out


def _plain(heights):
    """A contiguous array of two dimensions and of a type that the tool knows; missing points are NaN."""
    if isinstance(heights, np.ma.MaskedArray):
        heights = heights.astype(heights.dtype if heights.dtype.kind == "f" else "f8").filled(np.nan)
    array = np.asarray(heights)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"heights of {array.dtype} are no real numbers")
    if array.ndim != 2 or array.size == 0:
        raise ValueError(f"heights of shape {array.shape}: two dimensions are needed, x first, with points")
    known = array.dtype.newbyteorder("=") in KNOWN
    return np.ascontiguousarray(array if known else array.astype("f8"))


def _of_dataarray(heights, size, unit):
    """A DataArray's values with x first, and what its coordinates and attributes tell."""
    if not hasattr(heights, "dims") or not hasattr(heights, "coords"):
        return heights, size, unit
    if set(heights.dims) == {"x", "y"}:
        heights = heights.transpose("x", "y")
    if size is None and all(d in heights.coords and heights.sizes[d] > 1 for d in heights.dims):
        size = ",".join(_length(heights.coords[d]) for d in heights.dims)
    return heights.values, size, heights.attrs.get("units", unit)


def _length(points):
    """Of n points n spacings: the coordinates are the middles of cells."""
    steps = np.diff(points.values.astype(float))
    if not np.allclose(steps, steps[0], rtol=1e-6, atol=0):
        raise ValueError(f"the coordinate {points.name!r} is not evenly spaced")
    return _data.with_unit(repr(abs(float(steps.mean())) * len(points)), points.attrs.get("units", "m"))


def _npy(array):
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, np.lib.format.header_data_from_array_1_0(array))
    yield head.getvalue()
    yield memoryview(array.reshape(-1).view("u1"))
