"""Pipes, devices, kills and names: what was there is there, or what is new is whole, and nothing lies about afterwards."""
import os
import re
import shlex
import signal
import stat
import subprocess
import tempfile
import time
import uuid

import maps
from bench import BAD_DATA, REFUSED, RIGHT, RUNTIME, USAGE, Skipped, check

DRAW = ("generate", "--shape", "32x24", "--size", "32um,24um", "--rq", "0.1um", "--length", "4px", "--seed", "1")
PRESS = ("--radius", "1mm", "--young", "200GPa", "--poisson", "0.3", "--load", "10mN")
WRITES_DATASET = [("generate", *DRAW[1:]), ("kernel", "--length", "4px"), ("contact", "g.nc", *PRESS), ("acf", "g.nc"),
                  ("psd", "g.nc"), ("convert", "g.nc"), ("filter", "g.nc", "--scale", "2"), ("stress", "c.nc", "--depths", "1um,2um")]
WRITES_TEXT = [("stats", "g.nc"), ("acf", "g.nc", "--result", "lengths"), ("psd", "g.nc", "--result", "radial"),
               ("pdf", "g.nc"), ("report", "g.nc"), ("plot", "g.nc", "--kind", "map", "--to", "svg"), ("validate", "s.nc")]


def inputs(case, command=("g.nc", "c.nc", "s.nc")):
    """The files that a command names: a stranger's surface g.nc, one that is pressed c.nc, and one that was drawn, s.nc."""
    if "g.nc" in command:
        maps.write_netcdf(case.path("g.nc"), maps.random_surface(case.rng, (24, 20), dx=1e-6))
    if "c.nc" in command:
        surface, p, attributes = maps.pressed(case.rng)
        maps.write_netcdf(case.path("c.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    if "s.nc" in command:
        case.done(*DRAW, "-o", "s.nc")


def line(command):
    return shlex.join([f"asperity-{command[0]}", *map(str, command[1:])])


def litter(case, *known):
    """Whatever lies in the folder that nobody asked for."""
    return [name for name in case.files() if name not in ("g.nc", "c.nc", "s.nc", *known)]


def no_litter(case, *known):
    check(not litter(case, *known), f"no file but {known}: {litter(case, *known)}")


# ---- faults that there have been ----


def without_proc(case):
    """Datasets are written in a chroot without /proc too."""
    if subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode:
        raise Skipped("unshare -m needs a right")
    hidden = f"mount -t tmpfs none /proc && exec {line(DRAW)} -o out.nc"
    run = case.shell("exec unshare -m sh -c " + shlex.quote(hidden))
    check(run.code == 0 and "heights" in maps.read(case.path("out.nc"))[0], f"a dataset: {run.err.strip()!r}")
    no_litter(case, "out.nc")
    return RIGHT


def planted_link(case):
    """Where a file cannot be without a name, its temporary name is no link that somebody has planted."""
    if subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode:
        raise Skipped("unshare -m needs a right")
    case.path("victim").write_text("mine")
    hidden = f"mount -t tmpfs none /proc; ln -s victim out.nc.part$$; exec {line(DRAW)} -o out.nc"
    case.shell("exec unshare -m sh -c " + shlex.quote(hidden))
    check(case.path("victim").read_text() == "mine", "a file that was linked to is untouched")
    return RIGHT


def keeps_mode(case):
    """A file that is replaced keeps its mode and, where that is allowed, its owner."""
    command = case.one_of(*WRITES_DATASET, ("stats", "g.nc"), ("report", "g.nc"))
    inputs(case, command)
    name = case.path("out.html" if command[0] == "report" else "out.nc" if command in WRITES_DATASET else "out.tsv")
    name.write_bytes(b"old")
    mode = case.one_of(0o600, 0o640, 0o660, 0o644)
    name.chmod(mode)
    owner = 1234 if os.geteuid() == 0 else os.geteuid()
    os.chown(name, owner, -1)
    case.done(*command, "-o", name.name)
    now = name.stat()
    check(stat.S_IMODE(now.st_mode) == mode, f"the mode {mode:o}, not {stat.S_IMODE(now.st_mode):o}")
    check(now.st_uid == owner, f"the owner {owner}, not {now.st_uid}")
    check(now.st_size > 3, "a new file")
    return RIGHT


def two_outputs_one_file(case):
    command = case.one_of(("contact", "g.nc", *PRESS), ("stress", "c.nc", "--depths", "1um"), ("kernel", "--length", "4px"),
                          DRAW)
    inputs(case, command)
    one, other = case.one_of(("same", "same"), ("same", "./same"), ("same", str(case.path("same"))))
    run = case.run(*command, "-o", one, "--report", other)
    case.refused(run, USAGE, "report")
    no_litter(case)
    return REFUSED


def page_over_its_input(case):
    inputs(case, "g.nc")
    name = case.one_of("a.nc", "a.html", "a")
    case.path("g.nc").rename(case.path(name))
    before = case.path(name).read_bytes()
    run = case.run("report", name, "-o", case.one_of(name, "./" + name))
    check(case.path(name).read_bytes() == before, "the input is untouched")
    return case.refused(run, USAGE, "output")


def limited_files_do_not_end_pipes(case):
    """ulimit -f bounds files; a pipe is none."""
    run = case.shell(f"ulimit -f 1; {line(DRAW)} | asperity-contact {shlex.join(PRESS)} | asperity-stats --json")
    check(run.code == 0 and b'"Sq"' in run.out, f"the numbers, through pipes: {run.code} {run.err!r}")
    return RIGHT


def nothing_on_standard_input(case):
    """`false | asperity-stats`: bad data, and not a word of lists."""
    tool = case.one_of("stats", "stats", "validate")
    run = case.run(tool, stdin=b"")
    case.refused(run, (BAD_DATA, RUNTIME))
    check("list" not in run.err, f"no word of lists: {run.err!r}")
    return REFUSED


def shared_memory(case):
    """/dev/shm is a folder of files, though it lies under /dev."""
    if not os.access("/dev/shm", os.W_OK):
        raise Skipped("/dev/shm is not there")
    name = f"/dev/shm/attack-{uuid.uuid4().hex}.nc"
    try:
        run = case.run(*DRAW, "-o", name)
        check(run.code == 0 and os.path.getsize(name) > 1000, f"a dataset in /dev/shm: {run.err.strip()!r}")
    finally:
        if os.path.exists(name):
            os.unlink(name)
    return RIGHT


def one_of_them(case):
    """Nothing speaks of "1 surfaces", which run() asks of all."""
    inputs(case, "s.nc")
    for command in (("validate", "s.nc"), ("stats", "s.nc", "s.nc"), ("contact", "s.nc", *PRESS, "--sweep", "1mN")):
        case.run(*command)
    return RIGHT


def strange_date(case):
    """A date out of all years is refused, or told in four digits."""
    epoch = str(case.one_of(10**18, -10**18, 10**12, 253402300800, -1, "x", "", "1e3", 2**63, 2**64))
    run = case.run(*DRAW, "-o", "out.nc", env={"SOURCE_DATE_EPOCH": epoch})
    if run.code != 0:
        return case.refused(run, (USAGE, RUNTIME), "SOURCE_DATE_EPOCH")
    history = str(maps.read(case.path("out.nc"))[1]["history"])
    check(re.match(r"\d{4}-\d\d-\d\dT", history), f"a year of four digits: {history[:60]!r}")
    return RIGHT


FAULTS = [without_proc, planted_link, keeps_mode, two_outputs_one_file, page_over_its_input, limited_files_do_not_end_pipes,
          nothing_on_standard_input, shared_memory, one_of_them, strange_date, strange_date]


# ---- relatives, at random ----


def truncated_pipe(case):
    """The first bytes of a dataset are no dataset."""
    inputs(case, ("g.nc",))
    whole = case.path("g.nc").read_bytes()
    part = whole[:int(case.rng.integers(0, len(whole)))]
    command = case.one_of(("stats",), ("acf", "--result", "lengths"), ("psd", "--result", "radial"), ("pdf",), ("contact", *PRESS), ("convert",
                                                                                                                 ),
                          ("report",), ("stress", "--depths", "1um"), ("plot", "--kind", "map", "--to", "svg", "-o",
                                                                       "-"))
    return case.refused(case.run(*command, stdin=part), BAD_DATA)


def full_device(case):
    """What cannot be written is not passed over."""
    command = case.one_of(*WRITES_DATASET, *WRITES_TEXT)
    inputs(case, command)
    if command[0] == "plot" or case.chance(0.5):
        run = case.shell("exec " + line(command + (("-o", "-") if command[0] == "plot" else ())) + " > /dev/full")
    else:
        run = case.shell("exec " + line(command) + " -o /dev/full")
    case.asked_of_all(run, command[0])
    no_litter(case)
    return case.refused(run, RUNTIME)


def closed_output(case):
    """A closed standard output fails, or is not needed: it is never another file."""
    command = case.one_of(*WRITES_DATASET, *WRITES_TEXT)
    inputs(case, command)
    more = ("-o", "-") if command[0] == "plot" else ()
    before = {name: case.path(name).read_bytes() for name in case.files()}
    run = case.shell("exec " + line(command + more) + " " + case.one_of(">&-", ">&- <&-", "<&- >&-"))
    check(run.code in (RUNTIME, USAGE), f"exit status 1 or 2, not {run.code}")
    check({name: case.path(name).read_bytes() for name in case.files()} == before, "no file is changed")
    return REFUSED


def reader_that_leaves(case):
    """The end of a pipe that is closed ends a tool by SIGPIPE, or in one line."""
    command = case.one_of(*WRITES_DATASET)
    inputs(case, command)
    run = case.shell(f"(exec {line(command)}; ) | head -c {int(case.rng.integers(0, 3000))} > /dev/null")
    check(run.code == 0 and "Traceback" not in run.err, f"a quiet end: {run.err!r}")
    no_litter(case)
    return RIGHT


def killed(case):
    """At any moment: the old file or the whole new one, and after a signal that can be handled no other."""
    large = ("generate", "--shape", "700x700", "--size", "700um", "--rq", "0.1um", "--length", "6px", "--seed", "1",
             "--threads", "1")
    old = case.chance(0.5)
    if old:
        case.path("out.nc").write_bytes(b"old")
    number = case.one_of(signal.SIGTERM, signal.SIGINT, signal.SIGKILL, signal.SIGHUP)
    case.lines.append(f"{line(large)} -o out.nc & kill -{int(number)} $!")
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen([f"{case.bin}/asperity-generate", *large[1:], "-o", "out.nc"], cwd=case.folder,
                                   stderr=said,
                                   stdin=subprocess.DEVNULL, env=case.environment(None))
        time.sleep(case.rng.uniform(0, 0.35))
        process.send_signal(number)
        code = process.wait(60)
    check(code in (0, -number), f"an end by signal {int(number)} or before it, not {code}")
    content = case.path("out.nc").read_bytes() if case.path("out.nc").exists() else None
    if content not in (None, b"old"):
        check(maps.read(case.path("out.nc"))[0]["heights"].shape == (700, 700), "the whole new file")
    check(content is not None or not old, "the old file, if not the new one")
    if number != signal.SIGKILL:
        no_litter(case, "out.nc")
    return RIGHT


def limited_file(case):
    """A file that may not grow fails in a line or by SIGXFSZ, and leaves the old one."""
    command = case.one_of(("generate", "--shape", "128x128", *DRAW[3:]), ("generate", "--shape", "100x128", *DRAW[3:],
                                                                          "--exact-rq"))
    old = case.chance(0.5)
    if old:
        case.path("out.nc").write_bytes(b"old")
    run = case.raw(*command, "-o", "out.nc", limits=(f"f{int(case.rng.integers(0, 100))}",))
    check(run.code in (RUNTIME, -signal.SIGXFSZ, 128 + signal.SIGXFSZ), f"a failure, not {run.code}: {run.err!r}")
    no_litter(case, "out.nc")
    check(case.path("out.nc").exists() == old and (not old or case.path("out.nc").read_bytes() == b"old"),
          "the old file alone")
    return REFUSED


def output_is_input(case):
    """A dataset may replace its own input, as through a pipe into another file."""
    command = case.one_of(("contact", "g.nc", *PRESS), ("acf", "g.nc"), ("psd", "g.nc"),
                          ("convert", "g.nc"),
                          ("stress", "c.nc", "--depths", "1um,2um"))
    inputs(case, command)
    env = {"SOURCE_DATE_EPOCH": "0"}
    run = case.run(*command, "--no-history", "-o", "other.nc", env=env)
    check(run.code in (0, 3), f"a dataset: {run.err!r}")
    case.run(*command, "--no-history", "-o", command[1], env=env)
    check(case.path(command[1]).read_bytes() == case.path("other.nc").read_bytes(), "the bytes that another file gets")
    no_litter(case, "other.nc")
    return RIGHT


def linked_output(case):
    """A link to the output stays a link, and what it points to is replaced; a hard link keeps the old."""
    inputs(case, ("g.nc",))
    case.path("there").mkdir()
    case.path("there/real.nc").write_bytes(b"old")
    if case.chance(0.5):
        case.path("out.nc").symlink_to(case.one_of("there/real.nc", str(case.path("there/real.nc"))))
        case.done("convert", "g.nc", "-o", "out.nc")
        check(case.path("out.nc").is_symlink(), "a link that stays one")
        check(case.path("there/real.nc").stat().st_size > 100, "a new file where it points")
    else:
        os.link(case.path("there/real.nc"), case.path("out.nc"))
        case.done("convert", "g.nc", "-o", "out.nc")
        check(case.path("there/real.nc").read_bytes() == b"old", "the old bytes under the other name")
    no_litter(case, "out.nc", "there")
    check(os.listdir(case.path("there")) == ["real.nc"], "nothing else beside it")
    return RIGHT


def strange_names(case):
    """Names of files with blanks, quotes, patterns and escapes are names."""
    inputs(case, ("g.nc",))
    name = case.one_of("a b.nc", "it's.nc", 'say "x".nc', "-x.nc", "*.nc", "a;b.nc", "$(x).nc", "%d.nc", "ü.nc", "a\\b.nc",
                       "[a].nc", "a,b.nc")
    given = "./" + name
    case.done("convert", "g.nc", "-o", given)
    check(name in case.files(), f"a file of the name {name!r}: {case.files()}")
    run = case.run("stats", given)
    check(run.code == 0, f"{name!r} is read: {run.err!r}")
    no_litter(case, name)
    return RIGHT


def control_characters_in_names(case):
    """A name that is not there is told without its escapes."""
    name = "".join(chr(int(c)) for c in case.rng.integers(1, 32, 5)) + "\x1b]0;pwned\x07" + case.one_of(".nc", "", "\u202e",
                                                                                                        "\x9b31m")
    tool = case.one_of("stats", "acf", "psd", "pdf", "contact", "convert", "report", "stress", "validate", "plot")
    more = {"contact": PRESS, "plot": ("--kind", "map", "-o", "x.png"), "stress": ("--depths", "1um")}.get(tool, ())
    return case.refused(case.run(tool, name.replace("/", "_"), *more), (RUNTIME, USAGE))


def unwritable(case):
    """A folder that is not there, a folder in place of a file: one line, exit status 1 or 2."""
    command = case.one_of(*WRITES_DATASET, *WRITES_TEXT)
    inputs(case, command)
    case.path("folder").mkdir()
    extension = {"plot": ".png", "report": ".html"}.get(command[0], "")
    name = case.one_of("nowhere/out" + extension, "folder", "folder/", "g.nc/out" + extension)
    arguments = [a for a in command if a not in ("--to", "svg")] if command[0] == "plot" else command
    run = case.run(*arguments, "-o", name)
    no_litter(case, "folder")
    check(not os.listdir(case.path("folder")), "an empty folder")
    return case.refused(run, (RUNTIME, USAGE))


def empty_input(case):
    """Nothing at all, through a pipe, from /dev/null or from an empty file."""
    command = case.one_of(("stats",), ("acf", "--result", "lengths"), ("psd", "--result", "radial"), ("pdf",), ("contact", *PRESS), ("convert",
                                                                                                                 ),
                          ("report",), ("stress", "--depths", "1um"), ("plot", "--kind", "map", "--to", "svg", "-o",
                                                                       "-"))
    case.path("empty.nc").write_bytes(b"")
    run = case.run(*command, "empty.nc") if case.chance(0.5) else case.run(*command, stdin=b"")
    return case.refused(run, BAD_DATA)


def odd_pipes(case):
    """A pipe that is slow, in pieces of any size, carries what a file carries."""
    inputs(case, ("g.nc",))
    size = int(case.rng.integers(1, 4000))
    case.path("slow").write_text("import sys\nd = open('g.nc', 'rb').read()\n"
                                 f"for i in range(0, len(d), {size}):\n"
                                 f"    sys.stdout.buffer.write(d[i:i + {size}])\n    sys.stdout.flush()\n")
    piped = case.shell("/usr/bin/python3 slow | asperity-stats --json")
    check(piped.out == case.done("stats", "--json", "g.nc").out, "what the file gives")
    return RIGHT


FAMILIES = [truncated_pipe, truncated_pipe, full_device, full_device, closed_output, reader_that_leaves, killed, killed,
            killed,
            limited_file, output_is_input, linked_output, strange_names, control_characters_in_names, unwritable,
            empty_input,
            odd_pipes, strange_date, keeps_mode, two_outputs_one_file]
