"""Surfaces, and the files in which strangers keep them: written here without any part of Asperity."""
import gzip
import hashlib
import io
import struct
import zipfile
import zlib

import netCDF4
import numpy as np
from scipy.io import netcdf_file

METRES = {"m": 1, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "nm": 1e-9, "inch": 0.0254, "micrometer": 1e-6, "meters": 1,
          "cm": 1e-2}


class Surface:
    """Heights z(x, y) in metres, not a number where missing, on cells of dx by dy metres."""

    def __init__(self, z, dx, dy):
        self.z, self.dx, self.dy = z, dx, dy

    @property
    def shape(self):
        return self.z.shape


def random_surface(rng, shape=None, least=1, dx=None):
    """Smooth with some roughness, micrometres high, so that most parameters of it are known."""
    if shape is None:
        shape = tuple(int(n) for n in rng.choice([n for n in (1, 2, 3, 5, 8, 13, 16, 33) if n >= least], 2))
        if shape[0] * shape[1] < 6:
            shape = (max(shape[0], 3), max(shape[1], 3))
    dx = dx or 10.0 ** rng.uniform(-7, -5)
    x, y = np.meshgrid(np.arange(shape[0]), np.arange(shape[1]), indexing="ij")
    z = np.sin(0.7 * x + rng.uniform(0, 6)) * np.cos(0.5 * y + rng.uniform(0, 6)) + 0.5 * rng.normal(size=shape)
    return Surface((z + rng.uniform(-2, 2)) * 1e-7, dx, dx * rng.choice([1, 1, 0.5, 1.7]))


def parameters(surface):
    """Height parameters and Sdq by plain sums over what is there."""
    z = surface.z[np.isfinite(surface.z)]
    mean = z.mean()
    d = z - mean
    sq = np.sqrt((d**2).mean())
    with np.errstate(all="ignore"):
        out = {"mean": mean, "Sa": abs(d).mean(), "Sq": sq, "Ssk": (d**3).mean() / sq**3, "Sku": (d**4).mean() / sq**4,
               "Sp": d.max(), "Sv": -d.min(), "Sz": d.max() - d.min(), "N": float(z.size)}
        if min(surface.shape) > 1:
            slopes = [np.diff(surface.z, axis=a) / step for a, step in ((0, surface.dx), (1, surface.dy))]
            out["Sdq"] = np.sqrt(sum(np.nanmean(s**2) for s in slopes))
    return out


# ---- NetCDF ----


def cell_centres(n, step):
    return (np.arange(n) + 0.5 - n / 2) * step


def write_netcdf(path, surface, *, fields=None, attributes=None, unit="m", xy_unit="m", order="xy", down=(), length="right",
                 kind="f8", format="NETCDF3_64BIT_OFFSET", extra=None, periodic=None, raw=None):
    """`fields` are others on (x, y), name: (values, unit); `extra` attributes of the heights, `raw` their values as stored.

    `down` names axes whose coordinates descend, `length` is right, none or stale."""
    fields = {"heights": (surface.z / METRES.get(unit, 1), unit), **(fields or {})}
    with netCDF4.Dataset(path, "w", format=format) as data:
        data.set_auto_maskandscale(False)
        for axis, n, step in (("x", surface.shape[0], surface.dx), ("y", surface.shape[1], surface.dy)):
            data.createDimension(axis, n)
            points = cell_centres(n, step) / METRES[xy_unit]
            at = data.createVariable(axis, "f8", (axis,))
            at[:] = points[::-1] if axis in down else points
            at.units = xy_unit
            if length != "none":
                at.length = n * step / METRES[xy_unit] * (2 if length == "stale" else 1)
            if periodic is not None:
                at.periodic = np.int32(periodic)
        for name, (values, its_unit) in fields.items():
            heights = name == "heights"
            more = dict(extra or {}) if heights else {}
            fill = more.pop("_FillValue", None)
            variable = data.createVariable(name, kind if heights else "f8", tuple(order), fill_value=fill)
            variable.set_auto_maskandscale(False)
            if its_unit is not None:
                variable.units = its_unit
            for key, value in more.items():
                variable.setncattr(key, value)
            stored = raw if heights and raw is not None else values
            stored = stored[::-1] if "x" in down else stored
            stored = stored[:, ::-1] if "y" in down else stored
            variable[:] = stored if order == "xy" else stored.T
        for key, value in (attributes or {}).items():
            data.setncattr(key, value)
    return path


def write_with_raw_unit(path, surface, unit, name="heights", fields=None):
    """A unit of any bytes at all, which netCDF4 does not write."""
    with netcdf_file(path, "w", version=2) as data:
        for axis, n, step in (("x", surface.shape[0], surface.dx), ("y", surface.shape[1], surface.dy)):
            data.createDimension(axis, n)
            at = data.createVariable(axis, "f8", (axis,))
            at[:] = cell_centres(n, step)
            at.units, at.length = b"m", n * step
        all_fields = {"heights": (surface.z, b"m"), **(fields or {})}
        all_fields[name] = (all_fields.get(name, (surface.z, b"m"))[0], unit)
        for key, (values, its_unit) in all_fields.items():
            variable = data.createVariable(key, "f8", ("x", "y"))
            variable[:] = values
            variable.units = its_unit
    return path


def read(path):
    """All variables as stored, and the global attributes."""
    with netCDF4.Dataset(path) as data:
        data.set_auto_maskandscale(False)
        variables = {name: np.array(v[:]) for name, v in data.variables.items()}
        return variables, {name: data.getncattr(name) for name in data.ncattrs()}


def pressed(rng, shape=(12, 10), dx=1e-6, **more):
    """A surface with a pressure of a few loaded cells on it, and what asperity-stress needs besides."""
    surface = random_surface(rng, shape, dx=dx)
    p = np.zeros(shape)
    i, j = shape[0] // 2, shape[1] // 2
    p[i - 2:i + 2, j - 2:j + 2] = rng.uniform(1e8, 1e9, (4, 4))
    load = p.sum() * surface.dx * surface.dy
    return surface, p, {"contact_poisson": np.array([0.3, 0.3]), "contact_load": load, "contact_converged": np.int32(1),
                        "contact_variable": "heights", **more}


# ---- other formats: `lines` runs along y, each line along x ----


def text(surface, rng):
    """A bare matrix, with what asperity has to be told of it."""
    separator, decimal = (" .", "\t.", ",.", ";.", ";,", "\t,")[int(rng.integers(6))]
    order = "xy" if rng.random() < 0.5 else "yx"
    rows = surface.z if order == "xy" else surface.z.T
    unit = ("m", "um", "nm")[int(rng.integers(3))]
    lines = [separator.join(repr(float(v)).replace(".", decimal) for v in row) for row in rows / METRES[unit]]
    options = ["--from", "text", "--from-order", order, *told_size(surface), "--unit", unit, "--xyz", "none"]
    options += ["--separator", {" ": "blank", "\t": "tab", ",": "comma", ";": "semicolon"}[separator]]
    return ("\n".join(lines) + "\n").encode(), options + ["--decimal", "comma" if decimal == "," else "point"]


def points(surface, rng):
    """Lines of x y z in any order, below words, labels and units: nothing has to be told."""
    separator, decimal = (("\t", "."), (",", "."), (";", ","), ("\t", ","), (";", "."))[int(rng.integers(5))]
    across, up = (("m", "mm", "um", "µm", "nm")[int(k)] for k in rng.integers(5, size=2))
    style = ("{} [{}]", "{} ({})", "{}/{}", "{} in {}")[int(rng.integers(4))]
    quote = '"' if rng.random() < 0.3 else ""
    names = ("x", "Y", "z") if rng.random() < 0.5 else ("X Position", "Y Position", "Height")
    order = list(rng.permutation(3))
    lines = [separator.join(quote + style.format(names[k], up if k == 2 else across) + quote for k in order)]
    if rng.random() < 0.5:
        lines = ["Sample A", "Operator:" + separator + "nobody", ""] + lines
    kept = [(i, j) for i in range(surface.shape[0]) for j in range(surface.shape[1]) if np.isfinite(surface.z[i, j])]
    for k in rng.permutation(len(kept)):
        i, j = kept[k]
        x, y = (f"{n * d / METRES[across]:.9g}" for n, d in ((i, surface.dx), (j, surface.dy)))
        cells = (x, y, repr(float(surface.z[i, j] / METRES[up])))
        lines.append(separator.join(quote + cells[m].replace(".", decimal) + quote for m in order))
    end = ("\n", "\r\n", "\r")[int(rng.integers(3))]
    content = end.join(lines) + end
    return content.encode(("utf-8", "utf-8-sig", "utf-16", "latin-1")[int(rng.integers(4))]), []


def told_size(surface):
    return ["--size", f"{surface.shape[0] * surface.dx!r}m,{surface.shape[1] * surface.dy!r}m"]


def npy(surface, rng):
    kind = ("<f8", ">f8", "<f4", ">f4")[int(rng.integers(4))]
    order = "xy" if rng.random() < 0.5 else "yx"
    surface.z = surface.z.astype(kind).astype(float)
    array = np.asarray(surface.z if order == "xy" else surface.z.T, kind, "CF"[int(rng.integers(2))])
    out = io.BytesIO()
    np.lib.format.write_array(out, array, version=((1, 0), (2, 0))[int(rng.integers(2))])
    return out.getvalue(), ["--from-order", order, *told_size(surface)]


def gsf(surface, rng):
    surface.z = surface.z.astype("<f4").astype(float)
    head = (f"Gwyddion Simple Field 1.0\nXRes = {surface.shape[0]}\nYRes = {surface.shape[1]}\n"
            f"XReal = {surface.shape[0] * surface.dx!r}\nYReal = {surface.shape[1] * surface.dy!r}\nXYUnits = m\nZUnits = m\n")
    head = head.encode()
    return head + b"\0" * (4 - len(head) % 4) + surface.z.T.astype("<f4").tobytes(), []


def nrrd(surface, rng):
    kind = ("double", "float", "int", "short")[int(rng.integers(4))]
    code, unit = {"double": ("f8", "m"), "float": ("f4", "m"), "int": ("i4", "nm"), "short": ("i2", "nm")}[kind]
    endian, encoding = ("little", "big")[int(rng.integers(2))], ("raw", "gzip", "ascii")[int(rng.integers(3))]
    stored = (surface.z / METRES[unit]).round(0 if code[0] == "i" else 40).astype(code)
    surface.z = stored.astype(float) * METRES[unit]
    values = stored.T.astype(("<" if endian == "little" else ">") + code).tobytes()
    values = {"raw": values, "gzip": gzip.compress(values, mtime=0),
              "ascii": (" ".join(repr(v.item()) for v in stored.T.ravel()) + "\n").encode()}[encoding]
    head = (f"NRRD0004\ntype: {kind}\ndimension: 2\nsizes: {surface.shape[0]} {surface.shape[1]}\n"
            f"spacings: {surface.dx!r} {surface.dy!r}\nunits: \"m\" \"m\"\nsample units: \"{unit}\"\nendian: {endian}\n"
            f"encoding: {encoding}\n\n")
    return head.encode() + values, []


def sdf_ascii(surface, rng):
    head = ("aISO-1.0\nManufacID = attack\nCreateDate = 010120000000\nModDate = 010120000000\n"
            f"NumPoints = {surface.shape[0]}\nNumProfiles = {surface.shape[1]}\n"
            f"Xscale = {surface.dx!r}\nYscale = {surface.dy!r}\n"
            "Zscale = 1e-6\nZresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n")
    lines = "\n".join(" ".join(repr(float(v)) for v in line) for line in surface.z.T / 1e-6)
    return (head + lines + "\n*\n").encode(), []


def sdf(surface, rng):
    kind = ((7, "<f8", 1.0), (3, "<f4", 1.0), (6, "<i4", 1e-12), (5, "<i2", 1e-10))[int(rng.integers(4))]
    number, code, scale = kind
    stored = surface.z / scale
    stored = (stored.round() if "i" in code else stored).astype(code)
    surface.z = stored.astype(float) * scale
    head = b"bISO-1.0" + b"attack".ljust(10) + b"010120000000" * 2
    head += struct.pack("<HHdddd", *surface.shape, surface.dx, surface.dy, scale, -1.0) + struct.pack("<BBB", 0, number, 0)
    return head + stored.T.tobytes(), []


def esri(surface, rng):
    head = (f"ncols {surface.shape[0]}\nnrows {surface.shape[1]}\nxllcorner 0\nyllcorner 0\n"
            f"dx {surface.dx!r}\ndy {surface.dy!r}\n"
            "NODATA_value -9999\n")
    lines = "\n".join(" ".join(repr(float(v)) for v in line) for line in surface.z.T[::-1])
    return (head + lines + "\n").encode(), []


def gwyddion_text(surface, rng):
    nx, ny = surface.shape
    head = (f"# Channel: Z\n# Width: {nx * surface.dx / 1e-6!r} µm\n"
            f"# Height: {ny * surface.dy / 1e-6!r} µm\n# Value units: m\n")
    return (head + "\n".join("\t".join(repr(float(v)) for v in line) for line in surface.z.T) + "\n").encode(), []


def x3p_document(nx, ny, dx, dy, checksum, link="bindata/data.bin"):
    axis = "<{0}><AxisType>{1}</AxisType><DataType>D</DataType><Increment>{2!r}</Increment><Offset>0</Offset></{0}>"
    axes = axis.format("CX", "I", dx) + axis.format("CY", "I", dy) + axis.format("CZ", "A", 1.0)
    return ('<?xml version="1.0" encoding="UTF-8"?><p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>'
            f"<Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>{axes}</Axes></Record1><Record3>"
            f"<MatrixDimension><SizeX>{nx}</SizeX><SizeY>{ny}</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink>"
            f"<PointDataLink>{link}</PointDataLink><MD5ChecksumPointData>{checksum}</MD5ChecksumPointData></DataLink></Record3>"
            "<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></p:ISO5436_2>").encode()


def zipped(members):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for name, content in members.items():
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED, compresslevel=1)
    return out.getvalue()


def x3p(surface, rng):
    values = surface.z.T.astype("<f8").tobytes()
    main = x3p_document(*surface.shape, surface.dx, surface.dy, hashlib.md5(values).hexdigest().upper())
    return zipped({"main.xml": main, "bindata/data.bin": values,
                   "md5checksum.hex": hashlib.md5(main).hexdigest() + " *main.xml\n"}), []


def gwy(surface, rng):
    """Gwyddion's own: an object is a name, NUL, a size and components, each a name, NUL, a letter and a value."""
    def part(name, kind, value):
        return name.encode() + b"\0" + kind + value

    def thing(name, *parts):
        return name + b"\0" + struct.pack("<I", len(b"".join(parts))) + b"".join(parts)

    (nx, ny), unit = surface.shape, thing(b"GwySIUnit", part("unitstr", b"s", b"m\0"))
    field = thing(b"GwyDataField", part("xres", b"i", struct.pack("<i", nx)), part("yres", b"i", struct.pack("<i", ny)),
                  part("xreal", b"d", struct.pack("<d", nx * surface.dx)),
                  part("yreal", b"d", struct.pack("<d", ny * surface.dy)),
                  part("si_unit_xy", b"o", unit), part("si_unit_z", b"o", unit),
                  part("data", b"D", struct.pack("<I", nx * ny) + surface.z.T.astype("<f8").tobytes()))
    others = part("/0/data/title", b"s", b"z\0") if rng.random() < 0.5 else b""
    return b"GWYP" + thing(b"GwyContainer", part("/0/data", b"o", field), others), []


def sur(surface, rng):
    """Digital Surf's: whole numbers of a step, above a height of zero."""
    code, bits, most = (("<i4", 32, 2**30), ("<i2", 16, 2**14))[int(rng.integers(2))]
    step = np.float32(abs(surface.z).max() / 1e-6 / most or 1)
    zero = np.float32(step * int(rng.integers(-99, 99)))
    stored = ((surface.z / 1e-6 - zero) / step).round().astype(code)
    surface.z = (stored.astype(float) * float(step) + float(zero)) * 1e-6
    surface.dx, surface.dy = float(np.float32(surface.dx / 1e-6)) * 1e-6, float(np.float32(surface.dy / 1e-6)) * 1e-6
    head = bytearray(512)
    deflated = rng.random() < 0.5
    head[:12] = b"DSCOMPRESSED" if deflated else b"DIGITAL SURF"
    struct.pack_into("<hhhh", head, 12, 0, 1, 1, 2)
    struct.pack_into("<hiiiii", head, 98, bits, int(stored.min()), int(stored.max()), *surface.shape, stored.size)
    struct.pack_into("<fff", head, 120, surface.dx / 1e-6, surface.dy / 1e-6, step)
    for place in range(180, 276, 16):
        head[place:place + 2] = b"\xb5m"
    struct.pack_into("<f", head, 474, zero)
    values = stored.T.tobytes()
    packed = zlib.compress(values)
    return bytes(head) + (struct.pack("<III", 1, len(values), len(packed)) + packed if deflated else values), []


FORMATS = {"txt": text, "points": points, "npy": npy, "gsf": gsf, "nrrd": nrrd, "sdf-ascii": sdf_ascii, "sdf": sdf,
           "asc": esri, "gwyddion": gwyddion_text, "x3p": x3p, "gwy": gwy, "sur": sur}


def mutated(case, content):
    """The bytes with a few of them flipped, cut, inserted or repeated, half of these in the head, which holds the traps."""
    content = bytearray(content)
    for _ in range(int(case.rng.integers(1, 4))):
        at = int(case.rng.integers(len(content)))
        at = at if case.chance(0.5) else at % min(len(content), 300)
        way = case.one_of("flip", "flip", "byte", "cut", "insert", "repeat")
        if way == "flip":
            content[at] ^= 1 << int(case.rng.integers(8))
        elif way == "byte":
            content[at] = int(case.one_of(0, 255, 127, 10, 32, 45, 57))
        elif way == "cut":
            del content[at:at + int(case.rng.integers(1, 40))]
        elif way == "insert":
            content[at:at] = bytes(case.rng.integers(0, 256, int(case.rng.integers(1, 9))).astype("u1"))
        else:
            content[at:at] = content[at:at + 16]
        if not content:
            content = bytearray(b"\0")
    return bytes(content)
