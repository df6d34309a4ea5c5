"""Families of the class data: whole maps, as any program may write them."""
import netCDF4
import numpy as np

import maps
from bench import BAD_DATA, RIGHT, USAGE, check
from readings import CONTACT, close, independent, same_array, same_numbers


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


def integers(case):
    """Whole numbers of a unit, of every type that there is."""
    kind = case.one_of("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8")
    classic = kind in ("i1", "i2", "i4")
    low, high = (0, 200) if kind[0] == "u" else (-100, 100)
    stored = case.rng.integers(low, high, (9, 7)).astype(kind)
    surface = maps.Surface(stored.astype(float) * 1e-9, 1e-6, 1e-6)
    maps.write_netcdf(case.path("in.nc"), surface, kind=kind, raw=stored, unit="nm", order=case.one_of("xy", "yx"),
                      format=case.one_of("NETCDF3_64BIT_OFFSET", "NETCDF4") if classic else
                      case.one_of("NETCDF3_64BIT_DATA", "NETCDF4"))
    return same_numbers(case, "in.nc", surface)


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


def mask_of_any_kind(case):
    """A mask of bytes, integers or floats, on (x, y) or (y, x), hides what it hides."""
    surface = maps.random_surface(case.rng, (9, 7))
    hidden = case.rng.random((9, 7)) < 0.2
    hidden[0, 0] = True
    order = case.one_of("xy", "yx")
    maps.write_netcdf(case.path("in.nc"), surface, order=order)
    with netCDF4.Dataset(case.path("in.nc"), "a") as data:
        other = case.one_of("xy", "yx")
        mask = data.createVariable("mask", case.one_of("i1", "i2", "i4", "f4", "f8"), tuple(other))
        mask[:] = hidden if other == "xy" else hidden.T
    shown = maps.Surface(np.where(hidden, np.nan, surface.z), surface.dx, surface.dy)
    return same_numbers(case, "in.nc", shown, refusal=("mask",) if other != order else ())


def odd_axes(case):
    """Uneven, repeated, infinite or missing coordinates are refused by name; those of single precision are even enough."""
    surface = maps.random_surface(case.rng, (17, 9))
    maps.write_netcdf(case.path("in.nc"), surface, length=case.one_of("right", "none"))
    axis, way = case.one_of("x", "y"), case.one_of("uneven", "repeated", "nan", "inf", "zero", "offset", "no unit",
                                                   "of pascals")
    with netCDF4.Dataset(case.path("in.nc"), "a") as data:
        points = data[axis][:]
        if way == "offset":
            data[axis][:] = points + 1e-3
        elif way == "no unit":
            data[axis].delncattr("units")
        elif way == "of pascals":
            data[axis].units = "Pa"
        else:
            points[3] = {"uneven": points[3] + 0.3 * (points[1] - points[0]), "repeated": points[2], "nan": np.nan,
                         "inf": np.inf}.get(way, 0)
            data[axis][:] = points * (way != "zero")
    if way == "offset":
        return same_numbers(case, "in.nc", surface)
    run = case.run("stats", "in.nc", "--parameters", "hybrid")
    return case.refused(run, BAD_DATA, f" {axis}")


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
    to = case.one_of("npy", "nrrd", "sdf", "sdf-ascii", "esri", "x3p", "text", "gwyddion-text", "gsf", "gwy")
    name = "out." + {"sdf-ascii": "sdf", "esri": "asc", "text": "txt", "gwyddion-text": "txt"}.get(to, to)
    run = case.run("convert", "in.nc", "--to", to, "-o", name)
    if run.code != 0:
        return case.refused(run, BAD_DATA)
    options = maps.told_size(surface) if to == "npy" else []
    single = 1e-7 if to == "gsf" else 1e-12
    same_array(case, name, surface, options, single)
    return RIGHT
