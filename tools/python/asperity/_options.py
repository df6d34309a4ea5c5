"""The options of a tool, from the table that it prints (--describe): parameters of a function, and words of a
command line."""
import difflib
import functools
import importlib.metadata
import inspect
import json
import keyword
import math
import numbers
import os
import shutil
import subprocess

from . import _data
from .errors import ToolError, UsageError, brief

PREFIX = "asperity-"
NO_PARAMETERS = ("quiet", "json", "table")  # notes are logged, and tables are read


@functools.lru_cache(maxsize=None)
def _brought(program):
    """A program of the wheel from which this module was installed, or None, as for a module from elsewhere."""
    try:
        files = importlib.metadata.distribution(__package__).files or []
    except importlib.metadata.PackageNotFoundError:
        return None
    own = os.path.normpath(__file__)
    places = {file.name: os.path.normpath(file.locate()) for file in files if file.parent.name in ("bin", __package__)}
    if places.get(os.path.basename(own)) != own:
        return None
    beside = os.path.join(os.path.dirname(os.path.dirname(own)), "bin", program)  # by pip install --target
    return next(filter(os.path.isfile, (places.get(program, ""), beside)), None)


def _find(program):
    """Where a program is: where pip has put it, in an active environment or not, else where a shell would find it."""
    return _brought(program) or shutil.which(program)


def program(name):
    """The path of a tool."""
    tool = PREFIX + name
    if found := _find(tool):
        return found
    raise ToolError(f"{tool} is not on PATH: install the package asperity, or add the folder of the tools", tool, 127)


def names():
    """All tools beside the program asperity, without their prefix."""
    listed = _find("asperity")
    folder = os.path.dirname(listed) if listed else None
    found = sorted(f for f in os.listdir(folder) if f.startswith(PREFIX)) if folder else []
    return [name.removeprefix(PREFIX) for name in found if os.access(os.path.join(folder, name), os.X_OK)]


def table(name):
    """What the tool tells of itself."""
    return table_of(*state(name))


def state(name):
    """The tool, its program, and marks of its state."""
    path = program(name)
    marks = os.stat(path)
    return name, path, marks.st_mtime_ns, marks.st_size, marks.st_ino


@functools.lru_cache(maxsize=None)
def table_of(_name, path, *_marks):
    """Read once for each state of the program."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ASPERITY_")}
    run = subprocess.run([path, "--describe"], stdin=subprocess.DEVNULL, capture_output=True, env=environment)
    if run.returncode != 0:
        line = run.stderr.decode(errors="replace").strip() or f"{path}: ended with {run.returncode}"
        raise ToolError(f"{line}: this module needs tools of its own version", os.path.basename(path), run.returncode)
    out = json.loads(run.stdout)
    own = [o for o in out["options"] if not o["prints"]]
    out["inputs"] = [o for o in own if not o["names"]]
    out["parameters"] = {python_name(o["name"]): o for o in own if o["names"] and o["name"] not in NO_PARAMETERS}
    return out


def python_name(option):
    word = option.replace("-", "_")
    return word + "_" if keyword.iskeyword(word) else word


# ---- what a person sees ----


def signature(about):
    """(*datasets, ...) of a tool that takes several, (dataset=None, *, ...) of one that takes one."""
    kind = inspect.Parameter
    first = []
    if about["inputs"]:
        several = about["inputs"][0]["repeated"]
        first = [kind("datasets", kind.VAR_POSITIONAL) if several else
                 kind("dataset", kind.POSITIONAL_OR_KEYWORD, default=None)]
    return inspect.Signature([*first, *(kind(name, kind.KEYWORD_ONLY, default=None) for name in about["parameters"])])


def docstring(about):
    summary, description = about["summary"], about["description"].rstrip(".")
    out = [f"{summary[:1].upper()}{summary[1:]}.", "", f"{description}.", ""]
    for option in about["inputs"]:
        out += ["datasets" if option["repeated"] else "dataset", f"    {option['text']}. Here a Dataset, a DataArray, "
                "bytes, or the name of a file; without any the call is a stage, for asperity.pipe", ""]
    heading = None
    for name, option in about["parameters"].items():
        if option["heading"] != heading:
            heading = option["heading"]
            out += [heading, "-" * len(heading)]
        out += [f"{name} : {_kind_in_words(option)}", f"    {option['text']}"]
    out += ["", "In a shell", "----------", about["example"], "", about["accuracy"], "",
            "Exit status: " + ", ".join(f"{s['status']} {s['meaning']}" for s in about["statuses"])]
    return "\n".join(out)


def _kind_in_words(option):
    if option["value"] == "flag":
        return "bool"
    kind = " | ".join(option["words"]) or option["kind"]
    number = f", a number of asperity.si is in {option['unit']}" if option["unit"] not in ("", "1") else ""
    return kind + number + (", a list repeats it" if option["repeated"] else "")


def near(name, known):
    """A hint at the known name that is most like it, or nothing."""
    found = difflib.get_close_matches(name, list(known), 1)
    return f": did you mean {found[0]!r}?" if found else ""


# ---- words of the command line ----


def words(about, options):
    """The arguments; a source of data stands for the file that it will be."""
    out, own = [], about["parameters"]
    for name, value in options.items():
        if name not in own:
            raise TypeError(f"{about['tool']} has no option {name!r}{near(name, own)}")
        if name == "progress" and value is not None:  # which is shown by this module
            if value not in own[name]["words"]:
                raise UsageError(f"progress={brief(value)} is none of {'|'.join(own[name]['words'])}", status=2)
        elif value is not None:
            out += _words_of(own[name], name, value)
    if own.get("output", {}).get("required") and options.get("output") is None:
        out += ["--output", "-"]
        for name in ("to", "kind"):  # of a picture: PNG, a map
            if name in own and options.get(name) is None:
                out += [f"--{name}", own[name]["words"][0]]
    return out


def _words_of(option, name, value):
    flag = "--" + option["name"]
    if option["value"] == "flag":
        if not _data.is_truth(value):
            raise TypeError(f"{name}={brief(value)}: the option stands alone, True or False")
        return [flag] if value else []
    out = []
    for one in value if option["repeated"] and isinstance(value, list) else [value]:
        word = _file(option, name, one) if option["value"] == "file" else _text(option, name, one)
        joined = isinstance(word, str) and word != "-" and (word.startswith("-") or not word)
        out += [f"{flag}={word}"] if joined else [flag, word]
    return out


def _is_data(option):
    """Whether it names data that may be given in place of a file."""
    return option["kind"] in ("FILE", "NAME|FILE") and option["name"] != "output"


def data_options(about):
    return " or ".join(f"{name}=" for name, option in about["parameters"].items() if _is_data(option))


def _file(option, name, value):
    if _data.is_name(value):
        return os.fspath(value)
    if not _is_data(option):
        raise TypeError(f"{name}={brief(value)}: the name of a file is needed")
    return _data.source(value, name)


def _text(option, name, value, unit=None):
    """`unit`: of the number, if it has none by itself."""
    if _data.is_name(value):
        return os.fspath(value)
    own = "" if option["unit"] == "1" else option["unit"]
    if isinstance(value, _data.Si):
        value, unit = value.value, own
    elif hasattr(value, "magnitude") and hasattr(value, "to"):  # of pint
        value, unit = value.to(own or "dimensionless").magnitude, own
    elif own:
        unit = getattr(value, "attrs", {}).get("units", unit)
    if getattr(value, "ndim", None) == 0 and hasattr(value, "item"):
        value = value.item()
    if isinstance(value, numbers.Real) and not _data.is_truth(value):
        return _number(option, name, value, unit if own else "")
    if isinstance(value, (list, tuple)) or getattr(value, "ndim", None) == 1:
        return ("x" if option["kind"] == "AxB" else ",").join(_text(option, name, v, unit) for v in value)
    raise TypeError(f"{name}={brief(value)}: the option needs {option['kind']}, as text or numbers")


def _number(option, name, value, unit):
    """In its unit; without one, 0 and infinity are left to the tool."""
    whole = isinstance(value, numbers.Integral) or option["kind"] in ("N", "AxB") and float(value).is_integer()
    text = str(int(value)) if whole else repr(float(value))
    if unit is None and value != 0 and not math.isinf(value):
        raise UsageError(f"{name}={text} has no unit: write it as a text with its unit, or asperity.si({text}) for "
                         f"{text} {option['unit']}", status=2)
    return "0" if unit is None and value == 0 else text if math.isinf(value) else _data.with_unit(text, unit or "")
