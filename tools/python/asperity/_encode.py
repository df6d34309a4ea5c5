"""A dataset as a stream of NetCDF bytes.

Missing values of floating-point variables are NaN in a dataset, and `_FillValue` in the stream if the variable's
`encoding` has one. Coordinates besides those of dimensions are named in the attribute `coordinates`, as xarray
does it. Text is UTF-8. Types that CDF-2 lacks, and variables above 4 GiB besides the last, make it CDF-5.

Cost      values are turned to the stream's order of bytes a mebibyte at a time: no copy of the data is made.
"""
import re
import struct
import warnings

import numpy as np

from ._types import OF_CDF5, number_of
from .errors import ToolWarning, brief

PIECE = 1 << 20  # bytes
NAME = re.compile(r"[A-Za-z0-9_\x80-\ud7ff\ue000-\U0010ffff][^\x00-\x1f/\x7f\ud800-\udfff]*")
LONGEST_NAME = 256  # bytes


# ---- variables and attributes in types of the format ----


def _plain(name, variable):
    """The values of a variable, and its attributes."""
    values = np.asarray(variable.data)
    if values.dtype.kind in "mM":
        import xarray
        return _plain(name, xarray.conventions.encode_cf_variable(variable, name=name))
    if values.dtype.kind in "US" or values.dtype == object and all(isinstance(v, str) for v in values.ravel()):
        return _characters(values), dict(variable.attrs)
    if values.dtype.kind == "b":
        values = values.view("i1")
    elif values.dtype in (np.float16, np.longdouble):
        values = values.astype("f4" if values.dtype == np.float16 else "f8")
    if number_of(values) is None:
        raise TypeError(f"the variable {name!r} is of {values.dtype}, for which NetCDF has no type")
    return values, _with_fill(values, variable)


def _characters(values):
    """Text, with one dimension more."""
    flat = [v if isinstance(v, bytes) else str(v).encode() for v in values.ravel()]
    width = max([1, *map(len, flat)])
    return np.array(flat, f"S{width}").view("S1").reshape((*values.shape, width))


def _with_fill(values, variable):
    attributes = dict(variable.attrs)
    fill = variable.encoding.get("_FillValue") if values.dtype.kind == "f" else None
    if fill is not None and not np.isnan(fill):
        attributes["_FillValue"] = values.dtype.type(fill)
    return attributes


def _attributes(of, attributes):
    out = {str(name): _attribute_values(value) if _is_name(str(name)) else None for name, value in attributes.items()}
    if left := [name if _is_name(name) else brief(name) for name, values in out.items() if values is None]:
        warnings.warn(f"{of}: attributes that are neither text nor numbers, or whose names NetCDF does not hold, are "
                      f"left out: {', '.join(left)}", ToolWarning, stacklevel=2)
    return [(name, values) for name, values in out.items() if values is not None]


def _is_name(text):
    """As the format defines names, and the tools check them."""
    return (NAME.fullmatch(text) is not None and not text.endswith(" ")
            and len(text.encode()) <= LONGEST_NAME)


def _attribute_values(value):
    """Bytes of text, or an array of one dimension; None of what NetCDF does not hold."""
    if isinstance(value, (str, bytes)):
        return value.encode() if isinstance(value, str) else value
    out = np.atleast_1d(np.asarray(value))
    if out.dtype.kind == "b":
        out = out.astype("i1")
    if out.dtype.kind in "iu" and number_of(out) in OF_CDF5:
        out = out.astype("i4" if (np.abs(out.astype("f8")) < 2**31).all() else "f8")
    return out if out.ndim == 1 and out.size > 0 and number_of(out) else None


# ---- the bytes ----


class _Header:
    """The bytes before the values; `wide` is CDF-5."""

    def __init__(self, wide):
        self.wide, self.bytes = wide, bytearray(b"CDF\5" if wide else b"CDF\2")
        self.count(0)  # records

    def int(self, number):
        self.bytes += struct.pack(">i", number)

    def count(self, number):
        self.bytes += struct.pack(">q" if self.wide else ">I", min(number, 2**63 - 1 if self.wide else 2**32 - 1))

    def place(self, number):
        self.bytes += struct.pack(">q", number)

    def text(self, text):
        self.count(len(text))
        self.bytes += text + bytes(-len(text) % 4)

    def list(self, tag, items, write):
        self.int(tag if items else 0)
        self.count(len(items))
        for item in items:
            write(item)

    def attribute(self, item):
        name, values = item
        self.text(name.encode())
        self.int(2 if isinstance(values, bytes) else number_of(values))
        if isinstance(values, bytes):
            return self.text(values)
        self.count(values.size)
        raw = values.astype(values.dtype.newbyteorder(">")).tobytes()
        self.bytes += raw + bytes(-len(raw) % 4)


def _padded(array):
    return array.nbytes + -array.nbytes % 4


def _header(sizes, attributes, variables, wide, begin):
    """With values from place `begin` on."""
    out, names = _Header(wide), list(sizes)
    out.list(10, names, lambda name: (out.text(name.encode()), out.count(sizes[name])))
    out.list(12, attributes, out.attribute)

    def variable(item):
        nonlocal begin
        name, dimensions, own, array = item
        out.text(name.encode())
        out.count(len(dimensions))
        for dimension in dimensions:
            out.count(names.index(dimension))
        out.list(12, own, out.attribute)
        out.int(number_of(array))
        out.count(_padded(array))
        out.place(begin)
        begin += _padded(array)
    out.list(11, variables, variable)
    return out.bytes


def _variables(dataset):
    """Name, dimensions, attributes and values of each, and the sizes of all dimensions."""
    sizes, out = {str(name): size for name, size in dataset.sizes.items()}, []
    for name, variable in dataset.variables.items():
        array, attributes = _plain(name, variable)
        dimensions = [str(d) for d in variable.dims]
        if array.ndim > len(dimensions):  # text
            dimensions.append(f"string{array.shape[-1]}")
            sizes[dimensions[-1]] = array.shape[-1]
        out.append((str(name), dimensions, _attributes(name, attributes), array))
    return out, sizes


def encoded(dataset):
    """The pieces of the bytes of an xarray.Dataset, which must not change before the last is taken."""
    for axis, other in ("xy", "yx"):
        dataset = _with_cells(dataset, axis, other)
    variables, sizes = _variables(dataset)
    attributes = dict(dataset.attrs)
    others = [str(c) for c in dataset.coords if c not in dataset.dims and " " not in str(c)]
    if others:
        attributes["coordinates"] = " ".join(others)
    attributes = _attributes("the dataset", attributes)
    wide = any(number_of(v[3]) in OF_CDF5 for v in variables) or any(n >= 2**31 for n in sizes.values())
    wide |= any(_padded(v[3]) > 2**32 - 4 for v in variables[:-1])
    begin = len(_header(sizes, attributes, variables, wide, 0))
    return _pieces(_header(sizes, attributes, variables, wide, begin), variables)


def _with_cells(dataset, axis, other):
    """Of a profile that was cut from a surface, as by isel(y=5): a row of cells, as wide as the surface's were."""
    points = dataset.variables.get(axis)
    low, high = points.attrs.get("actual_range", (0, 0)) if points is not None else (0, 0)
    width = points.attrs.get("length", 0) - (high - low) if points is not None else 0  # of n points, n - 1 steps
    if width <= 0 or low == high or points.size != 1:
        return dataset
    out = dataset.drop_vars(axis)
    for name, one in dataset.variables.items():
        if other in one.dims and axis not in one.dims and name != other:
            at = one.dims.index(other)
            out[name] = one.set_dims([*one.dims[:at], "x", "y", *one.dims[at + 1:]])
    attributes = {**points.attrs, "length": width, "actual_range": 2 * [float(points.values.item())], "periodic": 0}
    return out.assign_coords({axis: (axis, points.values.reshape(1), attributes)})


def _pieces(head, variables):
    yield head
    for _, _, attributes, array in variables:
        fill = next((v[0] for k, v in attributes if k == "_FillValue" and array.dtype.kind == "f"), None)
        step = PIECE // array.itemsize
        flat = array.reshape(-1) if array.flags.c_contiguous else array.flat
        for at in range(0, array.size, step):
            values = flat[at:at + step]
            if fill is not None:
                values = np.where(np.isnan(values), fill, values)
            yield memoryview(values.astype(values.dtype.newbyteorder(">")).view("u1"))
        yield bytes(-array.nbytes % 4)
