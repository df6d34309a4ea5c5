"""What others read in the same file, and whether Asperity reads that."""
import io
import xml.etree.ElementTree as xml

import numpy as np
from scipy.io import netcdf_file

import maps
from bench import BAD_DATA, RIGHT, Wrong, check, strict_json

CONTACT = ("--radius", "1mm", "--young", "200GPa", "--poisson", "0.3", "--load", "10mN")


def close(a, b, relative=1e-9, absolute=0.0):
    a, b = np.asarray(a, float), np.asarray(b, float)
    return a.shape == b.shape and np.allclose(a, b, rtol=relative, atol=absolute, equal_nan=True)


def same_numbers(case, path, surface, options=(), relative=1e-9, refusal=()):
    """The height parameters are plain sums; refused only where `refusal` has words that a refusal would name."""
    slopes = min(surface.shape) > 2 and np.isfinite(surface.z).all()
    run = case.run("stats", path, *options, "--json", "--parameters", "height,hybrid" if slopes else "height")
    if run.code != 0:
        check(refusal, f"the numbers, not a refusal: {run.err.strip()[:300]!r}")
        return case.refused(run, BAD_DATA, *refusal)
    found = strict_json(run.out)
    scale = np.nanmax(abs(surface.z))
    for name, value in maps.parameters(surface).items():
        if name == "Sdq" and not slopes:
            continue
        ours = found[name]["value"]
        absolute = relative * (scale if found[name]["unit"] == "m" else 10)
        check(ours is not None and close(ours, value, relative * 10, absolute), f"{name} = {value!r}, not {ours!r}")
    return RIGHT


def same_array(case, path, surface, options=(), relative=1e-12):
    out = case.path("out.npy")
    case.done("convert", path, *options, "-o", out)
    check(close(np.load(out), surface.z, relative, relative * np.nanmax(abs(surface.z))),
          "the array that was written, point by point along (x, y)")


def whole_xml(path):
    """A .vti is XML around its numbers, which stand behind an underscore."""
    content = path.read_bytes()
    start = content.index(b"<AppendedData")
    begin, end = content.index(b"_", start) + 1, content.rindex(b"</AppendedData>")
    try:
        xml.fromstring(content[:begin] + content[end:])
    except (xml.ParseError, UnicodeDecodeError) as e:
        raise Wrong(f"XML that is well formed: {e}") from e


def independent(name, content, options):
    """What NumPy and SciPy read in the same bytes, or None where they know no better."""
    try:
        if name == "npy":
            array = np.load(io.BytesIO(content)).astype(float)
            return array if options[1] == "xy" else array.T
        if name == "nc" and content[:3] == b"CDF":
            with netcdf_file(io.BytesIO(content), mmap=False) as data:
                z = data.variables["heights"]
                if z.dimensions != ("x", "y") or z.units != b"m" or set(z._attributes) - {"units"}:
                    return None
                if any(data.variables[a][0] >= data.variables[a][-1] for a in "xy"):
                    return None
                return np.array(z[:], float)
    except Exception:
        pass
    return None
