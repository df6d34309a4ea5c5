"""Asperity's tools as functions: random rough surfaces drawn, measured, pressed together, stressed.

    import asperity as asp
    surface = asp.generate(shape=(512, 512), size="3mm", rq="0.4um", length="17px,4px", seed=7)
    pressed = asp.contact(surface, radius="50mm", young="208GPa", poisson=0.3, load="5kN", yield_="1.2GPa")
    asp.stats(surface).loc["Sq", ["value", "low_95", "high_95"]]

There is a function for each tool asperity-NAME of the wheel, or on PATH. Its name, signature and documentation come from the
tool itself (--describe): help(asperity.contact). Every call runs the tool, so the numbers are the shell's to the
last bit. Data passes through pipes in memory.

Options   as in the shell, with _ for - and behind a keyword: yield_, from_. A quantity is text with its unit,
          "3mm", si(3e-3), a number in SI, or a quantity of pint. A flag is True. Tuples, lists and arrays are A,B, of counts
          AxB. A list repeats an option that may come again. The steps of filter come in the order as written.
Files     where a tool reads one: a file's name, an xarray.Dataset or DataArray, a table, bytes, an open file.
Surfaces  come first; where a tool takes several, also a list of them, a dictionary that names them, or a dataset in which
          they lie along a further dimension.
Methods   surface.asp.stats() is asperity.stats(surface), pressed.asp.contact.area a result with error, unit and meaning.
Results   an xarray.Dataset, in which missing points are NaN; a pandas.DataFrame (a dict where pandas is missing)
          with units in attrs["units"]; a Document, which a notebook shows; else bytes. With output="FILE" the
          tool writes the file, and None is returned.
Errors    ToolError and its kinds UsageError, BadData, NoFile and NotConverged, which has the dataset. Warnings are
          ToolWarning. Notes go to the logger "asperity". An exit status from 5 on is an answer, not an error:
          asperity.validate returns its table.
"""
from . import _accessor, stage
from ._accessor import Result
from ._calls import Stage, dataset, ensemble, pipe, si
from .errors import BadData, NoFile, NotConverged, ToolError, ToolWarning, UsageError

__version__ = "0.2.0"
__all__ = ["BadData", "NoFile", "NotConverged", "Result", "Stage", "ToolError", "ToolWarning", "UsageError", "dataset",
           "ensemble", "pipe", "si", "stage"]

_accessor.register()


def __getattr__(name):
    from . import _calls
    return _calls.options_type(name) if name.endswith("Options") else _calls.function(name)


def __dir__():
    from . import _options
    return sorted([*__all__, "__version__", *(_options.python_name(name) for name in _options.names())])
