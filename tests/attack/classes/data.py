"""Files of strangers: what is read has the numbers that NumPy reads, or is refused in a line that names what is wrong."""

import netCDF4
import numpy as np

import maps
from bench import BAD_DATA, RIGHT, USAGE, check, strict_json
from readings import CONTACT, close, same_numbers, whole_xml
from strangers import any_format, any_netcdf, integers, mask_of_any_kind, masked, mutated, odd_axes, written_and_read


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
    for tool in (("stats", "--variable", "other"), ("acf", "--result", "lengths", "--absolute", "--variable", "other"),
                 ("psd", "--result", "radial", "--variable", "other"), ("stats", "--json", "--variable", "other")):
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
        found = strict_json(run.out)
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


def packed_neighbours(case):
    """CF's rules hold for pressures, coordinates and counter bodies as for heights, or these are refused by name."""
    surface, p, attributes = maps.pressed(case.rng)
    maps.write_netcdf(case.path("one.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    _, expected = stress_of(case, "one.nc")
    name, scale, offset = case.one_of(("pressure", 1e6, 0), ("pressure", 1e3, 5e5), ("x", 1e-6, 0), ("y", 2.0, 1e-3))
    maps.write_netcdf(case.path("two.nc"), surface, fields={"pressure": ((p - offset) / scale if name == "pressure" else p,
                                                                         "Pa")},
                      attributes=attributes, length="none")
    with netCDF4.Dataset(case.path("two.nc"), "a") as data:
        data.set_auto_maskandscale(False)
        if name != "pressure":
            data[name][:] = (data[name][:] - offset) / scale
        data[name].scale_factor = scale
        if offset:
            data[name].add_offset = offset
    run, found = stress_of(case, "two.nc")
    if run.code != 0:
        return case.refused(run, BAD_DATA, name)
    check(close(found, expected, 1e-7, 1e-7 * abs(expected).max()),
          f"the stress that a packed {name} has when it is unpacked")
    return RIGHT


def orders_there_and_back(case):
    """A volume in the order of viewers, (z, y, x) and z upwards, is read as the volume that it was."""
    surface, p, attributes = maps.pressed(case.rng)
    maps.write_netcdf(case.path("in.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    case.done("stress", "in.nc", "--depths", case.one_of("0,1um,3um", "0:4um:5", "2um"), "--components", "von_mises,xz",
              "-o", "s.nc")
    case.done("convert", "s.nc", "--to-order", "yx", "-o", "yx.nc")
    case.done("convert", "yx.nc", "-o", "back.nc")
    one, back = (maps.read(case.path(name))[0] for name in ("s.nc", "back.nc"))
    check(close(np.abs(back["z"]), one["z"], 1e-12, 1e-20), "the depths")
    for name in ("heights", "pressure", "von_mises", "stress_xz"):
        check(close(back[name], one[name], 1e-12), f"{name} as it was")
    return RIGHT


def missing_pressure(case):
    """Of pressures that are missing, by whatever rule, no stress is made up."""
    surface, p, attributes = maps.pressed(case.rng)
    way = case.one_of("_FillValue", "missing_value", "default", "nan", "valid_max", "list")
    p[5, 5] = {"default": netCDF4.default_fillvals["f8"], "nan": np.nan, "valid_max": 9e12}.get(way, -9999.0)
    maps.write_netcdf(case.path("in.nc"), surface, attributes=attributes)
    with netCDF4.Dataset(case.path("in.nc"), "a") as data:
        variable = data.createVariable("pressure", "f8", ("x", "y"), fill_value=-9999.0 if way == "_FillValue" else None)
        variable.set_auto_maskandscale(False)
        variable.units, variable[:] = "Pa", p
        if way == "missing_value" or way == "list":
            variable.missing_value = np.array([-1.0, -9999.0]) if way == "list" else -9999.0
        if way == "valid_max":
            variable.valid_max = 5e12
    return case.refused(stress_of(case, "in.nc")[0], BAD_DATA, "pressure")


def any_packed(case):
    return packed(case, case.one_of("scale", "offset", "_FillValue", "missing_value", "list", "valid_range", "valid_min",
                                    "valid_max",
                                    "default"))


def unit_of_any_field(case):
    """Pressure, gap and heights in any unit of their dimension; others are refused."""
    unit, factor = case.one_of(("MPa", 1e6), ("GPa", 1e9), ("kPa", 1e3), ("psi", 6894.757293168361), ("bar", 1e5), ("N/mm2",
                                                                                                                    1e6),
                               ("N m-2", 1), ("m", None), ("K", None), ("kg", None), (None, None))
    return pressure_in(case, unit, factor)


FAMILIES = [any_netcdf, any_netcdf, any_packed, integers, packed_neighbours, missing_pressure, orders_there_and_back,
            mask_of_any_kind, odd_axes,
            unit_of_other_fields, counter_in_other_units, masked, any_format,
            any_format, unit_of_any_field, mutated, mutated, mutated,
            written_and_read, stale_length, descending, odd_unit_in_vti, latin_json, control_characters, concatenated,
            bad_poisson]
