"""What may stand where a tool reads a file: a name, a dataset, a field of one, a table, bytes.

An object can only be of a library that is in use: none is imported here to find out.
"""
import collections.abc
import os
import sys

from .errors import brief


class Source:
    """Data that a tool reads as a file: its bytes are the pieces of encode(value), `name` is what messages call it."""

    def __init__(self, name, encode, value):
        self.name, self.encode, self.value = name, encode, value

    def pieces(self):
        return self.encode(self.value)

    def __repr__(self):
        return f"<{self.name}>"


class Si:
    """Numbers in SI; no text, which has its own unit."""

    def __init__(self, value):
        if is_name(value):
            raise TypeError(f"asperity.si({value!r}): a text has its own unit, and stands alone")
        self.value = value

    def __repr__(self):
        return f"asperity.si({self.value!r})"


def _is(value, library, *types):
    module = sys.modules.get(library)
    return module is not None and isinstance(value, tuple(getattr(module, name) for name in types))


def is_truth(value):
    return isinstance(value, bool) or _is(value, "numpy", "bool_")


def is_name(value):
    return isinstance(value, (str, os.PathLike))


def with_unit(number, unit):
    """A quantity; behind a blank, a number of the unit's own is none of the first's digits, and the tool refuses it."""
    return number + ("" if unit[:1].isalpha() or not unit else " ") + unit


def field_of(value):
    """The name of the field that a DataArray is, else None."""
    return value.name or "heights" if _is(value, "xarray", "DataArray") else None


def source(value, name):
    """Of anything but the name of a file."""
    if _is(value, "xarray", "DataArray"):
        value = value.to_dataset(name=value.name or "heights")
    if _is(value, "xarray", "Dataset"):
        return Source(name, _encoded, value)
    if isinstance(value, (bytes, bytearray, memoryview)):
        return Source(name, _whole, value)
    if _is(value, "pandas", "DataFrame") or isinstance(value, collections.abc.Mapping):
        return Source(name, _text_of_columns, value)
    if _is(value, "numpy", "ndarray") and value.ndim == 2:
        return Source(name, _text_of_rows, value)
    raise TypeError(f"{name}={brief(value)}: the name of a file, a Dataset, a DataArray, a table, bytes or an "
                    "open file are needed")


def contents(value):
    """Of an open file, which can be read once; any other value as it is."""
    read = value.read() if hasattr(value, "read") else value
    return read.encode() if read is not value and isinstance(read, str) else read


def _whole(data):
    return [data]


def _encoded(dataset):
    from . import _encode  # and numpy, which costs a tenth of a second
    return _encode.encoded(dataset)


def _text_of_columns(columns):
    """A table as the tools print it, of a DataFrame, or of a dictionary {'x [um]': [0, 1], …}."""
    if _is(columns, "pandas", "DataFrame"):
        units = columns.attrs.get("units", {})
        flat = columns.reset_index() if columns.index.name else columns
        columns = {f"{n} [{units[n]}]" if units.get(n) else str(n): flat[n] for n in flat.columns}
    return _text_of_rows(zip(*map(list, columns.values())), "# " + "\t".join(columns) + "\n")


def _text_of_rows(rows, head=""):
    lines = ("\t".join(v if isinstance(v, str) else repr(float(v)) for v in row) for row in rows)
    return [(head + "".join(f"{line}\n" for line in lines)).encode()]


def inputs(given):
    """The surfaces of a call, with a name for each: lists, dictionaries and datasets of them are taken apart."""
    out = []
    for at, value in enumerate(map(contents, given)):
        if _is(value, "numpy", "ndarray"):
            raise TypeError("an array has no size: asperity.dataset(heights, size='3mm') makes a surface of it")
        if isinstance(value, collections.abc.Mapping) and not _is(value, "xarray", "Dataset"):
            out += [(str(key), one) for key, one in value.items()]
        elif isinstance(value, (list, tuple, collections.abc.Iterator)):
            out += [(f"datasets[{k}]", contents(one)) for k, one in enumerate(value)]
        elif other := _dimension_of_surfaces(value):
            out += [(f"{other}={label}", _part(value, other, k)) for k, label in enumerate(value[other].values)]
        else:
            out.append((f"datasets[{at}]" if len(given) > 1 else "dataset", value))
    return out


def _dimension_of_surfaces(value):
    """The name of the one dimension besides x, y and z over which a dataset or a field holds surfaces, else None."""
    field = value.get("heights") if _is(value, "xarray", "Dataset") else value
    if not _is(field, "xarray", "DataArray") or not {"x", "y"} <= set(field.dims):
        return None
    others = set(field.dims) - {"x", "y", "z"}
    return others.pop() if len(others) == 1 else None


def _part(value, dimension, number):
    """One of the surfaces, without actual_range, which is that of the first since they were put together."""
    out = value.isel({dimension: number})
    for field in out.data_vars.values() if _is(out, "xarray", "Dataset") else [out]:
        field.attrs.pop("actual_range", None)
    return out
