"""The same command gives the same bytes: by any number of threads, twice, from a pipe, in strips, elsewhere."""
import subprocess

import numpy as np

import maps
from bench import RIGHT, TOOLS, check, strict_json
from readings import close
from classes.options import BASE, without
from classes.streams import inputs

STILL = {"SOURCE_DATE_EPOCH": "1000000000"}
DATASETS = ("acf", "contact", "convert", "filter", "generate", "kernel", "psd", "stress")
THREADED = [t for t in TOOLS if t not in ("convert", "kernel", "plot", "report")]


def command(case, tool):
    """A command of this tool with some of its options, less its output."""
    more = {"contact": [[], ["--limit-pressure", "3GPa"], ["--add", "contact_stiffness"], ["--add", "heights_residual", "--limit-pressure", "2GPa"]],
            "generate": [[], ["--periodic"], ["--skewness", "-1"], ["--model", "gaussian"], ["--add", "noise,kernel"], ["--exact-rq"]],
            "kernel": [[], ["--model", "matern"], ["--formulation", "oriented"], ["--method", "spectral"]],
            "stats": [[], ["--remove-form", "plane"], ["--lambda-c", "10um"], ["--profile", "x", "--json"]],
            "pdf": [[], ["--estimate", "kernel"], ["--estimate", "quantiles"]], "acf": [[], ["--biased", "--add", "structure_function"],
                                                                                        ["--add", "acf_quantiles"]],
            "stress": [[], ["--friction", "0.3"], ["--maximum"], ["--resolution", "full"]]}.get(tool, [[]])
    arguments = without(BASE[tool], "--parameters") if tool == "stats" else BASE[tool]
    arguments = without(arguments, "--output") + case.one_of(*more) + (["--no-history"] if tool in DATASETS else [])
    inputs(case, tuple(a for a in arguments if a in ("g.nc", "c.nc", "s.nc")))
    return arguments


def output(tool, name):
    return name + {"plot": ".svg", "report": ".html", "stats": "", "pdf": "", "validate": ""}.get(tool, ".nc")


def made(case, tool, arguments, name, env=None, **more):
    case.done(tool, *arguments, "-o", output(tool, name), env={**STILL, **(env or {})}, **more)
    return case.path(output(tool, name)).read_bytes()


def threads(case):
    tool = case.one_of(*THREADED)
    arguments = command(case, tool)
    first = made(case, tool, arguments + ["--threads", "1"], "one")
    for count in ("2", case.one_of("3", "5", "0")):
        check(made(case, tool, arguments + ["--threads", count], "other") == first,
              f"the same bytes by {count} threads as by one")
    return RIGHT


def twice(case):
    tool = case.one_of(*TOOLS)
    arguments = command(case, tool)
    check(made(case, tool, arguments, "one") == made(case, tool, arguments, "other"), "the same bytes twice")
    return RIGHT


def through_pipes(case):
    """From a file or a pipe, into a file or a pipe."""
    tool = case.one_of("acf", "contact", "convert", "pdf", "psd", "stats", "stress", "plot", "report", "validate")
    arguments = command(case, tool)
    if tool in ("plot", "report"):  # which name their input
        arguments += ["--title", "same"]
    first = made(case, tool, arguments, "one")
    rest = arguments[1:] + (["--to", "svg", "-o", "-"] if tool == "plot" else [])
    run = case.done(tool, *rest, stdin=case.path(arguments[0]).read_bytes(), env=STILL)
    if tool != "report":
        check(run.out == first, "the same bytes through pipes")
    else:
        check(abs(len(run.out) - len(first)) < 2000, "nearly the same page")
    return RIGHT


def elsewhere(case):
    """Another folder, home, time zone and language."""
    tool = case.one_of(*[t for t in TOOLS if t not in ("plot", "report")])  # which name their input
    arguments = command(case, tool)
    first = made(case, tool, arguments, "one")
    case.path("elsewhere").mkdir()
    languages = subprocess.run(["locale", "-a"], capture_output=True, text=True).stdout.split()
    language = case.one_of(*([l for l in languages if l.startswith("de_DE")] or languages or ["C"]))
    env = {**STILL, "TZ": case.one_of("UTC", "Asia/Kolkata", "America/St_Johns"), "HOME": "/nowhere", "LC_ALL": language,
           "COLUMNS": "40",
           "OMP_NUM_THREADS": "1", "TMPDIR": str(case.path("elsewhere"))}
    names = [f"../{a}" if a in ("g.nc", "c.nc", "s.nc") else a for a in arguments]
    case.done(tool, *names, "-o", "../" + output(tool, "other"), env=env, cwd=case.path("elsewhere"))
    check(case.path(output(tool, "other")).read_bytes() == first, f"the same bytes elsewhere, LC_ALL={language}")
    return RIGHT


def pictures_in_any_language(case):
    """A figure and a page are the same in every language, with letters that not every one has."""
    tool = case.one_of("plot", "report")
    arguments = command(case, tool) + ["--title", case.one_of("größe µ °", "plain", "Ω→∞")]
    languages = subprocess.run(["locale", "-a"], capture_output=True, text=True).stdout.split()
    pages = [made(case, tool, arguments, f"p{i}", env={"LC_ALL": l}) for i, l in enumerate(("C", case.one_of(*languages)))]
    check(pages[0] == pages[1], "the same picture in every language")
    return RIGHT


def strips_of_a_surface(case):
    """A surface that is drawn in strips is that which is drawn whole."""
    shape = f"{int(case.rng.integers(100, 300))}x{int(case.rng.integers(100, 200))}"
    arguments = ["--shape", shape, "--size", "1mm", "--rq", "1um", "--length", case.one_of("4px", "3px,8px"), "--seed",
                 str(case.rng.integers(1, 2**40)), "--no-history", *case.one_of([], [], ["--exact-rq"], ["--add", "noise"],
                                                                                ["--skewness", "-0.8"])]
    first = made(case, "generate", arguments, "one")
    run = case.run("generate", *arguments, "--memory", case.one_of("2MB", "1MB", "600kB"), "-o", "other.nc", env=STILL)
    if run.code != 0:
        return case.refused(run, 2, "memory")
    fields = [maps.read(case.path(name))[0] for name in ("one.nc", "other.nc")]
    check(all((fields[0][v] == fields[1][v]).all() for v in fields[0]), "the same heights in strips, to the last bit")
    check(case.path("other.nc").stat().st_size == len(first), "a dataset of the same size")
    return RIGHT


def strips_of_an_exact_one(case):
    """--memory does not change a surface that is scaled to --rq either, to the last bit."""
    arguments = ["--shape", "256x126", "--size", "1mm", "--rq", "1um", "--length", "4px", "--no-history", "--exact-rq",
                 "--seed"]
    for _ in range(4):
        seed = str(case.rng.integers(1, 2**40))
        first = made(case, "generate", [*arguments, seed], "one")
        check(made(case, "generate", [*arguments, seed, "--memory", "1MB"], "other") == first,
              "the same bytes in strips as whole")
    return RIGHT


def other_number(case):
    """Surface n of an ensemble is the same alone; streams and seeds differ."""
    arguments = ["--shape", "20x16", "--size", "20um,16um", "--rq", "1um", "--length", "4px", "--seed", "7", "--no-history"]
    number = int(case.rng.integers(0, 5))
    case.done("generate", *arguments, "--count", "5", "-o", "s_%d.nc", env=STILL)
    alone = made(case, "generate", arguments + ["--first", str(number)], "alone")
    check(case.path(f"s_{number}.nc").read_bytes() == alone, "a surface alone as in its ensemble")
    others = [made(case, "generate", arguments + ["--stream", "1"], "stream"),
              case.path(f"s_{(number + 1) % 5}.nc").read_bytes()]
    check(alone not in others, "other streams and numbers are other surfaces")
    return RIGHT


FAULTS = [strips_of_an_exact_one, threads, twice, through_pipes, elsewhere, pictures_in_any_language, strips_of_a_surface,
          other_number]
FAMILIES = FAULTS
