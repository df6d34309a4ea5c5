"""The functions: one for each tool, and those that put tools together."""
import functools
import typing

from . import _data, _options
from ._stage import Stage, run_pipe
from .errors import ToolError, brief


def function(name, waits=False):
    """The function of a tool; `waits`: one that returns a stage in any case."""
    module = "asperity.stage" if waits else "asperity"
    if name.startswith("_"):
        raise AttributeError(f"module {module!r} has no attribute {name!r}")
    try:
        return _made(name, module, *_options.state(name.rstrip("_").replace("_", "-")))
    except ToolError as error:
        known = map(_options.python_name, _options.names()) if error.status == 127 else ()
        hint = _options.near(name, known) or f": {error}"
        raise AttributeError(f"module {module!r} has no function {name!r}{hint}") from None


@functools.lru_cache(maxsize=None)
def _made(name, module, tool, *state):
    """Once for each state of the program: pickle asks whether a name is the same function."""
    about, waits = _options.table_of(tool, *state), module == "asperity.stage"

    def call(*datasets, **options):
        if "dataset" in options and not datasets:
            datasets = (options.pop("dataset"),)
        out = Stage(tool, options, [one for one in datasets if one is not None])
        return out if waits or out.waits else run_pipe([out])
    call.__name__ = call.__qualname__ = name
    call.__module__, call.__doc__ = module, _options.docstring(about)
    call.__signature__ = _options.signature(about)
    return call


def options_type(name):
    """The options of a tool as a type, for annotations: asperity.ContactOptions."""
    parameters = function(name.removesuffix("Options").lower()).__signature__.parameters.values()
    return typing.TypedDict(name, {p.name: typing.Any for p in parameters if p.kind == p.KEYWORD_ONLY}, total=False)


def pipe(*stages):
    """Runs stages as one pipe of processes, where each reads what the one before it writes. Returns what the last
    one writes.

    >>> asperity.pipe(surface, asperity.contact(...), asperity.stress(maximum=True))
    >>> asperity.pipe(asperity.stage.generate(...), asperity.contact(...), asperity.stress(maximum=True))

    A tool that is called without its dataset is a stage. In front may also be a dataset, or the name of a file.

    asperity.generate(...) needs no dataset and therefore runs when it is called: as the first argument it has drawn
    its surface before the pipe begins, and the pipe is fed with it. asperity.stage.generate(...) leaves the drawing
    to the pipe, and nothing is read in between; the numbers are the same. A result that is computed only when it is
    used would spare this word. But a process can be read only once, and a surface is used more often than that.
    """
    if not stages or len(stages) == 1 and not isinstance(stages[0], Stage):
        raise TypeError("a pipe needs stages: asperity.pipe(surface, asperity.contact(...))")
    first, *others = stages
    for later in others:
        if not isinstance(later, Stage) or later.surfaces:
            raise TypeError(f"{brief(later)} is no stage: later arguments are tools without a dataset")
    if not isinstance(first, Stage):
        first, *others = Stage(others[0].name, others[0].options, [first]), *others[1:]
    if first.waits:
        raise TypeError(f"{first.tool} has no dataset: give one in front of it, or a stage that makes one")
    return run_pipe([first, *others])


def dataset(heights, size=None, unit="m", periodic=False):
    """A surface of an array of heights, as a Dataset for any tool; asperity-convert makes it.

    heights     two-dimensional, x first; masked points and NaN are missing. Of a DataArray, dimensions x and y are
                put in this order, and its coordinates and units are used
    size        side lengths: "3mm", "3mm,2mm", asperity.si((3e-3, 2e-3)). Of n points the length is n spacings
    unit        of the heights: "um"
    periodic    whether the surface continues at its opposite edge: True, "x" or "y"
    """
    from . import _arrays
    return _arrays.dataset(heights, size, unit, periodic)


def si(value):
    """A number, or several, in the SI unit that help() gives of an option: rq=asperity.si(4e-7) is rq="0.4um"."""
    return _data.Si(value)


def ensemble(*stages, count, first=0, seed=None, processes=None, **options):
    """Yields the results for `count` surfaces, in order and as they come.

    >>> for surface in asperity.ensemble(shape=(256, 256), size="1mm", rq="0.4um", length="20um", count=100): ...
    >>> for pressed in asperity.ensemble(asperity.stage.generate(...), asperity.contact(...), count=100): ...

    options     those of asperity.generate, in place of stages
    first       number of the first surface; surface k of a seed is the same in every ensemble
    seed        of all; without it a random one
    processes   pipes that run at a time; by default as many as there are processors. Each tool then has one thread,
                unless its option threads says otherwise. The numbers do not depend on it

    A kernel that takes long is solved once: kernel=asperity.kernel(...).
    """
    from . import _ensemble, stage
    if stages and options:
        raise TypeError(f"{', '.join(options)}: beside stages, options belong to the first of them")
    return _ensemble.members(stages or (stage.generate(**options),), count, first, seed, processes)
