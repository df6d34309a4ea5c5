"""Files of strangers: what is read has the numbers that NumPy reads, or is refused in a line that names what is wrong."""
import json

import netCDF4
import numpy as np

import maps
from bench import BAD_DATA, RIGHT, USAGE, check
from readings import close, independent, same_array, same_numbers, whole_xml

CONTACT = ("--radius", "1mm", "--young", "200GPa", "--poisson", "0.3", "--load", "10mN")


# ---- faults that there have been ----


def stale_length(case):
    """A cut of a dataset keeps the attribute length of the whole: the coordinates win."""
    surface = maps.random_surface(case.rng, (16, 12))
    return same_numbers(case, maps.write_netcdf(case.path("in.nc"), surface, length="stale"), surface, refusal=("length",))


def stale_length_under_load(case):
    surface = maps.random_surface(case.rng, (16, 12), dx=1e-6)
    maps.write_netcdf(case.path("in.nc"), surface, length="stale")
    run = case.run("contact", *CONTACT, "in.nc", "-o", "out.nc")
    if run.code != 0:
        return case.refused(run, BAD_DATA, "length")
    p = maps.read(case.path("out.nc"))[0]["pressure"]
    check(close(p.sum() * surface.dx * surface.dy, 0.01, 1e-9),
          f"the load of 10 mN, not {p.sum() * surface.dx * surface.dy!r} N")
    check(run.told(), "a warning that says whose length is taken")
    return RIGHT


def packed(case, rule):
    """Heights under one of CF's rules for what is stored: scale_factor and add_offset, and every way to be missing."""
    rng, shape = case.rng, (13, 8)
    steps = rng.integers(-2000, 2000, shape)
    scale, offset = (10.0 ** -rng.integers(9, 11), 1e-7) if rule in ("scale", "offset") or case.chance(0.3) else (1e-9, 0)
    if rule == "scale":
        offset = 0
    kind = "i4" if rule == "default" else case.one_of("i2", "i4", "f4", "f8")
    extra = {"scale_factor": scale} if scale != 1 else {}
    if offset:
        extra["add_offset"] = offset
    missing = np.zeros(shape, bool)
    stored = steps.astype(kind)
    typed = stored.dtype.type
    holes = rng.random(shape) < 0.2
    if rule == "_FillValue" or rule == "missing_value":
        stored[holes], missing, extra[rule] = typed(-9999), holes, typed(-9999)
    elif rule == "list":
        other = rng.random(shape) < 0.2
        stored[holes], stored[other] = typed(-9999), typed(-8888)
        missing, extra["missing_value"] = holes | other, np.array([-9999, -8888], kind)
    elif rule.startswith("valid"):
        low, high = typed(-1500), typed(1500)
        missing = (stored < low if rule != "valid_max" else False) | (stored > high if rule != "valid_min" else False)
        extra.update({"valid_range": np.array([low, high], kind)} if rule == "valid_range" else
                     {rule: low if rule == "valid_min" else high})
    elif rule == "default":
        stored[holes], missing = typed(netCDF4.default_fillvals[kind]), holes
    surface = maps.Surface(np.where(missing, np.nan, stored.astype(float) * scale + offset), 1e-6, 1e-6)
    maps.write_netcdf(case.path("in.nc"), surface, kind=kind, raw=stored, extra=extra,
                      format=case.one_of("NETCDF3_64BIT_OFFSET", "NETCDF4"))
    verdict = same_numbers(case, "in.nc", surface, relative=1e-6 if "f4" in kind else 1e-9, refusal=("heights",))
    if missing.any() and verdict == RIGHT:  # what cannot leave points out refuses them
        case.refused(case.run("contact", *CONTACT, "in.nc", "-o", "out.nc"), BAD_DATA, "heights")
    return verdict


def rule(name):
    def fault(case):
        return packed(case, name)
    fault.__name__ = "packed_" + name
    return fault


def never_written(case):
    """The default fill of NetCDF, 9.97e36, of heights that were never written, is no height."""
    surface = maps.random_surface(case.rng, (9, 7))
    stored = surface.z.copy()
    stored[2:4, 3] = netCDF4.default_fillvals["f8"]
    surface.z[2:4, 3] = np.nan
    maps.write_netcdf(case.path("in.nc"), surface, raw=stored)
    return same_numbers(case, "in.nc", surface, refusal=("heights",))


def stress_of(case, name):
    run = case.run("stress", name, "--depths", "1um,3um", "--components", "zz,von_mises", "-o", "s-" + name)
    return run, maps.read(case.path("s-" + name))[0]["stress_zz"] if run.code == 0 else None


def pressure_in(case, unit, factor):
    """A pressure in this unit is that pressure in Pa, or is refused by its name."""
    surface, p, attributes = maps.pressed(case.rng)
    maps.write_netcdf(case.path("pa.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    other = p / (factor or 1)
    maps.write_netcdf(case.path("other.nc"), surface, fields={"pressure": (other, unit)}, attributes=attributes)
    _, expected = stress_of(case, "pa.nc")
    check(expected is not None, "the stress below a pressure in Pa")
    run, found = stress_of(case, "other.nc")
    if run.code != 0:
        check(factor is None or unit in ("psi", None), f"a conversion of {unit!r}: {run.err.strip()!r}")
        return case.refused(run, BAD_DATA, "pressure")
    check(factor is not None, f"a refusal of a pressure in {unit!r}")
    check(close(found, expected, 1e-9, 1e-9 * abs(expected).max()), f"the same stress for a pressure in {unit} as in Pa")
    return RIGHT


def unit_of_pressure(unit, factor):
    def fault(case):
        return pressure_in(case, unit, factor)
    fault.__name__ = f"pressure_in_{unit}"
    return fault


def rescaled(path, name, unit, factor):
    """A variable of a dataset in another unit."""
    with netCDF4.Dataset(path, "a") as data:
        variable = data[name]
        variable.set_auto_maskandscale(False)
        variable[:] = variable[:] / (factor or 1)
        if unit is None:
            variable.delncattr("units")
        else:
            variable.units = unit


def unit_of_other_fields(case):
    """Lags, kernels, autocorrelations, counter bodies and depths in other units are converted, or refused by their name."""
    shape = ("--shape", "20x16", "--size", "20um,16um")
    case.done("kernel", "--length", "4px", "--spacing", "1um", "--rq", "0.1um", "-o", "k.nc")
    draw = ("generate", "--seed", "1", *shape, "-o", "out.nc")
    name, unit, factor, command = case.one_of(
        ("kernel", "nm", 1e-9, (*draw, "--kernel", "k.nc")), ("kernel", "Pa", None, (*draw, "--kernel", "k.nc")),
        ("acf_target", "nm2", 1e-18, (*draw, "--acf", "k.nc")), ("acf_target", "K", None, (*draw, "--acf", "k.nc")),
        ("p", "um", 1e-6, (*draw, "--acf", "k.nc")), ("q", "mm", 1e-3, (*draw, "--acf", "k.nc")))
    out = []
    for changed in (False, True):
        if changed:
            rescaled(case.path("k.nc"), name, unit, factor)
            if name in "pq":
                rescaled(case.path("k.nc"), "q" if name == "p" else "p", unit, factor)
        run = case.run(*command)
        if run.code != 0:
            check(changed, f"a surface: {run.err!r}")
            return case.refused(run, (BAD_DATA, USAGE),
                                "--rq" if "--rq" in run.err else name)  # of a table of no known variance
        out.append(maps.read(case.path("out.nc"))[0]["heights"])
    check(factor is not None, f"a refusal of {name} in {unit}")
    check(close(out[1], out[0], 1e-6, 1e-6 * abs(out[0]).max()), f"the same heights from {name} in {unit}")
    return RIGHT


def counter_in_other_units(case):
    """The second body's heights, in nm, on a grid in mm, with y first or descending, are those in metres."""
    surface, counter = (maps.random_surface(case.rng, (14, 11), dx=1e-6) for _ in range(2))
    counter.dy = surface.dy
    maps.write_netcdf(case.path("in.nc"), surface)
    maps.write_netcdf(case.path("one.nc"), counter)
    maps.write_netcdf(case.path("other.nc"), counter, unit=case.one_of("nm", "mm"), xy_unit=case.one_of("mm", "nm"),
                      order=case.one_of("xy", "yx"), down=case.one_of((), "x", "y"))
    found = []
    for name in ("one.nc", "other.nc"):
        case.done("contact", "in.nc", *CONTACT, "--tolerance", "1e-10", "--counter", name, "-o", "out.nc")
        found.append(maps.read(case.path("out.nc"))[0]["pressure"])
    check(close(found[1], found[0], 0, 1e-6 * found[0].max()), "the same pressures")
    return RIGHT


def negative_pressure(case):
    surface, p, attributes = maps.pressed(case.rng)
    p[1, 1] = -1e8
    maps.write_netcdf(case.path("pa.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    run, _ = stress_of(case, "pa.nc")
    return case.refused(run, BAD_DATA, "pressure")


def descending(case):
    """Descending coordinates, usual in rasters, place the points where they say: no lay and no place is mirrored."""
    surface, p, attributes = maps.pressed(case.rng, (12, 10))
    p[:] = 0
    p[8:10, 6:8] = 1e9  # in the corner of large x and y
    for name, down in (("up.nc", ()), ("down.nc", case.one_of("x", "y", ("x", "y")))):
        maps.write_netcdf(case.path(name), surface, fields={"pressure": (p, "Pa")}, attributes=attributes, down=down)
    found = []
    for name in ("up.nc", "down.nc"):
        run = case.run("stress", name, "--depths", "1um,3um", "--maximum", "-o", "s-" + name)
        if run.code != 0:
            return case.refused(run, BAD_DATA, "descend")
        found.append([float(maps.read(case.path("s-" + name))[1]["stress_max_" + a]) for a in "xy"])
    check(close(found[1], found[0]), f"the largest stress at {found[0]}, not at {found[1]}")
    return same_numbers(case, "down.nc", surface)


def control_characters(case):
    """Escapes in a unit or a name do not reach a terminal, nor a table."""
    surface = maps.random_surface(case.rng, (9, 7))
    unit = b"m\x1b]0;pwned\x07\x1b[31m\n" + bytes(case.rng.integers(1, 32, 4).astype("u1"))
    maps.write_with_raw_unit(case.path("in.nc"), surface, unit, name="other")
    for tool in (("stats", "--variable", "other"), ("acf", "--lengths", "--absolute", "--variable", "other"),
                 ("psd", "--radial", "--variable", "other"), ("stats", "--json", "--variable", "other")):
        run = case.run(*tool, "in.nc")
        check(not set(run.out) & set(b"\x1b\x07"), f"no escape on standard output of asperity-{tool[0]}")
    return RIGHT


def long_unit(case):
    """A unit of 100 kB does not make a message of 100 kB, which run() asks of all."""
    surface = maps.random_surface(case.rng, (9, 7))
    maps.write_with_raw_unit(case.path("in.nc"), surface, b"parsec" * 17000)
    return case.refused(case.run("stats", "in.nc"), BAD_DATA, "heights")


LATIN_MICRO = b"\xb5m"


def latin_unit(case, tool_options, field="heights"):
    """Latin-1 is no UTF-8: understood, or refused in words, but nothing malformed is written."""
    surface = maps.random_surface(case.rng, (9, 7))
    values = surface.z / 1e-6 if field == "heights" else surface.z
    maps.write_with_raw_unit(case.path("in.nc"), surface, LATIN_MICRO if field == "heights" else case.one_of(
        LATIN_MICRO, b"]]>", b"<&\">", b"]]><x/>"), name=field, fields={field: (values, b"")})
    run = case.run(*tool_options, "in.nc")
    if run.code != 0:
        check("json.exception" not in run.err and "utf8" not in run.err.lower(), f"words, not {run.err!r}")
        return case.refused(run, BAD_DATA, field)
    if tool_options[0] == "stats":
        found = json.loads(run.out)
        if field == "heights":
            check(close(found["Sq"]["value"], maps.parameters(surface)["Sq"]), "micrometres")
    elif "vti" in tool_options:
        whole_xml(case.path("out.vti"))
    return RIGHT


def latin_json(case):
    return latin_unit(case, ("stats", "--json", "--variable", "other"), "other")


def latin_heights(case):
    return latin_unit(case, ("stats", "--json"))


def odd_unit_in_vti(case):
    return latin_unit(case, ("convert", "--to", "vti", "-o", "out.vti"), "other")


def bad_poisson(case):
    """What a dataset says wrongly is bad data, by its name: not a wrong command line."""
    surface, p, attributes = maps.pressed(case.rng)
    attributes["contact_poisson"] = np.array([case.one_of(0.7, -3.0, float("nan"))] * 2)
    maps.write_netcdf(case.path("in.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    return case.refused(case.run("stress", "in.nc", "--depths", "1um", "-o", "out.nc"), BAD_DATA, "contact_poisson")


def profile_in_report(case):
    """1 x N is a surface too: a page and its pictures, or a reason."""
    n = int(case.rng.integers(20, 60))
    surface = maps.random_surface(case.rng, case.one_of((1, n), (n, 1)))
    maps.write_netcdf(case.path("in.nc"), surface)
    run = case.done("report", "in.nc", "-o", "out.html")
    page = case.path("out.html").read_text()
    check("</html>" in page and " nan " not in page, "a whole page")
    drawn = case.run("plot", "in.nc", "--kind", "profile", "-o", "out.svg")
    check(drawn.code == 0 and case.path("out.svg").read_text().rstrip().endswith("</svg>"), "a figure of the profile")
    return run.verdict()


def concatenated(case):
    """Of two datasets in one stream the second is not passed over in silence."""
    for name in ("a.nc", "b.nc"):
        maps.write_netcdf(case.path(name), maps.random_surface(case.rng, (9, 7)))
    run = case.run("stats", stdin=case.path("a.nc").read_bytes() + case.path("b.nc").read_bytes())
    if run.code != 0:
        return case.refused(run, (BAD_DATA, USAGE))
    check("warning" in run.err, "a word on the second dataset")
    return RIGHT


FAULTS = [stale_length, stale_length_under_load, *map(rule, ("scale", "offset", "_FillValue", "missing_value", "list",
                                                             "valid_range",
          "valid_min", "valid_max", "default")), never_written,
          unit_of_pressure("MPa", 1e6), unit_of_pressure("psi", 6894.757293168361), unit_of_pressure("m", None),
          unit_of_pressure(None, None), unit_of_other_fields, unit_of_other_fields, negative_pressure, descending,
          control_characters, long_unit, latin_json, latin_heights,
          odd_unit_in_vti, bad_poisson, profile_in_report, concatenated]


# ---- relatives, at random ----


def any_netcdf(case):
    """Types, units, orders, directions and lengths of NetCDF as others write it."""
    surface = maps.random_surface(case.rng)
    unit, kind = case.one_of(*maps.METRES), case.one_of("f8", "f8", "f4")
    surface.z = (surface.z / maps.METRES[unit]).astype(kind).astype(float) * maps.METRES[unit]
    single = 1 in surface.shape
    length = "right" if single else case.one_of("right", "none", "stale")
    maps.write_netcdf(case.path("in.nc"), surface, unit=unit, kind=kind, xy_unit=case.one_of("m", "um", "mm", "nm", "inch"),
                      order=case.one_of("xy", "yx"), down=case.one_of((), (), "x", "y", "xy"), length=length,
                      format=case.one_of("NETCDF3_CLASSIC", "NETCDF3_64BIT_OFFSET", "NETCDF3_64BIT_DATA", "NETCDF4",
                                         "NETCDF4_CLASSIC"))
    same_array(case, "in.nc", surface)
    return same_numbers(case, "in.nc", surface)


def any_packed(case):
    return packed(case, case.one_of("scale", "offset", "_FillValue", "missing_value", "list", "valid_range", "valid_min",
                                    "valid_max",
                                    "default"))


def masked(case):
    """A mask, NaN or a fill value: statistics leave points out, contact refuses them."""
    surface = maps.random_surface(case.rng, least=5)
    holes = case.rng.random(surface.shape) < 0.2
    holes.flat[0] = True
    whole = maps.Surface(surface.z.copy(), surface.dx, surface.dy)
    surface.z[holes] = np.nan
    way = case.one_of("mask", "nan", "fill")
    if way == "mask":
        maps.write_netcdf(case.path("in.nc"), whole, fields={"mask": (holes.astype("f8"), "1")})
    elif way == "nan":
        maps.write_netcdf(case.path("in.nc"), surface)
    else:
        maps.write_netcdf(case.path("in.nc"), surface, raw=np.where(holes, -5.0, whole.z), extra={"_FillValue": -5.0})
    case.refused(case.run("contact", *CONTACT, "in.nc", "-o", "out.nc"), BAD_DATA, "heights")
    return same_numbers(case, "in.nc", surface)


def any_format(case):
    """Every format of instruments, as its own page defines it."""
    name = case.one_of(*maps.FORMATS)
    surface = maps.random_surface(case.rng, least=3 if name == "txt" else 2)
    content, options = maps.FORMATS[name](surface, case.rng)
    extension = {"sdf-ascii": "sdf", "gwyddion": "txt"}.get(name, name)
    case.path("in." + extension).write_bytes(content)
    out = case.path("out.npy")
    case.done("convert", "in." + extension, *options, "-o", out)
    unit = 1e-15 / np.nanmax(abs(surface.z))
    check(close(np.load(out), surface.z, 1e-12, max(unit, 1e-12) * np.nanmax(abs(surface.z))),
          f"the numbers of this {name}")
    case.done("convert", "in." + extension, *options, "-o", "out.nc")
    axes = maps.read(case.path("out.nc"))[0]
    for axis, step in (("x", surface.dx), ("y", surface.dy)):
        if axes[axis].size > 1:
            check(close(np.diff(axes[axis]), step, 1e-6) or np.allclose(np.diff(axes[axis]), step, rtol=1e-6),
                  f"a spacing of {step!r} along {axis}")
    return RIGHT


def unit_of_any_field(case):
    """Pressure, gap and heights in any unit of their dimension; others are refused."""
    unit, factor = case.one_of(("MPa", 1e6), ("GPa", 1e9), ("kPa", 1e3), ("psi", 6894.757293168361), ("bar", 1e5), ("N/mm2",
                                                                                                                    1e6),
                               ("N m-2", 1), ("m", None), ("K", None), ("kg", None), (None, None))
    return pressure_in(case, unit, factor)


def mutated(case):
    """A valid file of which bytes are flipped, cut or inserted: read like NumPy does, or refused."""
    name = case.one_of("nc", "nc", "npy", "npy", *maps.FORMATS)
    surface = maps.random_surface(case.rng, (5, 4))
    if name == "nc":
        maps.write_netcdf(case.path("in.nc"), surface, format=case.one_of("NETCDF3_64BIT_OFFSET", "NETCDF3_CLASSIC",
                                                                          "NETCDF4"))
        content, options = case.path("in.nc").read_bytes(), []
    else:
        content, options = maps.FORMATS[name](surface, case.rng)
    content = maps.mutated(case, content)
    extension = {"sdf-ascii": "sdf", "gwyddion": "txt"}.get(name, name)
    case.path("in." + extension).write_bytes(content)
    run = case.run("convert", "in." + extension, *options, "-o", "out.npy", limits=("t20", "v4000000"))
    if run.code != 0:
        return case.refused(run, (BAD_DATA, USAGE))
    ours = np.load(case.path("out.npy"))
    check(not np.isinf(ours).any(), "nothing infinite")
    theirs = independent(name, content, options)
    if theirs is not None:
        check(close(ours, theirs, 1e-12), "the numbers that others read in it")
    return RIGHT


def written_and_read(case):
    """What one format is written to comes back the same."""
    surface = maps.random_surface(case.rng, least=2)
    maps.write_netcdf(case.path("in.nc"), surface)
    to = case.one_of("npy", "nrrd", "sdf", "sdf-ascii", "esri", "x3p", "text", "gwyddion-text", "gsf")
    name = "out." + {"sdf-ascii": "sdf", "esri": "asc", "text": "txt", "gwyddion-text": "txt"}.get(to, to)
    run = case.run("convert", "in.nc", "--to", to, "-o", name)
    if run.code != 0:
        return case.refused(run, BAD_DATA)
    options = ["--size", f"{surface.shape[0] * surface.dx!r}m,{surface.shape[1] * surface.dy!r}m"] if to in ("npy",
                                                                                                             "text") else []
    options += ["--heights", "--format", "text"] if to == "text" else []
    single = 1e-7 if to == "gsf" else 1e-12
    same_array(case, name, surface, options, single)
    return RIGHT


FAMILIES = [any_netcdf, any_netcdf, any_packed, unit_of_other_fields, counter_in_other_units, masked, any_format,
            any_format, unit_of_any_field, mutated, mutated, mutated,
            written_and_read, stale_length, descending, odd_unit_in_vti, latin_json, control_characters, concatenated,
            bad_poisson]
