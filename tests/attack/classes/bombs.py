"""Nothing small makes a tool large: under limits of address space and of CPU time it ends by itself, with an answer or a line.

What is legitimately read takes three maps at the most beside the program's own.
"""
import gzip
import hashlib
import struct

import netCDF4
import numpy as np

import maps
from bench import BAD_DATA, NOT_CONVERGED, RIGHT, RUNTIME, TOOLS, USAGE, check
from classes.options import BASE, named_inputs

OWN = 130e6  # of program and libraries, buffers of pipes and of inflating, and of Python, from which a peak counts
TIGHT = ("t20", "v1500000")  # 20 seconds, 1.5 GB of addresses
DEEP = 50000


def ends(case, tool, *arguments, limits=TIGHT, peak=None, codes=(0, RUNTIME, USAGE, NOT_CONVERGED, BAD_DATA)):
    run = case.run(tool, *arguments, limits=limits)
    check(run.code in codes, f"an exit status of {codes}, not {run.code}: {run.err.strip()[:300]!r}")
    check(peak is None or run.peak <= peak, f"at most {(peak or 0) / 1e6:.0f} MB, not {run.peak / 1e6:.0f} MB")
    return run.verdict()


# ---- faults that there have been ----


def range_of_one_ulp(case):
    """Heights that differ by a rounding have an axis all the same."""
    z = np.full((12, 10), case.one_of(1e-6, -3e-7, 1.0, 1e-300))
    z[3:5, 2:7] = np.nextafter(z[0, 0], np.inf)
    maps.write_netcdf(case.path("in.nc"), maps.Surface(z, 1e-6, 1e-6))
    command = case.one_of(("report", "-o", "out.html"), *(("plot", "--kind", k, "-o", "out.png") for k in ("map", "surface",
                                                                                                           "profile",
                                                                                                           "pdf")))
    return ends(case, command[0], "in.nc", *command[1:], codes=(0, BAD_DATA))


def deep_key(case, tool=None):
    """A key or a value that is nested without end is refused by its line."""
    tool = tool or case.one_of(*TOOLS)
    depth = DEEP
    text = case.one_of(".".join("a" * depth) + " = 1\n", "a = " + "[" * depth + "]" * depth + "\n",
                       "[" + ".".join("a" * depth) + "]\nb = 1\n",
                       "a = " + "{a = " * depth + "1" + "}" * depth + "\n", "[[" + ".".join("a" * depth) + "]]\n")
    case.path("deep.toml").write_text(text)
    return ends(case, tool, "--config", "deep.toml", codes=(USAGE,))


def solver_out_of_memory(case):
    """Wherever memory ends in the solution of a kernel, it ends in a line."""
    lags = int(case.rng.integers(250, 500))
    limit = int(95000 + case.rng.uniform(0, 0.4) * lags**2)  # kB: about what the vectors of the solver take
    return ends(case, "kernel", "--length", f"{lags // 4}px", "--lags", f"{lags}x{lags}", "--infeasible", "nearest",
                "-o", "k.nc", limits=("t60", f"v{limit}"))


def x3p_bomb(case):
    """A large map in a small archive takes three maps at the most, and one that is not as large as it says nothing."""
    side = case.one_of(2000, 2896)

    def make():
        values = bytes(8 * side * side)
        main = maps.x3p_document(side, side, 1e-6, 1e-6, hashlib.md5(values).hexdigest())
        case.path("in.x3p").write_bytes(maps.zipped({"main.xml": main, "bindata/data.bin": values}))

    case.apart(make)
    return ends(case, "convert", "in.x3p", "-o", "out.npy", peak=3 * 8 * side**2 + OWN)


def x3p_of_more(case, which=None):
    """Members of which nothing is wanted, or much more than the map needs, are not unpacked whole."""
    which = which or case.one_of("md5checksum.hex", "bindata/data.bin", "main.xml", "other")

    def make():
        values = np.zeros((4, 4)).tobytes()
        main = maps.x3p_document(4, 4, 1e-6, 1e-6, hashlib.md5(values).hexdigest())
        members = {"main.xml": main, "bindata/data.bin": values,
                   "md5checksum.hex": hashlib.md5(main).hexdigest() + " *main.xml\n"}
        members[which] = main + b" " * (256 << 20) if which == "main.xml" else bytes(256 << 20)
        case.path("in.x3p").write_bytes(maps.zipped(members))

    case.apart(make)
    return ends(case, "convert", "in.x3p", "-o", "out.npy", peak=OWN)


def checksum_bomb(case):
    return x3p_of_more(case, "md5checksum.hex")


def nrrd_bomb(case):
    """gzip that yields more than the sizes say is refused before it is inflated whole."""
    nx, ny = case.one_of((4, 4), (1000, 1000), (2000, 3000))
    head = (f"NRRD0004\ntype: double\ndimension: 2\nsizes: {nx} {ny}\nspacings: 1e-6 1e-6\nunits: \"m\" \"m\"\n"
            "sample units: \"m\"\nendian: little\nencoding: gzip\n\n").encode()
    case.apart(lambda: case.path("in.nrrd").write_bytes(head + gzip.compress(bytes(256 << 20), 1)))
    return ends(case, "convert", "in.nrrd", "-o", "out.npy", peak=3 * 8 * nx * ny + OWN)


def netcdf4_map(path, side, written):
    with netCDF4.Dataset(path, "w") as data:
        for axis in "xy":
            data.createDimension(axis, side)
            at = data.createVariable(axis, "f8", (axis,), zlib=True)
            at[:] = maps.cell_centres(side, 1e-6)
            at.units = "m"
        z = data.createVariable("heights", "f8", ("x", "y"), zlib=True, chunksizes=(min(side, 512), min(side, 512)))
        z.units = "m"
        if written:
            z[:] = 0
        else:
            z[0, :3] = 0
    return path


def netcdf4_bomb(case):
    """A deflated map takes three maps at the most."""
    side = case.one_of(2000, 2896)
    case.apart(lambda: netcdf4_map(case.path("in.nc"), side, True))
    return ends(case, "convert", "in.nc", "-o", "out.npy", peak=3 * 8 * side**2 + OWN)


def netcdf4_that_is_huge(case):
    """A file of some kB that says it has billions of heights is refused in time."""
    netcdf4_map(case.path("in.nc"), case.one_of(20000, 60000, 200000), False)
    tool = case.one_of(("stats",), ("convert", "-o", "out.npy"), ("contact", *BASE["contact"][1:]))
    return ends(case, tool[0], "in.nc", *tool[1:], codes=(RUNTIME, BAD_DATA))


ENDLESS = [("contact", "--sweep", "1N:5N:1000000000"), ("stress", "--depths", "0:1mm:1000000000"), ("pdf", "--bins",
                                                                                                    "100000000"),
           ("plot", "--pixels", "30000x30000"), ("contact", "--sweep", "1N:5N:2147483647"), ("stress", "--depths",
                                                                                             "0:1mm:99999999"),
           ("pdf", "--estimate=kernel", "--rows", "100000000"), ("pdf", "--estimate=quantiles", "--rows", "1000000000"),
           ("pdf", "--bins", "2147483647"), ("plot", "--pixels", "1x2000000000"), ("plot", "--columns", "2000000000"),
           ("stats", "--threads", "1000000000"), ("generate", "--shape", "2000000000x2000000000"), ("kernel", "--lags",
                                                                                                    "100000x100000"),
           ("kernel", "--length", "1000000px"), ("acf", "--max-lag", "1000000000x1000000000"), ("kernel", "--shape",
                                                                                                "2000000000x2000000000")]


def endless(case, number=None):
    """Lists, bins and pixels beyond all use are refused by their option."""
    tool, *given = ENDLESS[number] if number is not None else case.one_of(*ENDLESS)
    arguments = list(BASE[tool])
    if given[-2] == "--shape" or given[-2] == "--depths" or given[-2] == "--length":
        at = arguments.index(given[-2]) if given[-2] in arguments else None
        arguments = arguments if at is None else arguments[:at] + arguments[at + 2:]
    if "--sweep" in given:
        at = arguments.index("--load")
        arguments = arguments[:at] + arguments[at + 2:-2] + ["-o", "out.tsv"]
    if given[-2:] == ["--pixels", "30000x30000"]:
        arguments[-1] = "out.png"
    if tool == "kernel" and given[0] == "--shape":
        arguments = ["--length", "4px", "--size", "1mm", "-o", "out.nc"]
    named_inputs(case, arguments)
    run = case.run(tool, *arguments, *given, limits=TIGHT)
    if run.code == 0:
        check(given[-2] in ("--threads", "--max-lag", "--columns", "--shape"), f"a refusal of {given}")
        return RIGHT
    if given[-2] == "--threads":  # which the limit of addresses may refuse as well
        return case.refused(run, (USAGE, RUNTIME))
    return case.refused(run, USAGE, "--")


def endless_number(number):
    def fault(case):
        return endless(case, number)
    fault.__name__ = "endless_" + ENDLESS[number][-2].strip("-")
    return fault


FAULTS = [range_of_one_ulp, range_of_one_ulp, deep_key, deep_key, deep_key, solver_out_of_memory, solver_out_of_memory,
          x3p_bomb,
          checksum_bomb, nrrd_bomb, netcdf4_bomb, *map(endless_number, range(4))]


# ---- relatives, at random ----


def lying_head(case):
    """A head that promises more than the file holds costs nothing."""
    nx, ny = (int(case.one_of(40000, 100000, 2**31 - 1, 2**32, 10**12, 65535)) for _ in range(2))
    array = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({nx}, {ny}), }}".ljust(117) + "\n"
    heads = {"in.npy": b"\x93NUMPY\x01\0" + struct.pack("<H", 118) + array.encode() + bytes(80),
             "in.gsf": f"Gwyddion Simple Field 1.0\nXRes = {nx}\nYRes = {ny}\nZUnits = m\n".encode() + bytes(84),
             "in.nrrd": (f"NRRD0004\ntype: double\ndimension: 2\nsizes: {nx} {ny}\nencoding: raw\nendian: little\n\n".encode()
                         + bytes(80)),
             "in.asc": f"ncols {nx}\nnrows {ny}\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n".encode(),
             "in.sdf": (f"aISO-1.0\nNumPoints = {nx}\nNumProfiles = {ny}\nXscale = 1e-6\nYscale = 1e-6\nZscale = 1\n"
                        "DataType = 7\n*\n1 2 3\n").encode(),
             "in.x3p": maps.zipped({"main.xml": maps.x3p_document(nx, ny, 1e-6, 1e-6, "0" * 32),
                                    "bindata/data.bin": bytes(80)})}
    name, content = case.one_of(*heads.items())
    case.path(name).write_bytes(content)
    options = ["--size", "1mm"] if name == "in.npy" else []
    return ends(case, "convert", name, *options, "-o", "out.nc", peak=OWN, codes=(BAD_DATA, USAGE))


def legitimate(case):
    """What is rightly read takes three maps at the most, of any format, by a tool that only reads."""
    side = int(case.rng.integers(1200, 2200))
    name = case.one_of("in.nc", "in.nc4", "in.npy", "in.gsf", "in.nrrd", "in.sdf", "in.x3p")

    def make():
        surface = maps.Surface(case.rng.normal(size=(side, side)) * 1e-7, 1e-6, 1e-6)
        if name.startswith("in.nc"):
            maps.write_netcdf(case.path(name), surface, format="NETCDF4" if name == "in.nc4" else "NETCDF3_64BIT_OFFSET")
            return []
        content, options = maps.FORMATS[name[3:]](surface, case.rng)
        case.path(name).write_bytes(content)
        return options

    options = case.apart(make)
    out = case.one_of("out.npy", "out.nc")
    return ends(case, "convert", name, *options, "-o", out, peak=3 * 8 * side**2 + OWN, codes=(0,))


def any_memory(case):
    """Under any limit of addresses a tool does its work or says that there is not enough."""
    tool = case.one_of(*[t for t in TOOLS if t not in ("plot", "report")])
    named_inputs(case, BASE[tool])
    run = case.run(tool, *BASE[tool], limits=("t20", f"v{int(case.rng.integers(120, 500)) * 1000}"))
    return run.verdict()


def many_members(case):
    """An archive of many names, and deep XML."""
    depth, deep = int(case.rng.integers(1000, 300000)), case.chance(0.5)

    def make():
        members = {"main.xml": b"<a>" * depth + b"</a>" * depth} if deep else {f"{i}.bin": b"" for i in range(20000)}
        case.path("in.x3p").write_bytes(maps.zipped(members))

    case.apart(make)
    return ends(case, "convert", "in.x3p", "-o", "out.nc", peak=OWN, codes=(BAD_DATA,))


def long_lists(case):
    """A list of very many values on the command line, or in a file, is read in its own size."""
    tool, name, item = case.one_of(("stress", "--depths", "1um"), ("contact", "--sweep", "1mN"), ("stats", "--quantiles",
                                                                                                  "0.5"),
                                   ("acf", "--levels", "0.5"), ("stats", "--parameters", "height"), ("plot", "--labels",
                                                                                                        "a"))
    arguments = list(BASE[tool])
    if name == "--sweep":
        at = arguments.index("--load")
        arguments = arguments[:at] + arguments[at + 2:-2] + ["-o", "out.tsv"]
    if name in arguments:
        at = arguments.index(name)
        arguments = arguments[:at] + arguments[at + 2:]
    named_inputs(case, arguments)
    case.path("list.toml").write_text(f'{name[2:]} = "{",".join([item] * int(case.rng.integers(10000, 60000)))}"\n')
    return ends(case, tool, *arguments, "--config", "list.toml", limits=("t60", "v3000000"))


def strange_scales(case):
    """Heights at the ends of what a double holds have figures, numbers, or a reason."""
    z = case.rng.normal(size=(12, 10)) * case.one_of(1e-300, 1e300, 1e-320, 1e150, 1e-160) + case.one_of(0, 0, 1, 1e10)
    maps.write_netcdf(case.path("in.nc"), maps.Surface(z, case.one_of(1e-6, 1e-300, 1e300), 1e-6))
    command = case.one_of(("plot", "--kind", "map", "-o", "out.svg"), ("plot", "--kind", "surface", "-o", "out.svg"),
                          ("report", "-o", "o.html"),
                          ("stats", "--parameters", "all"), ("pdf",), ("acf", "--result", "lengths"), ("psd", "--result", "radial"))
    return ends(case, command[0], "in.nc", *command[1:], limits=("t30", "v3000000"))


FAMILIES = [range_of_one_ulp, deep_key, solver_out_of_memory, x3p_of_more, nrrd_bomb, netcdf4_bomb, netcdf4_that_is_huge,
            endless,
            lying_head, lying_head, legitimate, any_memory, any_memory, any_memory, many_members, long_lists,
            strange_scales]
