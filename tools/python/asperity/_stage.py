"""A tool with its options, and several in a pipe."""
import os

from . import _data, _options
from ._run import Run


class Stage:
    """A tool with its options that waits for a dataset: a part of a pipe, or to be called with one.

    >>> press = asperity.contact(radius="50mm", young="208GPa", poisson=0.3, load="5kN")
    >>> pressed = press(surface)
    """

    def __init__(self, name, options, given=()):
        about = _options.table(name)
        self.name, self.tool, self.path = name, about["tool"], _options.program(name)
        self.options = {option: _data.contents(value) for option, value in options.items()}
        self.surfaces, self.words = _data.inputs(given), _options.words(about, self.options)
        self.prints_steps = bool(options.get("verbose") or options.get("time"))
        self.prints_tables = any(o["name"] == "json" for o in about["options"])
        if given and not self.surfaces:
            raise TypeError(f"{self.tool}: the list of datasets is empty")
        if self.surfaces and not about["inputs"]:
            raise TypeError(f"{self.tool} takes no dataset: it is given as {_options.data_options(about)}")
        if len(self.surfaces) > 1 and not about["inputs"][0]["repeated"]:
            raise TypeError(f"{self.tool} takes one dataset, not {len(self.surfaces)}")

    def __call__(self, *datasets):
        return run_pipe([Stage(self.name, self.options, datasets)])

    def __repr__(self):
        return f"<stage: {' '.join([self.tool, *map(str, self.words)])}>"

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise AttributeError(f"a stage has no {name!r}: it has not run. Call it with a dataset, or give it to "
                             "asperity.pipe")

    @property
    def waits(self):
        """Whether it needs a dataset and has none: it reads one, and no option takes its place."""
        about = _options.table(self.name)
        own = about["parameters"]
        alone = any(value is not None and value is not False and "INPUT" in own[name]["excludes"]
                    for name, value in self.options.items())
        return bool(about["inputs"]) and not self.surfaces and not alone

    def again(self, **options):
        """The same with other options."""
        out = Stage(self.name, {**self.options, **options})
        out.surfaces = self.surfaces
        return out


def in_a_pipe(stages):
    """The stages with their datasets as words, and what feeds the first of them."""
    first, *others = stages
    given = first.surfaces
    alone = len(given) == 1 and not _data.is_name(given[0][1])
    words = [] if alone else [_word(name, value) for name, value in given]
    fields = {_data.field_of(value) for _, value in given} - {None, "heights"}
    has_variable = "variable" in _options.table(first.name)["parameters"]
    if len(fields) == 1 and has_variable and not first.options.get("variable"):
        words = ["--variable", *fields, *words]
    out = first.again()
    out.words += words
    return [out, *others], _data.source(given[0][1], given[0][0]) if alone else None


def _word(name, value):
    if not _data.is_name(value):
        return _data.source(value, name)
    path = os.fspath(value)
    return "./" + path if path.startswith("-") and path != "-" else path


def run_pipe(stages, feed=None):
    stages, own = in_a_pipe(stages)
    return Run(stages, feed or own).execute().deliver()
