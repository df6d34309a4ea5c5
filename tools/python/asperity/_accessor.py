"""`surface.asp`: the tools as methods of a dataset or a field of xarray, and the results that they left in it.

    surface.asp.stats()                is asperity.stats(surface)
    pressed.asp.contact.area           Result(value=2.71e-06, error=1.1e-08, unit='m2', meaning='real contact area')
    pressed.asp.contact                prints all of them, pressed.asp those of all tools

A result is an attribute of the dataset, pressed.contact_area, with the error that stands beside it, contact_area_error,
and the unit and meaning that the tool tells of it (--describe).
"""
import fnmatch
import math
import sys
import typing

from . import _calls, _options

T = typing.TypeVar("T")


class Result(typing.NamedTuple, typing.Generic[T]):
    """A number in its SI unit with its error (NaN: not known); a text, or True and False, without a unit."""

    value: T
    error: float
    unit: str
    meaning: str

    def __float__(self) -> float:
        return float(self.value)

    def __str__(self) -> str:
        """Rounded to two digits of the error, with the unit."""
        text = f"{self.value:.6g}" if isinstance(self.value, float) else str(self.value)
        if _is_size(self.value) and _is_size(self.error):
            digits = 2 + max(-1, math.floor(math.log10(abs(self.value))) - math.floor(math.log10(self.error)))
            text = f"{self.value:.{digits}g} ± {self.error:.2g}"
        return f"{text} {self.unit}" if self.unit not in ("", "1") else text


def _is_size(value):
    return isinstance(value, (int, float)) and 0 < abs(value) < math.inf


class Accessor:
    """The tools as methods."""

    def __init__(self, data):
        self._data = data

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return Tool(self._data, name)

    def __dir__(self):
        return [_options.python_name(name) for name in _options.names()]

    def __repr__(self):
        tools = [getattr(self, name) for name in dir(self)]
        return "\n".join(repr(tool) for tool in tools if dir(tool)) or "<asperity: no results>"


class Tool:
    """A tool for one dataset: called, it runs; its attributes are the results that it left there."""

    def __init__(self, data, name):
        self._data, self._function = data, _calls.function(name)
        self._name, self.__doc__ = self._function.__name__.rstrip("_"), self._function.__doc__
        signature = self._function.__signature__
        self.__signature__ = signature.replace(parameters=[p for p in signature.parameters.values() if p.name != "dataset"])

    def __call__(self, *others, **options):
        return self._function(self._data, *others, **options)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        found = self._results()
        if name not in found:
            hint = _options.near(name, found) or ("" if found else ": the tool has left none there")
            raise AttributeError(f"the {type(self._data).__name__} has no result {self._name}_{name}{hint}")
        return found[name]

    def __dir__(self):
        return list(self._results())

    def __repr__(self):
        found = self._results()
        names = max(map(len, found), default=0)
        rows = [f"{name:{names}}  {result.meaning}: {' '.join(str(result).split())}" for name, result in found.items()]
        return "\n".join([f"<asperity.{self._name}: {len(found)} results>", *rows])

    def _results(self):
        """By their names, in the order of the attributes."""
        out, rows, attributes = {}, _options.table(self._name.replace("_", "-"))["results"], self._data.attrs
        for name, value in attributes.items():
            row = next((row for row in rows if fnmatch.fnmatchcase(name, row["name"])), None)
            if row and name.removesuffix("_error") not in attributes.keys() - {name}:
                own = _options.python_name(name.removeprefix(self._name + "_"))
                out[own] = _result(row, value, attributes.get(name + "_error", math.nan))
        return out


def _result(row, value, error):
    if row["unit"] == "yes":
        return Result(bool(value), math.nan, "", row["text"])
    return Result(_plain(value), _plain(error), row["unit"], row["text"])


def _plain(value):
    return value.item() if getattr(value, "ndim", None) == 0 else value


# ---- with xarray, whenever it is imported: that takes half a second, and a call between files needs none of it ----


class _Import:
    """A finder of modules that asks the others, also for one who only wants to know whether xarray is there."""

    def find_spec(self, name, path, target=None):
        if name != "xarray":
            return None
        found = (finder.find_spec(name, path, target) for finder in sys.meta_path if finder is not self)
        spec = next(filter(None, found), None)
        if spec:
            load = spec.loader.exec_module
            spec.loader.exec_module = lambda module: (load(module), sys.meta_path.remove(self), _register(module))
        return spec


def _register(xarray):
    xarray.register_dataset_accessor("asp")(Accessor)
    xarray.register_dataarray_accessor("asp")(Accessor)


def register():
    if "xarray" in sys.modules:
        _register(sys.modules["xarray"])
    else:
        sys.meta_path.insert(0, _Import())
