"""What asperity-convert writes is read by other programs with the same numbers, sizes and units, and the other way round.

other_side.py ASPERITY-CONVERT CHECK      one of numpy, gdal, gwyddion, netcdf4; exit 77 where the other program is missing
"""
import os
import shutil
import struct
import subprocess
import sys
import tempfile

SKIPPED = 77
CONVERT = sys.argv[1]
DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data")
NX, NY, DX, DY = 5, 4, 6e-4, 5e-4  # of --size 3mm,2mm


def skip(what):
    print(f"SKIPPED: there is no {what}")
    sys.exit(SKIPPED)


try:
    import numpy as np
except ImportError:
    skip("python3-numpy")


def convert(source, target, *options):
    subprocess.run([CONVERT, source, "-o", target, *options], check=True)
    return target


def heights(missing=True):
    """(x, y) metres, of both signs and many sizes; one point missing."""
    z = np.random.default_rng(1).normal(size=(NX, NY)) * 10.0 ** np.arange(-9, -9 + NX)[:, None]
    if missing:
        z[3, 1] = np.nan
    return z


def our_array(source):
    return np.load(convert(source, "ours.npy"))


def our_spacing(source):
    """In metres, as the head of an NRRD states it."""
    with open(convert(source, "spacing.nrrd"), "rb") as file:
        line = next(line for line in file if line.startswith(b"spacings: "))
    return [float(word) for word in line.split()[1:]]


def same(a, b):
    return np.array_equal(a, b, equal_nan=True)


def check_numpy():
    whole = np.arange(NX * NY).reshape(NX, NY)
    for kind in ("<f8", ">f8", "<f4", ">f4", "<f2", "<i2", ">i4", "<i8", "i1", "u1", ">u2", "<u4", "<u8", "?"):
        for order in "CF":
            array = np.asarray(heights() if "f" in kind else whole % 2 if kind == "?" else whole, kind, order)
            np.save("theirs.npy", array)
            for indices, expected in (("xy", array), ("yx", array.T)):
                ours = np.load(convert("theirs.npy", "ours.npy", "--size", "3mm,2mm", "--from-order", indices))
                assert ours.dtype == np.dtype("<f8") and ours.flags.c_contiguous, (kind, order)
                assert same(ours, expected.astype(float)), (kind, order, indices)
    np.lib.format.write_array(open("second.npy", "wb"), heights(), version=(2, 0))
    assert same(np.load(convert("second.npy", "ours.npy", "--size", "3mm,2mm")), heights())


def check_gdal():
    try:
        from osgeo import gdal
    except ImportError:
        skip("python3-gdal")
    gdal.UseExceptions()
    gdal.SetConfigOption("AAIGRID_DATATYPE", "Float64")
    z = heights()
    np.save("z.npy", z)
    grid = gdal.Open(convert("z.npy", "ours.asc", "--size", "3mm,2mm"))
    band = grid.GetRasterBand(1)
    read = band.ReadAsArray()
    read[read == band.GetNoDataValue()] = np.nan
    assert same(read[::-1].T, z)  # their first row is the north
    _, dx, _, north, _, dy = grid.GetGeoTransform()
    assert np.allclose([dx, dy, north], [DX, -DY, NY * DY], rtol=1e-12), grid.GetGeoTransform()

    memory = gdal.GetDriverByName("MEM").Create("", NX, NY, 1, gdal.GDT_Float64)
    memory.SetGeoTransform((10, 2.5, 0, 20, 0, -0.75))
    memory.GetRasterBand(1).SetNoDataValue(-9999)
    memory.GetRasterBand(1).WriteArray(np.where(np.isnan(z), -9999, z).T[::-1])
    gdal.PushErrorHandler("CPLQuietErrorHandler")  # it warns of what is meant: that DX differs from DY
    gdal.GetDriverByName("AAIGrid").CreateCopy("theirs.asc", memory, options=["SIGNIFICANT_DIGITS=17"]).FlushCache()
    gdal.PopErrorHandler()
    assert same(our_array("theirs.asc"), z)
    assert np.allclose(our_spacing("theirs.asc"), [2.5, 0.75], rtol=1e-12)


def gwy_name(file, at):
    end = file.index(0, at)
    return file[at:end].decode(), end + 1


def gwy_array(file, at, kind):
    count, = struct.unpack_from("<I", file, at)
    return struct.unpack_from(f"<{count}{kind}", file, at + 4), at + 4 + count * struct.calcsize(kind)


def gwy_value(file, at, kind):
    if kind in "bidq":
        kind = "<" + {"b": "B"}.get(kind, kind)
        return struct.unpack_from(kind, file, at)[0], at + struct.calcsize(kind)
    if kind in "IDQC":
        return gwy_array(file, at, kind.lower())
    if kind == "s":
        return gwy_name(file, at)
    if kind == "o":
        return gwy_object(file, at)
    assert kind == "S", kind
    count, = struct.unpack_from("<I", file, at)
    at += 4
    strings = []
    for _ in range(count):
        string, at = gwy_name(file, at)
        strings.append(string)
    return strings, at


def gwy_object(file, at):
    """An object of a .gwy file: its name, the bytes of its components, and each with a name, a kind and a value."""
    _, at = gwy_name(file, at)
    end = at + 4 + struct.unpack_from("<I", file, at)[0]
    at += 4
    parts = {}
    while at < end:
        key, at = gwy_name(file, at)
        parts[key], at = gwy_value(file, at + 1, chr(file[at]))
    return parts, end


def read_by_gwyddion(*files):
    """Their channels of these files, as this script reads them: for each the field and the points that are masked."""
    at_home_here = {**os.environ, "HOME": os.getcwd()}
    subprocess.run(["gwyddion", "--convert-to-gwy=all.gwy", *files], check=True, env=at_home_here)
    with open("all.gwy", "rb") as file:
        bytes_ = file.read()
    assert bytes_[:4] == b"GWYP"
    channels, _ = gwy_object(bytes_, 4)
    for number in range(len(files)):
        field = channels[f"/{number}/data"]
        shape = field["yres"], field["xres"]
        field["values"] = np.array(field["data"]).reshape(shape).T
        mask = channels.get(f"/{number}/mask")
        field["masked"] = np.array(mask["data"]).reshape(shape).T > 0 if mask else np.zeros(shape[::-1], bool)
        yield field


def check_gwyddion():
    if not shutil.which("gwyddion"):
        skip("gwyddion")
    np.save("z.npy", heights())
    np.save("whole.npy", heights(missing=False))
    heights_of = ("--size", "3mm,2mm", "--unit", "m")
    files = [convert("z.npy", name, *heights_of) for name in ("a.gsf", "b.sdf", "c.nrrd", "d.x3p", "f.gwy")]
    files += [convert("whole.npy", "e.sdf", *heights_of, "--to", "sdf-ascii")]
    files += [convert("whole.npy", "g.sur", *heights_of)]
    half_a_step = np.ptp(heights(missing=False)) / 2**32 * 1.001
    for number, (name, field) in enumerate(zip(files, read_by_gwyddion(*files))):
        expected = heights(missing=name not in ("e.sdf", "g.sur"))
        exact = expected.astype("f4").astype(float) if name == "a.gsf" else expected
        assert field["values"].shape == (NX, NY), name
        assert np.allclose([field["xreal"], field["yreal"]], [3e-3, 2e-3], rtol=6e-8 if name == "g.sur" else 1e-12), name
        assert field["si_unit_xy"]["unitstr"] == field["si_unit_z"]["unitstr"] == "m", name
        theirs = np.where(field["masked"], np.nan, field["values"])
        if name == "g.sur":
            assert np.allclose(theirs, exact, rtol=1e-15, atol=half_a_step), name
        else:
            assert same(theirs, exact), name
        # And back: what they wrote, as this project reads it.
        again = np.load(convert("all.gwy", "ours.npy", "--channel", str(number)))
        assert same(again, theirs), name
        spacing = [field["xreal"] / NX, field["yreal"] / NY]
        convert("all.gwy", "ours.nrrd", "--channel", str(number))
        assert np.allclose(our_spacing("ours.nrrd"), spacing, rtol=4e-16, atol=0), name
        # In one step, through the program.
        assert same(np.load(convert(name, "ours.npy", "--from", "gwyddion", "--quiet")), theirs), name
    check_filled()
    for name in ("profiler-96x96.x3p", "iso-7x4.sdf"):
        check_both_ways_of(os.path.join(DATA, name))


def check_filled():
    """They have no missing values: the mean of the others is below the mask."""
    field, = read_by_gwyddion("f.gwy")
    assert field["masked"].sum() == 1
    assert np.isclose(field["values"][field["masked"]][0], np.nanmean(heights()), rtol=1e-14)
    assert np.isclose(field["xoff"], -1.5e-3, rtol=1e-12) and np.isclose(field["yoff"], -1e-3, rtol=1e-12)


def check_both_ways_of(path):
    """A measured file, read here and through their program: equal, with the same spacing."""
    ours, theirs = (np.load(convert(path, f"{way}.npy", "--quiet", *options))
                    for way, options in (("ours", ()), ("theirs", ("--from", "gwyddion"))))
    assert same(ours, theirs), path
    convert(path, "theirs.gwy", "--from", "gwyddion", "--quiet")
    assert np.allclose(our_spacing(path), our_spacing("theirs.gwy"), rtol=1e-12), path


def check_netcdf4():
    try:
        import netCDF4
    except ImportError:
        skip("python3-netcdf4")

    def check_ours(name, model):
        with netCDF4.Dataset(name) as data:
            assert data.data_model == model, data.data_model
            assert data["heights"].dimensions == ("x", "y") and data["heights"].units == "m"
            assert same(np.ma.filled(data["heights"][:].astype(float), np.nan), heights())
            for axis, n, step in (("x", NX, DX), ("y", NY, DY)):
                assert data[axis].units == "m" and np.isclose(data[axis].length, n * step, rtol=1e-12)
                assert np.allclose(np.diff(data[axis][:]), step, rtol=1e-9)

    np.save("z.npy", heights())
    check_ours(convert("z.npy", "ours.nc", "--size", "3mm,2mm"), "NETCDF3_64BIT_OFFSET")

    # Deflated, in chunks that do not divide the field, with strings that only NetCDF-4 has.
    with netCDF4.Dataset("theirs.nc", "w", format="NETCDF4") as data:
        for axis, n, step in (("x", NX, DX), ("y", NY, DY)):
            data.createDimension(axis, n)
            data.createVariable(axis, "f8", (axis,))[:] = np.arange(n) * step * 1e3
            data[axis].setncattr_string("units", "mm")
        z = data.createVariable("heights", "f8", ("x", "y"), zlib=True, shuffle=True, chunksizes=(2, 3), fill_value=-1.0)
        z.setncattr_string("units", "µm")
        z[:] = np.where(np.isnan(heights()), -1, heights())
        data.createVariable("counts", "u8", ("x", "y"), zlib=True)[:] = 2**63 + np.arange(NX * NY).reshape(NX, NY)
        data.setncattr_string("title", "Rauheit, gemessen")
    # One rounding of the factor, one of the product.
    assert np.allclose(our_array("theirs.nc"), heights() * 1e-6, rtol=4e-16, atol=0, equal_nan=True)
    assert np.allclose(our_spacing("theirs.nc"), [DX, DY], rtol=1e-12)

    # What it holds passes whole; the 64-bit numbers need CDF-5.
    with netCDF4.Dataset(convert("theirs.nc", "again.nc")) as data, netCDF4.Dataset("theirs.nc") as theirs:
        assert data.data_model == "NETCDF3_64BIT_DATA", data.data_model
        assert data.title == "Rauheit, gemessen" and data["heights"].units == "µm"
        for name in theirs.variables:
            assert data[name].dtype == theirs[name].dtype and same(data[name][:].data, theirs[name][:].data), name


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    {"numpy": check_numpy, "gdal": check_gdal, "gwyddion": check_gwyddion, "netcdf4": check_netcdf4}[sys.argv[2]]()
