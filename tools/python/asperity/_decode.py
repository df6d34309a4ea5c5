"""A dataset from a stream of NetCDF bytes.

Scope     the classic formats with fixed dimensions, as the tools write them; records are refused.
Cost      one copy: values are read into their own arrays, and turned to the machine's order of bytes in place.
"""
import struct

import numpy as np

from ._types import DTYPES


class Short(Exception):
    """The bytes end before the header does."""


class _Head:
    """Reads a header; raises Short where more bytes are needed."""

    def __init__(self, held):
        self.held, self.at = held, 4
        if held[3] not in (1, 2, 5):
            raise ValueError("the bytes are no classic NetCDF")
        self.wide, self.place = held[3] == 5, "i" if held[3] == 1 else "q"

    def take(self, length):
        begin = self.at
        self.at += length + -length % 4
        if self.at > len(self.held):
            raise Short
        return bytes(self.held[begin:begin + length])

    def number(self, kind):
        return struct.unpack(">" + kind, self.take(struct.calcsize(kind)))[0]

    def count(self):
        return self.number("q" if self.wide else "I")

    def text(self):
        return _text(self.take(self.count()))

    def list(self, read):
        self.number("i")
        return [read() for _ in range(self.count())]

    def attribute(self):
        name, dtype = self.text(), np.dtype(DTYPES[self.number("i")])
        raw = self.take(self.count() * dtype.itemsize)
        if dtype.kind == "S":
            return name, _text(raw)
        values = np.frombuffer(raw, dtype).astype(dtype.newbyteorder("="))
        return name, values[0] if values.size == 1 else values

    def variable(self):
        name, dimensions = self.text(), [self.count() for _ in range(self.count())]
        attributes, dtype = dict(self.list(self.attribute)), np.dtype(DTYPES[self.number("i")])
        self.count()  # its size, which the dimensions tell
        return name, dimensions, attributes, dtype, self.number(self.place)

    def all(self):
        if self.count() != 0:
            raise ValueError("the dataset has records")
        dimensions = self.list(lambda: (self.text(), self.count()))
        return dimensions, dict(self.list(self.attribute)), self.list(self.variable)


def _text(raw):
    try:
        return raw.decode()
    except UnicodeDecodeError:
        return raw.decode("latin-1")


# ---- the stream ----


def decoder(first):
    """A generator, begun with the first bytes: it yields a memoryview to be filled and is sent how many bytes were,
    0 if there are no more. It returns the dataset. Throws EOFError and ValueError."""
    held = bytearray(first)
    while True:
        try:
            head = _Head(held)
            dimensions, attributes, variables = head.all()
            break
        except Short:
            piece = memoryview(bytearray(1 << 16))
            held += piece[:(yield from _some(piece))]
    at, arrays = head.at, {}
    for name, of, _, dtype, begin in sorted(variables, key=lambda v: v[4]):
        array = arrays[name] = np.empty([dimensions[d][1] for d in of], dtype)
        if begin < at:
            raise ValueError("a variable begins within another one")
        at = yield from _fill(memoryview(bytearray(begin - at)), held, at)
        at = yield from _fill(memoryview(array.reshape(-1).view("u1")), held, at)
    yield from _fill(memoryview(bytearray(-at % 4)), held, at)
    if at + -at % 4 < len(held):
        raise ValueError("bytes follow the dataset")
    return _dataset(dimensions, attributes, variables, arrays)


def _some(view):
    count = yield view
    if count == 0:
        raise EOFError("the dataset is cut short")
    return count


def _fill(target, held, at):
    """With the bytes from place `at` on: those that are held, then those that come. The place behind them."""
    done = min(max(len(held) - at, 0), len(target))
    target[:done] = held[at:at + done]
    while done < len(target):
        done += yield from _some(target[done:])
    return at + len(target)


# ---- xarray's form ----


def _dataset(dimensions, attributes, variables, arrays):
    import xarray
    names, out = [name for name, _ in dimensions], {}
    others = [c for c in str(attributes.pop("coordinates", "")).split() if c in arrays]
    for name, of, own, dtype, _ in variables:
        array, of, encoding = arrays[name], [names[d] for d in of], {}
        if dtype.kind == "S":
            array, of = _strings(array), of[:-1]
        elif not dtype.isnative:
            array = array.byteswap(inplace=True).view(dtype.newbyteorder("="))
        if dtype.kind == "f" and "_FillValue" in own:
            encoding["_FillValue"] = own.pop("_FillValue")
            array[array == encoding["_FillValue"]] = np.nan
        out[name] = xarray.Variable(of, array, own, encoding)
        if " since " in str(own.get("units", "")):
            out[name] = xarray.conventions.decode_cf_variable(name, out[name])
    own_dimensions = [name for name, v in out.items() if v.dims == (name,)]
    coords = {name: out.pop(name) for name in [*own_dimensions, *others] if name in out}
    return xarray.Dataset(out, coords, attributes)


def _strings(array):
    if array.ndim == 0:
        return np.array(_text(array.tobytes()), object)
    rows = [_text(row.tobytes().rstrip(b"\0")) for row in array.reshape(-1, array.shape[-1])]
    return np.array(rows, object).reshape(array.shape[:-1])
