"""Families of the class numbers: what is measured of a surface, against plain sums."""

import numpy as np
from scipy import signal

import maps
from bench import RIGHT, check, strict_json
from readings import close, same_numbers
from sums import autocorrelation


def surface_file(case, name="in.nc", shape=None, **more):
    surface = maps.random_surface(case.rng, shape or tuple(int(n) for n in case.rng.integers(6, 24, 2)), dx=1e-6)
    maps.write_netcdf(case.path(name), surface, **more)
    return surface


def acf_by_sums(case):
    surface = surface_file(case)
    biased = case.chance(0.5)
    case.done("acf", "in.nc", "-o", "out.nc", *(["--biased"] if biased else []))
    found, attributes = maps.read(case.path("out.nc"))
    ours = found["acf"]
    expected, pairs = autocorrelation(surface.z)
    if biased:
        expected = expected * pairs / surface.z.size
    middle, reach = surface.shape[1] - 1, ours.shape[1] // 2
    expected = expected[:ours.shape[0], middle - reach:middle + reach + 1]
    check(close(ours, expected, 1e-9, 1e-10), "the autocorrelation of direct sums over pairs")
    check(close(attributes["acf_variance"], surface.z.var(), 1e-10), "the variance")
    return RIGHT


def psd_by_transform(case):
    """Parseval's sum, and each value that of NumPy's transform."""
    surface = surface_file(case)
    nx, ny = surface.shape
    lx, ly = nx * surface.dx, ny * surface.dy
    case.done("psd", "in.nc", "--window", "none", "-o", "out.nc")
    found, _ = maps.read(case.path("out.nc"))
    c = (surface.dx * surface.dy) ** 2 / (lx * ly) * abs(np.fft.fft2(surface.z - surface.z.mean())) ** 2
    p = np.rint(found["wave_number_x"] * lx / (2 * np.pi)).astype(int)
    q = np.rint(found["wave_number_y"] * ly / (2 * np.pi)).astype(int)
    c[np.arange(nx) * 2 == nx, :] /= 2  # either sign has half of a wave of two points
    c[:, np.arange(ny) * 2 == ny] /= 2
    check(close(found["psd"], c[np.ix_(p % nx, q % ny)], 1e-8, 1e-12 * c.max()), "the power of NumPy's transform")
    check(set(p) == set(range(nx // 2 + 1)) and len(set(q % ny)) == ny, "every wave number once")
    return RIGHT


def quantiles(case):
    surface = surface_file(case)
    shares = sorted(case.rng.uniform(0.05, 0.95, 3).round(3))
    run = case.done("stats", "in.nc", "--json", "--quantiles", ",".join(map(str, shares)))
    found = [q["value"] for name, q in strict_json(run.out).items() if name.startswith("quantile") or name[:1] in "qQ"]
    check(len(found) == 3, f"three quantiles of {list(strict_json(run.out))}")
    heights = np.sort(surface.z.ravel()) - surface.z.mean()
    for share, q in zip(shares, found):
        below = np.searchsorted(heights, [q - 1e-15, q + 1e-15]) / heights.size
        check(below[0] - 1.5 / heights.size <= share <= below[1] + 1.5 / heights.size, f"{share} of the heights below {q}")
    return RIGHT


def slopes(case):
    """Sdq, Sdr of four triangles a cell, and mean square slopes and curvatures of plain differences."""
    surface = surface_file(case)
    z, dx, dy = surface.z, surface.dx, surface.dy
    found = strict_json(case.done("stats", "in.nc", "--json", "--parameters", "hybrid").out)
    a, b = np.diff(z, axis=0) / dx, np.diff(z, axis=1) / dy
    along, across = (b[:-1] + b[1:]) / 2, (a[:, :-1] + a[:, 1:]) / 2
    area = sum(np.sqrt(1 + s**2 + along**2) for s in (a[:, :-1], a[:, 1:]))
    area = area + sum(np.sqrt(1 + s**2 + across**2) for s in (b[:-1], b[1:]))
    expected = {"Sdq": np.sqrt((a**2).mean() + (b**2).mean()), "Sdr": (area / 4 - 1).mean(), "m0": z.var(),
                "m2_x": (a**2).mean(),
                "m2_y": (b**2).mean(), "m4_x": (np.diff(z, 2, 0) ** 2).mean() / dx**4, "m4_y": (np.diff(z, 2,
                                                                                                        1) ** 2).mean() / dy**4}
    for name, value in expected.items():
        check(close(found[name]["value"], value, 1e-9), f"{name} = {value!r}, not {found[name]['value']!r}")
    return RIGHT


def heights_of_any_surface(case):
    return same_numbers(case, "in.nc", surface_file(case))


def same_in_any_unit(case):
    """The same surface in nm and in m, transposed and not: one table, to round-off."""
    surface = surface_file(case)
    maps.write_netcdf(case.path("other.nc"), surface, unit="nm", xy_unit="mm", order="yx")
    tables = [strict_json(case.done("stats", name, "--json", "--parameters", "height,hybrid,spatial,material").out)
              for name in ("in.nc", "other.nc")]
    for name, one in tables[0].items():
        other = tables[1][name]["value"]
        check((one["value"] is None) == (other is None), f"{name} is known in both")
        tolerance = 1e-6 if "direction" in name or name in ("gamma", "Std", "Str") else 1e-8
        check(one["value"] is None or close(other, one["value"], tolerance, 1e-8 * abs(one["value"]) + 1e-300),
              f"{name} is {one['value']!r} in both")
    return RIGHT


def texture_in_any_unit(case):
    """The texture of a surface does not turn with a rounding of its size: waves of the shortest length count or do not."""
    case.done("generate", "--shape", "16x20", "--size", "16um,20um", "--rq", "0.1um", "--length", "2px", "--seed",
              case.rng.integers(1, 2**31), "-o", "in.nc")
    case.done("convert", "in.nc", "-o", "in.npy")
    found = []
    for size in ("16um,20um", "0.016mm,0.020mm"):
        case.done("convert", "in.npy", "--size", size, "-o", "out.nc")
        table = strict_json(case.done("stats", "out.nc", "--json", "--parameters", "spatial").out)
        found.append([table[name]["value"] for name in ("Std", "Std_contrast")])
    check(close(found[1], found[0], 1e-6, 1e-6), f"a texture of {found[0]} by either size, not {found[1]}")
    return RIGHT


def above_a_form(case):
    """Heights above a plane or a polynomial of least squares."""
    surface = surface_file(case, shape=tuple(int(n) for n in case.rng.integers(9, 24, 2)))
    degree = int(case.rng.integers(0, 4))
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in surface.shape), indexing="ij")
    terms = np.array([x**i * y**j for i in range(degree + 1) for j in range(degree + 1 - i)]).reshape(-1, x.size).T
    d = surface.z.ravel() - terms @ np.linalg.lstsq(terms, surface.z.ravel(), rcond=None)[0]
    found = strict_json(case.done("stats", "in.nc", "--json", "--remove-form", "plane" if degree == 1 else degree).out)
    check(close(found["Sq"]["value"], d.std(), 1e-9),
          f"Sq = {d.std()!r} above a polynomial of degree {degree}, not {found['Sq']['value']!r}")
    check(close(found["Sa"]["value"], abs(d - d.mean()).mean(), 1e-9), "Sa above it")
    return RIGHT


def filtered(case):
    """What Gauss's weights of ISO 16610-61 leave, within the surface."""
    surface = surface_file(case, shape=(32, 30))
    return same_after_filter(case, surface, "--lambda-c") if case.chance(0.5) else same_after_filter(case, surface,
                                                                                                     "--lambda-s")


def same_after_filter(case, surface, option):
    """A filter leaves a constant, is linear, and ignores units: half the heights have half the Sq."""
    maps.write_netcdf(case.path("half.nc"), maps.Surface(surface.z / 2 + 1e-6, surface.dx, surface.dy), unit="nm")
    found = [strict_json(case.done("stats", name, "--json", option, "8um").out)["Sq"]["value"] for name in ("in.nc",
                                                                                                           "half.nc")]
    check(close(found[1], found[0] / 2, 1e-7), f"half of Sq = {found[0]!r} of half the heights, not {found[1]!r}")
    check(found[0] < surface.z.std() * (1 + 1e-9), "no more than there was")
    return RIGHT


def cut_and_thinned(case):
    """--crop and --decimate are slices."""
    surface = surface_file(case)
    (nx, ny), rng = surface.shape, case.rng
    a, c = int(rng.integers(0, nx - 2)), int(rng.integers(0, ny - 2))
    b, d = int(rng.integers(a + 2, nx + 1)), int(rng.integers(c + 2, ny + 1))
    i, j = int(rng.integers(1, 3)), int(rng.integers(1, 3))
    expected = surface.z[a:b, c:d][::i, ::j]
    options = ["--crop", f"{a}:{b},{c}:{d}", "--decimate", f"{i}x{j}"]
    run = case.run("filter", "in.nc", *options, "-o", "out.nc")
    check(run.code == 0, f"a slice: {run.err!r}")
    case.done("convert", "out.nc", "-o", "out.npy")
    check(close(np.load(case.path("out.npy")), expected, 1e-14), f"the slice {options}")
    axes = maps.read(case.path("out.nc"))[0]
    for axis, step in (("x", i * surface.dx), ("y", j * surface.dy)):
        check(close(np.diff(axes[axis]), np.full(axes[axis].size - 1, step), 1e-9), f"a spacing of {step!r} along {axis}")
    return RIGHT


def holes_filled(case):
    """--fill leaves what is there, and gives holes the mean, the least, or a harmonic membrane."""
    surface = surface_file(case)
    hole = np.zeros(surface.shape, bool)
    i, j = (int(case.rng.integers(1, n - 3)) for n in surface.shape)
    hole[i:i + 2, j:j + 2] = True
    z = np.where(hole, np.nan, surface.z)
    maps.write_netcdf(case.path("in.nc"), maps.Surface(z, surface.dx, surface.dx))
    way = case.one_of("mean", "least", "laplace")
    case.done("filter", "in.nc", "--fill", way, "-o", "out.nc")
    case.done("convert", "out.nc", "-o", "out.npy")
    found = np.load(case.path("out.npy"))
    check(close(found[~hole], z[~hole], 1e-14), "what was there")
    if way == "laplace":
        neighbours = (found[i - 1:i + 1, j:j + 2] + found[i + 1:i + 3, j:j + 2] + found[i:i + 2,
                                                                                        j - 1:j + 1] + found[i:i + 2,
                                                                                                             j + 1:j + 3]) / 4
        check(close(found[i:i + 2, j:j + 2], neighbours, 1e-6, 1e-6 * np.nanstd(z)),
              "the mean of four neighbours in a hole")
    else:
        value = np.nanmean(z) if way == "mean" else np.nanmin(z)
        check(close(found[hole], np.full(4, value), 1e-9), f"the {way} in a hole")
    return RIGHT


def acf_with_holes(case):
    """With missing points pairs count of which both are there."""
    surface = surface_file(case)
    there = case.rng.random(surface.shape) > 0.15
    maps.write_netcdf(case.path("in.nc"), maps.Surface(np.where(there, surface.z, np.nan), surface.dx, surface.dy))
    case.done("acf", "in.nc", "--max-lag", "3x3", "-o", "out.nc")
    found, attributes = maps.read(case.path("out.nc"))
    d = np.where(there, surface.z - surface.z[there].mean(), 0)
    sums, pairs = (signal.correlate(f, f, method="direct") for f in (d, there.astype(float)))
    p, q = (n - 1 for n in surface.shape)
    expected = (sums / np.maximum(pairs.round(), 1))[p:p + 4, q - 3:q + 4] / (d**2).sum() * there.sum()
    check(close(found["acf"], expected, 1e-9, 1e-9), "the sums over pairs that are there")
    return RIGHT


def ensemble_of_strangers(case):
    """Surfaces in other units, orders and directions are averaged as those in metres."""
    values = []
    shape, dx = (14, 11), 1e-6
    for number in range(3):
        surface = maps.random_surface(case.rng, shape, dx=dx)
        surface.dy = dx
        maps.write_netcdf(case.path(f"s{number}.nc"), surface, unit=case.one_of("m", "nm", "um"), xy_unit=case.one_of("m",
                                                                                                                      "um",
                                                                                                                      "mm"),
                          order=case.one_of("xy", "yx"), length=case.one_of("right", "none"))
        values.append(maps.parameters(surface))
    table = strict_json(case.done("stats", "s0.nc", "s1.nc", "s2.nc", "--json", "--parameters", "height,hybrid").out)
    names = next(column["values"] for column in table.values() if "Sq" in column["values"])
    means = table["mean"]["values"]
    for name in ("Sp", "Sv", "Sz"):
        expected = np.mean([v[name] for v in values])
        check(close(means[names.index(name)], expected, 1e-7), f"a mean {name} of {expected!r}")
    for name in ("Sq", "Sdq"):  # pooled: of their squares, and of heights with what the mean took put back
        least = np.mean([v[name] for v in values])
        check(least * (1 - 1e-7) <= means[names.index(name)] <= 1.5 * least, f"a pooled {name} from {least!r} on")
    return RIGHT
