"""What a case of the attack has: random numbers of its own, an empty folder, the tools, and what is asked of every run.

Whatever a tool is told, it ends by itself with a known exit status; it fails with one line that begins with its name; all
that it says is printable, in lines of at most 1000 characters.
"""
import json
import os
import pathlib
import pickle
import re
import shlex
import shutil
import subprocess
import tempfile
import threading
import unicodedata

import numpy as np

# A process begun by vfork has the greatest memory that this one ever had for its own peak; by fork, what this one has.
subprocess._USE_VFORK = False

TOOLS = ("acf", "contact", "convert", "filter", "generate", "kernel", "pdf", "plot", "psd", "report", "stats", "stress", "validate")
RIGHT, REFUSED, TOLD, SKIPPED = "right", "refused", "told", "skipped"
RUNTIME, USAGE, NOT_CONVERGED, BAD_DATA, DIFFERS = 1, 2, 3, 4, 5
WALL_SECONDS = 120  # of a single command on a busy machine


class Wrong(Exception):
    """What was expected and what came instead."""


class Skipped(Exception):
    """What this machine lacks."""


def check(holds, expected):
    if not holds:
        raise Wrong(expected)


def strict_json(text):
    """RFC 8259, which knows no NaN and no Infinity."""
    def refuse(word):
        raise Wrong(f"JSON without {word}")
    try:
        return json.loads(text, parse_constant=refuse)
    except ValueError as e:
        raise Wrong(f"JSON: {e}") from e


class Run:
    """A command that has ended. `code` is below 0 where a signal ended it; `peak` is in bytes, and at least this process's."""

    def __init__(self, line, code, out, err, usage):
        self.line, self.code, self.out = line, code, out
        self.err = err.decode("utf-8", "backslashreplace")
        self.raw_err, self.peak = err, usage.ru_maxrss * 1024
        self.cpu_seconds = usage.ru_utime + usage.ru_stime

    def verdict(self):
        return {0: RIGHT, NOT_CONVERGED: TOLD, DIFFERS: TOLD}.get(self.code, REFUSED)

    def says(self, *words):
        return all(word.lower() in self.err.lower() for word in words)

    def told(self):
        """It ended well, or not converged, but not without a word."""
        return self.code == NOT_CONVERGED or self.code == 0 and "warning" in self.err


def untidy(err):
    """What is wrong with what was said on standard error; nothing if all is well."""
    try:
        text = err.decode("utf-8")
    except UnicodeDecodeError:
        return "is no UTF-8"
    for line in text.split("\n"):
        if len(line) > 1000:
            return f"has a line of {len(line.encode())} bytes"
        strange = [c for c in line if unicodedata.category(c) in ("Cc", "Cf", "Co", "Cs", "Zl", "Zp")]
        if strange:
            return f"has the control character {strange[0]!r}"
        if re.search(r"\d{40}", line):
            return "has a number of 40 digits and more"
        if re.search(r"(^|[^\d.x])1 (surfaces|points|threads|loads|layers|cells|lags)\b", line):
            return "has a plural of one"
    return ""


class Bench:
    def __init__(self, bin_folder, seed, class_name, number):
        words = np.frombuffer(class_name.encode().ljust(16), "<u4")
        self.rng = np.random.default_rng([seed, number, *words])
        self.bin, self.number = bin_folder, number
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=f"attack-{class_name}-{number}-"))
        self.lines = []  # the commands so far, as a shell would take them

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def path(self, name):
        return self.folder / name

    def files(self):
        return sorted(os.listdir(self.folder))

    def one_of(self, *things):
        return things[int(self.rng.integers(len(things)))]

    def chance(self, share):
        return self.rng.random() < share

    def apart(self, make):
        """make() in a process of its own: a tool's peak counts from that of the process that starts it, which stays small."""
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                os.write(write, pickle.dumps(make()))
                os._exit(0)
            finally:
                os._exit(1)
        os.close(write)
        with os.fdopen(read, "rb") as answer:
            made = answer.read()
        _, status = os.waitpid(child, 0)
        assert status == 0, "the attack could not make its file"
        return pickle.loads(made)

    def environment(self, more):
        clean = {k: v for k, v in os.environ.items() if not k.startswith(("ASPERITY_", "LC_", "SOURCE_DATE"))}
        place = f"{self.bin}:{os.environ.get('PATH', '/usr/bin:/bin')}"
        return {**clean, "LANG": "C", "HOME": str(self.folder), "PATH": place, **(more or {})}

    def shell(self, line, env=None, stdin=None, wall=WALL_SECONDS, cwd=None):
        """Runs a line of sh in the case's folder; stdin is bytes that come through a pipe, or nothing."""
        self.lines.append("".join(f"{k}={shlex.quote(v)} " for k, v in (env or {}).items()) + line)
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen(["sh", "-c", line], cwd=cwd or self.folder, env=self.environment(env), stderr=said,
                                       stdin=subprocess.DEVNULL if stdin is None else subprocess.PIPE,
                                       stdout=subprocess.PIPE, start_new_session=True)
            late = threading.Event()
            timer = threading.Timer(wall, lambda: (late.set(), os.killpg(process.pid, 9)))
            timer.start()
            if stdin is not None:
                threading.Thread(target=feed, args=(process.stdin, stdin), daemon=True).start()
            out = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            timer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            process.stdout.close()
            said.seek(0)
            run = Run(line, process.returncode, out, said.read(), usage)
        check(not late.is_set(), f"an end within {wall} s")
        return run

    def raw(self, tool, *arguments, limits=(), **more):
        """One tool, with no question asked. `limits` are those of ulimit: "t20" seconds, "v1000000" kB."""
        command = shlex.join([f"asperity-{tool}", *map(str, arguments)])
        return self.shell("".join(f"ulimit -{limit[0]} {limit[1:]}; " for limit in limits) + "exec " + command, **more)

    def run(self, tool, *arguments, **more):
        """One tool, of which is asked what is asked of all."""
        run = self.raw(tool, *arguments, **more)
        self.asked_of_all(run, tool)
        return run

    def asked_of_all(self, run, tool):
        known = (0, 1, 2, 3, 4) + ((5,) if tool == "validate" else ())
        check(run.code in known, f"an exit status of {known}, not {run.code}: {run.err[:300]!r}")
        fault = untidy(run.raw_err) if "--progress" not in run.line else ""
        check(not fault, f"messages that are short, printable and in words; one {fault}: {run.err[:300]!r}")
        name = f"asperity-{tool}: "
        talks = re.search(r" (-v|--verbose|--progress)", run.line)
        for line in run.err.splitlines():
            check(talks or line.startswith(name), f"every message begins with {name!r}: {line[:200]!r}")
        failures = [line for line in run.err.splitlines() if not line.startswith(name + "warning: ")]
        if run.code in (RUNTIME, USAGE, BAD_DATA):
            check(failures, "a failure says why")

    def done(self, tool, *arguments, **more):
        """A step that others rest on: it must succeed."""
        run = self.run(tool, *arguments, **more)
        check(run.code == 0, f"exit status 0, not {run.code}: {run.err.strip()[:300]}")
        return run

    def refused(self, run, codes, *words):
        """A refusal by one of these exit statuses, whose line has these words."""
        codes = (codes,) if isinstance(codes, int) else codes
        check(run.code in codes, f"a refusal with exit status {codes}, not {run.code}: {run.err.strip()[:300]!r}")
        check(run.says(*words), f"a refusal that names {words}: {run.err.strip()[:300]!r}")
        return REFUSED


def feed(pipe, data):
    try:
        with pipe:
            pipe.write(data)
    except OSError:
        pass  # the tool has read enough
