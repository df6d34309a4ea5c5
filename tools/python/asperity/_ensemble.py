"""Many runs that differ in the number of the surface alone, several at a time."""
import concurrent.futures
import itertools
import operator
import os
import secrets

from . import _options, _progress
from ._run import Run
from ._stage import Stage, in_a_pipe

PERIOD = 0.2  # seconds between two looks at the progress


def members(stages, count, first, seed, processes):
    """Checks the call, and returns the generator."""
    if not all(isinstance(one, Stage) for one in stages):
        raise TypeError("stages are needed: asperity.stage.generate(...), asperity.contact(...)")
    if stages[0].name != "generate" or any(one.surfaces for one in stages):
        raise TypeError("the first stage of an ensemble is asperity.stage.generate(...), and the others read it")
    for name in ("count", "first"):
        if stages[0].options.get(name) is not None:
            raise TypeError(f"{name} belongs to the ensemble: asperity.ensemble(..., {name}=...)")
    if seed is not None and stages[0].options.get("seed") is not None:
        raise TypeError("seed is given twice")
    count, first = operator.index(count), operator.index(first)
    if count < 1 or first < 0 or processes is not None and processes < 1:
        raise ValueError("count and processes are at least 1, first is at least 0")
    if seed is None:
        seed = stages[0].options.get("seed")
    processes = processes or min(count, len(os.sched_getaffinity(0)))
    return _members(stages, range(first, first + count), secrets.randbits(53) if seed is None else seed, processes)


def _environment(stages, processes):
    """One thread for each tool if several pipes run, without a trace in the history."""
    out = {}
    for one in stages:
        key = f"ASPERITY_{one.name.upper()}_THREADS"
        if processes > 1 and "threads" in _options.table(one.name)["parameters"]:
            if key not in os.environ and one.options.get("threads") is None:
                out[key] = "1"
    return out


def _members(stages, numbers, seed, processes):
    environment, waiting, left = _environment(stages, processes), [], iter(numbers)
    with concurrent.futures.ThreadPoolExecutor(processes) as pool, _progress.Line(_progress.wanted(stages)) as line:

        def begin(most):
            for number in itertools.islice(left, most):
                own, feed = in_a_pipe([stages[0].again(first=number, seed=seed), *stages[1:]])
                run = Run(own, feed, shown=False, environment=environment)
                waiting.append((run, pool.submit(run.execute)))
        try:
            begin(processes)
            for done in range(len(numbers)):
                future = waiting[0][1]
                while not future.done():
                    line.show(0, f"asperity.ensemble: {done} of {len(numbers)} surfaces")
                    concurrent.futures.wait([future], timeout=PERIOD)
                line.clear()
                del waiting[0]
                begin(1)
                yield future.result().deliver()
        finally:
            for run, future in waiting:
                run.stop()
                future.cancel()
