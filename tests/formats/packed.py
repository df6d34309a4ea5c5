"""What other programs pack, mark and turn around is read with the numbers that they themselves read.

packed.py ASPERITY-CONVERT CHECK      one of netcdf4, xarray; exit 77 where the other program is missing
"""
import itertools
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
CONVERT = sys.argv[1]
NX, NY, STEP = 7, 6, 1e-6


def skip(what):
    print(f"SKIPPED: there is no {what}")
    sys.exit(SKIPPED)


try:
    import netCDF4
    import numpy as np
except ImportError:
    skip("python3-netcdf4")


def converted(source, target):
    subprocess.run([CONVERT, source, "-o", target], check=True)
    return target


def ours(source):
    return np.load(converted(source, "ours.npy"))


def agree(found, exact, what):
    """To two roundings, of the product and of the sum; missing points the same."""
    found, exact = np.asarray(found, float), np.ma.filled(np.ma.asarray(exact).astype(float), np.nan)
    assert np.array_equal(np.isnan(found), np.isnan(exact)), (what, found, exact)
    size = np.nanmax(np.abs(exact), initial=0)
    assert np.all(np.isnan(exact) | (np.abs(found - exact) <= 4 * np.finfo(float).eps * size)), (what, found, exact)


def grid(data):
    for axis, n in (("x", NX), ("y", NY)):
        data.createDimension(axis, n)
        data.createVariable(axis, "f8", (axis,))[:] = np.arange(n) * STEP
        data[axis].units = "m"


def check_netcdf4():
    """All attributes together and apart, of every type, with rows that were never written."""
    choices = itertools.product(
        ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "f4", "f8"),
        (None, 7),                       # _FillValue
        (None, [11], [3, 11]),           # missing_value
        (None, (2, 40), (None, 40)),     # valid_range; valid_max
        (None, (0.5, None), (1.0, 3.0)), # scale_factor, add_offset
        (False, True))                   # rows never written
    # Every fifth: any three of these attributes meet in each of their values.
    for n, (kind, fill, missing, valid, packing, hole) in enumerate(itertools.islice(choices, 0, None, 5)):
        if kind in ("i1", "u1") and hole and fill is None:
            continue  # the Users Guide has no default for bytes; netCDF4 masks one all the same
        what = (kind, fill, missing, valid, packing, hole)
        model = "NETCDF4" if n % 2 else "NETCDF3_64BIT_DATA"
        with netCDF4.Dataset("theirs.nc", "w", format=model) as data:
            data.set_fill_on()
            grid(data)
            z = data.createVariable("heights", kind, ("x", "y"), fill_value=fill)
            z.units = "m"
            z.set_auto_maskandscale(False)
            if missing:
                z.missing_value = np.array(missing, kind)
            if valid and valid[0] is not None:
                z.valid_range = np.array(valid, kind)
            elif valid:
                z.valid_max = np.array(valid[1], kind)
            if packing:
                z.scale_factor = packing[0]
                if packing[1]:
                    z.add_offset = packing[1]
            rows = slice(0, NX - 2) if hole else slice(0, NX)
            z[rows, :] = np.arange(NX * NY).reshape(NX, NY)[rows].astype(kind)
        with netCDF4.Dataset("theirs.nc") as data:
            exact = data["heights"][:]
        agree(ours("theirs.nc"), exact, what)
        if n % 5:
            continue
        with netCDF4.Dataset(converted("theirs.nc", "again.nc")) as data:
            agree(np.ma.filled(data["heights"][:].astype(float), np.nan), exact, what)


def check_unsigned():
    for kind in ("i1", "i2", "i4"):
        with netCDF4.Dataset("theirs.nc", "w", format="NETCDF3_64BIT_OFFSET") as data:
            grid(data)
            z = data.createVariable("heights", kind, ("x", "y"), fill_value=-1)
            z.units, z._Unsigned = "m", "true"
            z.set_auto_maskandscale(False)
            z[:] = np.arange(-NX * NY // 2, NX * NY // 2).reshape(NX, NY).astype(kind)
        with netCDF4.Dataset("theirs.nc") as data:
            agree(ours("theirs.nc"), data["heights"][:], kind)


def check_xarray():
    try:
        import xarray
    except ImportError:
        skip("python3-xarray")
    np.save("z.npy", np.random.default_rng(1).normal(size=(NX, NY)) * 1e-6)
    subprocess.run([CONVERT, "z.npy", "--size", "7um,6um", "-o", "whole.nc"], check=True)
    whole = xarray.open_dataset("whole.nc", engine="scipy").load()
    packings = ({}, {"dtype": "int16", "scale_factor": 1e-10, "_FillValue": -32768},
                {"dtype": "int16", "scale_factor": 1e-10, "add_offset": 1e-7, "_FillValue": -1},
                {"dtype": "float32", "_FillValue": np.float32(-9999)})
    for packing, backwards, transposed in itertools.product(packings, ("", "x", "y", "xy"), (False, True)):
        theirs = whole.copy(deep=True)
        theirs["heights"][2, 3] = np.nan
        for axis in backwards:
            theirs = theirs.isel({axis: slice(None, None, -1)})
        if transposed:
            theirs = theirs.transpose("y", "x")
        theirs.heights.encoding.clear()
        theirs.to_netcdf("theirs.nc", encoding={"heights": packing}, engine="scipy")
        what = (packing, backwards, transposed)
        exact = xarray.open_dataset("theirs.nc", engine="scipy").sortby(["x", "y"]).heights.transpose("x", "y").values
        found = ours("theirs.nc")
        # xarray scales in single precision where it thinks that enough
        assert np.array_equal(np.isnan(found), np.isnan(exact)), what
        assert np.nanmax(np.abs(found - exact)) <= 2 * np.finfo(np.float32).eps * 1e-5, what
        line = xarray.open_dataset(converted("theirs.nc", "again.nc"), engine="scipy").history.split("\n")
        assert ("reversed" in line[1]) == bool(backwards), (what, line)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    if sys.argv[2] == "netcdf4":
        check_netcdf4()
        check_unsigned()
    else:
        check_xarray()
