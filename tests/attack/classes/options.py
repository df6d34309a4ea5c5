"""Every option of every tool with values of its kind and of others: understood, or refused in a line that names it.

What is written with exit status 0 or 3 is finite; nothing that was told is executed, drawn as markup or obeyed by a terminal.
"""
import functools
import json
import re
import subprocess
import xml.etree.ElementTree as xml

import numpy as np

import maps
from bench import BAD_DATA, NOT_CONVERGED, REFUSED, RIGHT, TOOLS, USAGE, Wrong, check
from classes.streams import inputs

BASE = {"acf": ["g.nc", "-o", "out.nc"],
        "contact": ["g.nc", "--radius", "1mm", "--young", "200GPa", "--poisson", "0.3", "--load", "10mN", "-o", "out.nc"],
        "convert": ["g.nc", "-o", "out.nc"],
        "filter": ["g.nc", "--remove-form", "plane", "--lambda-c", "10um", "-o", "out.nc"],
        "generate": ["--shape", "24x20", "--size", "24um,20um", "--rq", "0.1um", "--length", "4px", "--seed", "1", "-o",
                     "out.nc"],
        "kernel": ["--length", "4px", "--spacing", "1um", "--rq", "0.1um", "-o", "out.nc"],
        "pdf": ["g.nc", "-o", "out.tsv"], "plot": ["g.nc", "--kind", "map", "-o", "out.svg"],
        "psd": ["g.nc", "-o", "out.nc"], "report": ["g.nc", "-o", "out.html"],
        "stats": ["g.nc", "--parameters", "all", "-o", "out.tsv"],
        "stress": ["c.nc", "--depths", "1um,2um", "--components", "all", "-o", "out.nc"], "validate": ["s.nc", "-o",
                                                                                                       "out.tsv"]}
LIMITS = ("t30", "v4000000", "f1000000")
DOCUMENTS = ("--help", "--man", "--version", "--dump-config", "--completion", "--describe")

NUMBERS = ["0", "-1", "1", "0.5", "2", "7", "1e300", "-1e300", "nan", "inf", "-inf", "1e-300", "1e400", "0x10", "1,2",
           "1,2,3", "ten",
           "1e9", "99999999999999999999", "0.1.2", " 1", "1 ", "+1", "1e", "--1", "0,5", "2147483647", "4294967296", "1/3",
           "1e-17"]
UNITS = ["m", "mm", "um", "nm", "px", "N", "mN", "Pa", "MPa", "GPa", "deg", "rad", "s", "", "parsec", "K", "m2", "degC",
         "%", "um um"]
COUNTS = ["0x0", "1x1", "4x5", "-1x4", "4x", "x4", "4", "1e3x2", "4x4x4", "99999999999x99999999999", "3X3", "1x400", "7x1",
          "2.5x2"]
LISTS = ["1,2,3", ":", "0:1um:4", "1um:0:4", "0:1um:-1", "0:1um:0", "1um:1um:2", ",,", "0:nan:4", "0:inf:3",
         "0.5px:1um:3:geometric",
         "0:1um:3:geometric", "1N:5N:3", "1N,5N", "0N", "-1N:1N:4", "1um", "0:1:2:3:4", "0:10,0:10", "3:2,1:0", ":5,:",
         "y=0", "x=1um",
         "y=max", "z=0", "x=nan", "1/e", "0.2,0.5", "height", "all", "height,nothing", "von_mises,zz", "plane", "3", "20",
         "21", "100%"]
NASTY = ["'; touch pwned; '", "$(touch pwned)", "`touch pwned`", "\"; system(\"touch pwned\"); \"",
         "'.system('touch pwned').'",
         "\n!touch pwned\n", "<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "\x1b]0;owned\x07\x1b[31m",
         "%s%n%d",
         "folder/../x", "a\nb", "\\", "\\n", "@x", "{/Symbol a}", "''", "a''b", "\u202egpj.exe", "x" * 5000, "|touch pwned",
         "-", "--", "/",
         "\u0085", "\ufffd", "NaN", "]]>", "&amp;", "heights", "acf", "gaussian", "netcdf", "."]


@functools.lru_cache(maxsize=None)
def options(folder, tool):
    """(name, kind) of every option that --help lists; the kind of a flag is empty."""
    text = subprocess.run([f"{folder}/asperity-{tool}", "--help"], capture_output=True, text=True, check=True).stdout
    text = text[text.index("\nExample:"):text.index("\nAccuracy:")]
    found = re.findall(r"^  (?:-\w, )?(--[a-z-]+)(?: (\S+))?", text, re.M)
    return [(name, kind) for name, kind in found if name not in DOCUMENTS]


def value(case, kind):
    """Something of this kind, or now and then of another."""
    if case.chance(0.15):
        kind = case.one_of("N", "QUANTITY", "AxB", "LIST", "TEXT")
    if "|" in kind and "." not in kind and case.chance(0.7):
        return case.one_of(*kind.split("|"))
    if kind == "WORD":  # a long list of them
        return case.one_of("netcdf", "text", "gsf", "exponential", "matern", "map", "section", "nearest")
    if kind in ("N", "NUMBER"):
        return case.one_of(*NUMBERS)
    if kind in ("QUANTITY", "A[,B]", "LENGTH", "ANGLE", "SIZE", "LOW,HIGH"):
        numbers = [case.one_of(*NUMBERS) + case.one_of(*UNITS, "GB", "kB") for _ in range(case.one_of(1, 1, 2))]
        return ",".join(numbers)
    if kind == "AxB":
        return case.one_of(*COUNTS)
    if kind in ("TEXT", "NAME", "FILE", "FILE.json", "FILE.toml", "PATTERN") or "FILE" in kind:
        return case.one_of(*NASTY)
    return case.one_of(*LISTS)


def without(arguments, name):
    """The arguments less an option that is to be given anew."""
    name = "-o" if name == "--output" else name
    if name not in arguments:
        return list(arguments)
    at = arguments.index(name)
    alone = name == "--smooth"
    return arguments[:at] + arguments[at + (1 if alone else 2):]


def named_inputs(case, arguments):
    inputs(case, tuple(a for a in arguments if a in ("g.nc", "c.nc", "s.nc")))


def finite(case, run):
    """No NaN and no infinity in what was written, but where they have a meaning."""
    for name in case.files():
        path = case.path(name)
        if name in ("g.nc", "c.nc", "s.nc") or not path.is_file():
            continue
        head = path.read_bytes()[:4]
        if head[:3] == b"CDF":
            finite_dataset(path)
        elif name.endswith(".tsv") and head[:1] == b"#":
            check(not re.search(r"^\S+\t-?(nan|inf)\t", path.read_text(errors="replace"), re.M),
                  f"no value that is not finite in {name}")


def finite_dataset(path):
    import netCDF4
    with netCDF4.Dataset(path) as data:
        for name, variable in data.variables.items():
            if variable.dtype.kind != "f" or name == "acf_target":
                continue
            values = np.ma.compressed(variable[:])
            check(np.isfinite(values).all(), f"finite values in {name}")
        for name in data.ncattrs():
            values = np.asarray(data.getncattr(name))
            if values.dtype.kind == "f" and not re.search("radius|limit_pressure|young", name):
                check(np.isfinite(values).all(), f"a finite attribute {name}, not {values}")


def nothing_executed(case):
    check(not case.path("pwned").exists(), "nothing that was told is executed")
    for name in case.files():
        if name.endswith(".html") and case.path(name).is_file():
            page = case.path(name).read_text(errors="replace")
            check("<script>alert" not in page and "<img src=x" not in page, "no markup that was told")


def judged(case, run, *names):
    """The oracle of this class."""
    nothing_executed(case)
    if run.code == USAGE:
        check(any(n in run.err for n in names) or re.search(r"--[a-z]|ASPERITY_|INPUT", run.err),
              f"an option named: {run.err.strip()[:300]!r}")
    if run.code in (0, NOT_CONVERGED):
        finite(case, run)
    return run.verdict()


# ---- faults that there have been ----


def many_convolutions(case):
    """A bound of many convolutions is not that of 1.3."""
    inputs(case, ("g.nc",))
    bound = str(case.one_of(1000000, 2147483647, int(case.rng.integers(100000, 2**31 - 1))))
    case.done("contact", *BASE["contact"], "--max-convolutions", bound)
    return RIGHT


def empty_value(case, tool, name, way=0):
    arguments = without(BASE[tool], name)
    named_inputs(case, arguments)
    given = [name, ""] if way == 0 else [name + "="]
    run = case.run(tool, *arguments, *given, limits=LIMITS)
    if name == "--title":
        return run.verdict()
    return case.refused(run, USAGE, name)


def empty_counter(case):
    return empty_value(case, "contact", "--counter")


def empty_output(case):
    return empty_value(case, case.one_of("generate", "stats", "report", "contact"), "--output")


def beyond_all_depths(case):
    inputs(case, ("c.nc",))
    return judged(case, case.run("stress", "c.nc", "--depths", "1e300m", "--components", "all", "-o", "out.nc"))


def beyond_all_friction(case):
    inputs(case, ("c.nc",))
    return judged(case, case.run("stress", "c.nc", "--depths", "1um", "--components", "all", "--friction", "1e300", "-o",
                                 "out.nc"))


def beyond_all_heights(case):
    return judged(case, case.run("generate", *without(BASE["generate"], "--rq"), "--rq", "1e300m"))


def aliased(case):
    """Waves below two samples are not drawn as what they are not, without a word."""
    length = case.one_of("1.5px", "1.1px", "0.5px", "1.9px")
    run = case.run("kernel", "--model", "exponential-cosine", "--length", "8px", "--wavelength", length, "-o", "out.nc")
    if run.code != 0:
        return case.refused(run, (USAGE, NOT_CONVERGED, BAD_DATA), "wavelength")
    check(run.told() and run.says("wavelength"), f"a warning that names the wavelength: {run.err!r}")
    return RIGHT


TITLES = ["'Ground' steel", "it''s", "''", "a ''b'' c", '"quoted" \'both\'', "back\\slash", "100 % {x}_y^z", "@home",
          "`date`", "$HOME", "'", '"']


def quoted_title(case):
    """A title stands in the figure as it was given, whatever gnuplot makes of its quotes."""
    inputs(case, ("g.nc",))
    title = case.one_of(*TITLES)
    case.done("plot", "g.nc", "--kind", "map", "--title", title, "-o", "out.svg")
    found = "".join(well_formed(case.path("out.svg")).itertext())
    check(title in found, f"the title {title!r} in the figure")
    return RIGHT


def figure_is_xml(case):
    """No title makes of an SVG what is no XML."""
    inputs(case, ("g.nc",))
    title = case.one_of("]]>", "a]]>b", "<b>", "&amp; &", "]]><script>alert(1)</script>")
    run = case.run("plot", "g.nc", "--kind", case.one_of("map", "profile", "pdf"), "--title", title, "-o", "out.svg")
    if run.code == 0:
        well_formed(case.path("out.svg"))
    return run.verdict()


def well_formed(path):
    try:
        return xml.parse(path).getroot()
    except xml.ParseError as e:
        raise Wrong(f"a figure that is well formed: {e}") from e


def quoted_file(case):
    """So does the name of a file among the labels."""
    inputs(case, ("g.nc",))
    name = case.one_of("''.nc", "a''b.nc", "'x' y.nc")
    case.path("g.nc").rename(case.path(name))
    maps.write_netcdf(case.path("g.nc"), maps.random_surface(case.rng, (12, 10)))
    case.done("plot", name, "g.nc", "--kind", "map", "-o", "out.svg")
    found = "".join(well_formed(case.path("out.svg")).itertext())
    check(name[:-3] in found, f"the label {name!r} in the figure")
    return RIGHT


def digits(case):
    """Absurd numbers are told in a few digits, which run() asks of all."""
    tool, name, given = case.one_of(("generate", "--rq", "-1e300m"), ("generate", "--size", "1e300m"), ("contact", "--load",
                                                                                                        "-1e300N"),
                                    ("contact", "--young", "-1e300Pa"), ("stress", "--depths", "-1e300m"), ("kernel",
                                                                                                            "--length",
                                                                                                            "1e300px"),
                                    ("acf", "--lambda-c", "1e300m"), ("generate", "--length", "1e300m"), ("stress",
                                                                                                          "--poisson",
                                                                                                          "1e300"))
    arguments = without(BASE[tool], name)
    named_inputs(case, arguments)
    return judged(case, case.run(tool, *arguments, name, given, limits=LIMITS), name)


FAULTS = [many_convolutions, empty_counter, empty_output, beyond_all_depths, beyond_all_friction, beyond_all_heights,
          aliased,
          quoted_title, quoted_file, figure_is_xml, figure_is_xml, digits]


# ---- relatives, at random ----


def any_option(case):
    """One option more than a command that works."""
    tool = case.one_of(*TOOLS)
    name, kind = case.one_of(*options(case.bin, tool))
    arguments = without(BASE[tool], name)
    named_inputs(case, arguments)
    given = [name] if not kind else [name, value(case, kind)]
    if kind and case.chance(0.3):
        given = [f"{name}={given[1]}"]
    run = case.run(tool, *arguments, *given, limits=LIMITS)
    return judged(case, run, name)


def two_options(case):
    """Two options at once, which may not go together."""
    tool = case.one_of(*TOOLS)
    arguments, names = BASE[tool], []
    for _ in range(2):
        name, kind = case.one_of(*options(case.bin, tool))
        if name in names or kind and "FILE" in kind:
            continue
        names.append(name)
        arguments = without(arguments, name) + ([name] if not kind else [name, value(case, kind)])
    named_inputs(case, arguments)
    return judged(case, case.run(tool, *arguments, limits=LIMITS), *names)


def any_empty(case):
    tool = case.one_of(*TOOLS)
    name, _ = case.one_of(*[(n, k) for n, k in options(case.bin, tool) if k])
    return empty_value(case, tool, name, case.one_of(0, 1))


def from_environment(case):
    """The same by the environment or a file, which are then named."""
    tool = case.one_of(*TOOLS)
    name, kind = case.one_of(*[(n, k) for n, k in options(case.bin, tool) if k and n not in ("--config", "--output")])
    arguments = without(BASE[tool], name)
    named_inputs(case, arguments)
    given = value(case, kind).replace("\0", "")
    if case.chance(0.5):
        variable = "ASPERITY_" + name[2:].upper().replace("-", "_")
        run = case.run(tool, *arguments, env={variable: given}, limits=LIMITS)
        return judged(case, run, variable)
    case.path("file.toml").write_text(f"{name[2:]} = {json.dumps(given, ensure_ascii=False)}\n")
    return judged(case, case.run(tool, *arguments, "--config", "file.toml", limits=LIMITS), "file.toml")


def strange_config(case):
    """A file of options that is cut, flipped or not meant as one."""
    tool = case.one_of(*TOOLS)
    named_inputs(case, BASE[tool])
    dumped = case.done(tool, *BASE[tool], "--dump-config").out
    dumped = bytearray(re.sub(rb"(?m)^# (\S+ =)", rb"\1", dumped))
    for _ in range(int(case.rng.integers(1, 5))):
        at = int(case.rng.integers(len(dumped)))
        way = case.one_of("flip", "cut", "insert")
        if way == "flip":
            dumped[at] ^= 1 << int(case.rng.integers(7))
        elif way == "cut":
            del dumped[at:at + int(case.rng.integers(1, 30))]
        else:
            dumped[at:at] = case.one_of(b"[[", b"]", b"\"", b"'''", b"= ", b"\x00", b"\xff", b"nan", b"1e400",
                                        b"\n[a.b.c]\n", b"2020-01-01")
    case.path("file.toml").write_bytes(dumped)
    inert = [a for a in BASE[tool] if a in ("g.nc", "c.nc", "s.nc")] + BASE[tool][-2:]
    run = case.run(tool, *inert, "--config", "file.toml", limits=LIMITS)
    nothing_executed(case)
    return judged(case, run, "file.toml", "--config")


def told_and_obeyed(case):
    """What --dump-config prints is what the same options do."""
    tool = case.one_of("stats", "acf", "psd", "pdf", "generate", "contact", "filter")
    named_inputs(case, BASE[tool])
    case.path("file.toml").write_bytes(case.done(tool, *BASE[tool], "--dump-config").out)
    env = {"SOURCE_DATE_EPOCH": "0"}
    more = ("--no-history",) if tool not in ("stats", "pdf") else ()
    case.done(tool, *BASE[tool], *more, env=env)
    first = case.path(BASE[tool][-1]).read_bytes()
    case.done(tool, *[a for a in BASE[tool] if a in ("g.nc", "c.nc", "s.nc")], "--config", "file.toml", *more, env=env)
    check(case.path(BASE[tool][-1]).read_bytes() == first, "the same bytes")
    return RIGHT


def unknown_option(case):
    tool = case.one_of(*TOOLS)
    name = case.one_of("--nothing", "--no-such=1", "-Z", "--rqq", "--outpu", "--=", "--\x1b[31m", "--" + "x" * 3000)
    run = case.run(tool, *BASE[tool], name)
    return case.refused(run, USAGE)


def markup(case):
    """Markup and escapes in titles, labels and attributes stay text."""
    inputs(case, ("g.nc",))
    title = case.one_of(*NASTY, *TITLES)
    run = case.run("report", "g.nc", "--title", title, "-o", "out.html")
    nothing_executed(case)
    if run.code == 0:
        check("\x1b" not in case.path("out.html").read_text(), "no escape in the page")
    drawn = case.run("plot", "g.nc", "--kind", case.one_of("map", "surface", "profile", "pdf"), "--title", title, "-o",
                     "out.svg", limits=LIMITS)
    nothing_executed(case)
    if drawn.code == 0:
        well_formed(case.path("out.svg"))
    return RIGHT if run.code == drawn.code == 0 else REFUSED


FAMILIES = [any_option, any_option, any_option, any_option, two_options, two_options, any_empty, any_empty,
            from_environment,
            strange_config, told_and_obeyed, unknown_option, markup, quoted_title, digits]
