"""Numbers against sums that share nothing with the library but the equations; laws of turning and of units."""

import numpy as np
from scipy import signal, stats

import maps
from bench import BAD_DATA, DIFFERS, NOT_CONVERGED, RIGHT, TOLD, USAGE, check, strict_json
from measured import (above_a_form, acf_by_sums, acf_with_holes, cut_and_thinned, ensemble_of_strangers, filtered,
                      heights_of_any_surface, holes_filled, psd_by_transform, quantiles, same_in_any_unit, slopes,
                      surface_file, texture_in_any_unit)
from readings import close
from sums import COMPOSITE, displacement_of, stress_of_cells, wrapped

BODIES = ("--young", "200GPa", "--poisson", "0.3")


# ---- kernels and surfaces ----


def drawn(case, *options, count=30, shape=(32, 24)):
    run = case.run("generate", "--shape", f"{shape[0]}x{shape[1]}", "--size", f"{shape[0]}um,{shape[1]}um", "--rq", "0.1um",
                   *options,
                   "--seed", case.rng.integers(1, 2**31), "--count", count, "--add", "kernel", "-o", "s_%d.nc", "--no-history")
    if run.code not in (0, NOT_CONVERGED):
        return run, None
    return run, np.array([maps.read(case.path(f"s_{i}.nc"))[0]["heights"] for i in range(count)])


def kernel_is_its_correlation(case, name="s_0.nc"):
    """acf_achieved is the autocorrelation of the kernel that stands beside it."""
    found, attributes = maps.read(case.path(name))
    kernel, achieved = found["kernel"], found["acf_achieved"]
    own = signal.correlate(kernel, kernel)
    ci, cj = kernel.shape[0] - 1, kernel.shape[1] - 1
    p, q = min(achieved.shape[0], kernel.shape[0]), min(achieved.shape[1] // 2, cj)
    middle = achieved.shape[1] // 2
    check(close(achieved[:p, middle - q:middle + q + 1], own[ci:ci + p, cj - q:cj + q + 1], 1e-8, 1e-10 * own.max()),
          "acf_achieved as the sums over the kernel")
    return achieved, attributes


def mean_square(fields, rq, correlation):
    """Within the sampling error of a field of this correlation, as chi-squared of so many degrees, at a rate of 1e-7."""
    freedom = len(fields) * fields[0].size / max((correlation**2).sum(), 1)
    found = (fields**2).mean() / rq**2
    low, high = (stats.chi2.ppf(share, freedom) / freedom for share in (5e-8, 1 - 5e-8))
    check(low <= found <= high, f"a mean square between {low:.3f} and {high:.3f} of rq squared, not {found:.3f}")


def ensemble(case):
    """The ensemble has rq, and its autocorrelation is that of the kernel."""
    length = float(case.rng.uniform(1.5, 8))
    target = case.one_of("exponential", "gaussian", "matern", "self-affine")
    run, fields = drawn(case, "--model", target, "--length", f"{length:.2f}px,{length * case.rng.uniform(0.5, 1):.2f}px")
    check(fields is not None, f"surfaces: {run.err!r}")
    achieved, _ = kernel_is_its_correlation(case)
    rho = achieved / achieved[0, achieved.shape[1] // 2]
    mean_square(fields, 1e-7, np.concatenate([rho, rho[1:]]))
    return run.verdict()


def periodic(case, length=None, shape=None, count=40):
    """A periodic surface has rq too, however wide its kernel; or it is refused."""
    shape = shape or case.one_of((16, 16), (32, 24), (1, 256), (8, 64), (64, 64))
    length = length or float(case.rng.uniform(0.1, 4)) * min(max(shape), 40)
    run, fields = drawn(case, "--length", f"{length:.3f}px", "--periodic", count=count, shape=shape)
    if fields is None:
        check(length > 0.15 * min(shape), f"a surface of a kernel as narrow as {length:.2f} of {shape} points: {run.err!r}")
        return case.refused(run, (USAGE, BAD_DATA), "--")
    mean_square(fields, 1e-7, wrapped(length, shape))
    return run.verdict()


def periodic_line(case):
    return periodic(case, 20, (1, 4096), 10)


def periodic_wide(case):
    return periodic(case, case.one_of(64, 100, 200), (64, 64), 60)


def noisy_table(case):
    """Of a table all lags are met, or it is said that they are not."""
    n, share = 12, case.one_of(0.05, 0.05, 0.03, 0.08)
    p, q = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    rho = np.exp(-np.log(10) * np.hypot(p / 6, q / 5)) + share * case.rng.normal(size=(n, n))
    rho[0, 0] = 1
    np.savetxt(case.path("table.txt"), rho)
    run = case.run("kernel", "--acf", "table.txt", "-o", "k.nc")
    if run.code in (USAGE, BAD_DATA):
        return case.refused(run, (USAGE, BAD_DATA), "acf")
    achieved, _ = kernel_is_its_correlation(case, "k.nc")
    middle = achieved.shape[1] // 2
    ours = np.zeros((n, n))
    ours[:min(n, achieved.shape[0]), :min(n, middle + 1)] = achieved[:n, middle:middle + n]
    error = abs(ours / achieved[0, middle] - rho).max()
    check(error <= 1.1e-3 or run.told(), f"the table to 1e-3, or a word: {error:.3g}, exit status {run.code}, {run.err!r}")
    return run.verdict() if error <= 1.1e-3 else TOLD


def narrow_validate(case, shape=None, length=None):
    """Correct surfaces are refused at the stated rate: of a dozen at 1 % two or fewer."""
    shape = shape or case.one_of((1, 512), (512, 1), (4, 256), (1, 300))
    length = length or f"{case.rng.uniform(3, 20):.2f}px"
    seed, refused = int(case.rng.integers(1, 2**30)), 0
    for i in range(12):
        case.done("generate", "--shape", f"{shape[0]}x{shape[1]}", "--size", f"{shape[0]}um,{shape[1]}um", "--rq", "0.1um",
                  "--length",
                  length, "--seed", seed + i, "-o", "s.nc")
        run = case.raw("validate", "s.nc")
        check(run.code in (0, DIFFERS), f"an answer: {run.err!r}")
        refused += run.code == DIFFERS
    check(refused <= 2, f"at most 2 of 12 correct surfaces refused at 1 %, not {refused}")
    return RIGHT


def lone_line_validate(case):
    return narrow_validate(case, (1, 512), "20px")


# ---- contact ----


def contact(case, is_periodic=None):
    """Balance, bounds, complementarity, the gap by its parts, and displacement by direct sums."""
    is_periodic = case.chance(0.4) if is_periodic is None else is_periodic
    surface = surface_file(case, periodic=int(is_periodic))
    (nx, ny), dx, dy = surface.shape, surface.dx, surface.dy
    radius = np.inf if is_periodic else 10 ** case.rng.uniform(-5, -3)
    load = 10 ** case.rng.uniform(-4, -1.5)
    limit = case.one_of(None, 10 ** case.rng.uniform(9, 10.5))
    options = ["--load", f"{load!r}N", "--tolerance", "1e-9"] + (["--limit-pressure", f"{limit!r}Pa"] if limit else [])
    options += ["--boundary", "periodic"] if is_periodic else ["--radius", f"{radius!r}m"]
    run = case.run("contact", "in.nc", *BODIES, *options, "-o", "out.nc")
    if run.code not in (0, NOT_CONVERGED):
        check(limit is not None and load > 0.99 * limit * nx * ny * dx * dy, f"an answer: {run.err!r}")
        return case.refused(run, USAGE, "--")
    found, said = maps.read(case.path("out.nc"))
    p, gap, u = found["pressure"], found["gap"], found["displacement"]
    x, y = np.meshgrid(maps.cell_centres(nx, dx), maps.cell_centres(ny, dy), indexing="ij")
    scale, largest = np.ptp(u) + 1e-30, p.max()
    check(close(p.sum() * dx * dy, load, 1e-9), f"a load of {load!r} N, not {p.sum() * dx * dy!r}")
    check(p.min() >= 0 and (limit is None or p.max() <= limit * (1 + 1e-12)), "pressures within their bounds")
    direct = displacement_of(p, dx, dy, is_periodic)
    check(close(u, direct, 1e-8, 1e-8 * abs(direct).max()), "the displacement of direct sums")
    form = (x**2 + y**2) / radius  # two equal spheres
    parts = form - surface.z + u - said["contact_approach"]
    check(close(gap, parts, 1e-7, 1e-7 * scale + 1e-12 * abs(surface.z).max()), "the gap of its parts")
    if run.code == NOT_CONVERGED:
        return TOLD
    tolerance = 1e-6 * scale
    free = (p > 0) & (p < (limit or np.inf))
    check(gap[p == 0].min(initial=0) >= -tolerance, "no overlap where the surfaces are apart")
    check(abs(gap[free]).max(initial=0) <= tolerance, "no gap where they touch")
    check(limit is None or gap[p >= limit].max(initial=0) <= tolerance, "no gap at the limit pressure")
    check(close(said["contact_max_pressure"], largest), "the largest pressure")
    return RIGHT


def two_rough_bodies(case):
    """A counter body adds its heights: pressed apart, they are one body of the sum."""
    first = surface_file(case, "one.nc", (14, 12))
    second = maps.random_surface(case.rng, (14, 12), dx=1e-6)
    second.dy = first.dy
    maps.write_netcdf(case.path("other.nc"), second)
    maps.write_netcdf(case.path("sum.nc"), maps.Surface(first.z + second.z, first.dx, first.dy))
    found = []
    for names in (("one.nc", "--counter", "other.nc"), ("other.nc", "--counter", "one.nc"), ("sum.nc",)):
        case.done("contact", *names, *BODIES, "--radius", "1mm", "--load", "5mN", "--tolerance", "1e-11", "-o", "out.nc")
        found.append(maps.read(case.path("out.nc"))[0]["pressure"])
    check(all(close(p, found[2], 0, 1e-6 * found[2].max()) for p in found),
          "the pressures of one body of the sum of heights")
    return RIGHT


def load_and_approach(case):
    """The approach that a load has brings that load; of a sweep each row is that load alone."""
    surface_file(case)
    common = ("in.nc", *BODIES, "--radius", "1mm", "--tolerance", "1e-10")
    case.done("contact", *common, "--load", "4mN", "-o", "one.nc")
    _, said = maps.read(case.path("one.nc"))
    case.done("contact", *common, "--approach", f"{float(said['contact_approach'])!r}m", "-o", "two.nc")
    _, again = maps.read(case.path("two.nc"))
    check(close(again["contact_load"], 4e-3, 1e-5), f"a load of 4 mN, not {again['contact_load']!r} N")
    table = strict_json(case.done("contact", *common, "--sweep", "2mN,4mN,8mN", "--json").out)
    check(close(table["load"]["values"][1], 4e-3, 1e-12), "the loads that were asked for")
    check(close(table["approach"]["values"][1], said["contact_approach"], 1e-5, 1e-15),
          "the approach of that load in a sweep")
    return RIGHT


def hertz(case):
    """Spheres, to the error that cells leave."""
    n, radius, load = case.one_of(48, 64), 10 ** case.rng.uniform(-3, -1), 10 ** case.rng.uniform(0, 3)
    composite_radius = radius / 2
    a = (3 * load * composite_radius / (4 * COMPOSITE)) ** (1 / 3)
    case.done("contact", "--smooth", "--shape", f"{n}x{n}", "--size", f"{3 * a!r}m", "--radius", f"{radius!r}m", *BODIES,
              "--load",
              f"{load!r}N", "--tolerance", "1e-8", "-o", "out.nc")
    _, said = maps.read(case.path("out.nc"))
    cells = (2 * a) / (3 * a / n)
    p0, approach = 3 * load / (2 * np.pi * a**2), a**2 / composite_radius
    check(close(said["contact_hertz_pressure"], p0, 1e-6) and close(said["contact_hertz_radius"], a, 1e-6),
          "Hertz's closed forms")
    check(close(said["contact_max_pressure"], p0, 3 / cells**2), "Hertz's pressure, but for the cells")
    check(close(said["contact_approach"], approach, 1 / cells**2), "Hertz's approach, but for the cells")
    return RIGHT


def turned(z, way):
    return {"x": z[::-1], "y": z[:, ::-1], "transposed": z.T}[way]


def turned_contact(case):
    """A surface that is mirrored or turned has the pressures and stresses mirrored or turned."""
    surface = surface_file(case)
    way = case.one_of("x", "y", "transposed")
    dx, dy = (surface.dy, surface.dx) if way == "transposed" else (surface.dx, surface.dy)
    maps.write_netcdf(case.path("other.nc"), maps.Surface(turned(surface.z, way), dx, dy))
    pressures, stresses = [], []
    for name in ("in.nc", "other.nc"):
        case.done("contact", name, *BODIES, "--radius", "1mm", "--load", "3mN", "--tolerance", "1e-11", "-o", "p-" + name)
        case.done("stress", "p-" + name, "--depths", "1um,4um", "--components", "von_mises,zz", "-o", "s-" + name)
        pressures.append(maps.read(case.path("p-" + name))[0]["pressure"])
        stresses.append(maps.read(case.path("s-" + name))[0]["von_mises"])
    largest = pressures[0].max()
    check(close(pressures[1], turned(pressures[0], way), 0, 1e-6 * largest), f"pressures that are turned ({way})")
    for k in range(2):
        check(close(stresses[1][k], turned(stresses[0][k], way), 0, 1e-5 * largest), f"stresses that are turned ({way})")
    return RIGHT


def contact_in_any_unit(case):
    surface = surface_file(case)
    maps.write_netcdf(case.path("other.nc"), surface, unit="nm", xy_unit="um", length="none")
    pressures = []
    for name in ("in.nc", "other.nc"):
        case.done("contact", name, *BODIES, "--radius", "1mm", "--load", "3mN", "--tolerance", "1e-10", "-o", "p-" + name)
        pressures.append(maps.read(case.path("p-" + name))[0]["pressure"])
    check(close(pressures[1], pressures[0], 0, 1e-6 * pressures[0].max()), "the same pressures from nm as from m")
    return RIGHT


# ---- stress ----


def stress_by_quadrature(case):
    """Every component as the sum over cells of Boussinesq's and, with friction along x, of Cerruti's."""
    nu, friction = float(case.rng.uniform(0, 0.49)), case.one_of(0.0, float(case.rng.uniform(0, 0.8)))
    surface, p, attributes = maps.pressed(case.rng, (11, 9))
    p *= case.rng.uniform(0.2, 1, p.shape)
    maps.write_netcdf(case.path("in.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    depth = float(case.rng.uniform(1, 5)) * 1e-6
    case.done("stress", "in.nc", "--depths", f"{depth!r}m", "--components", "all", "--resolution", "full", "--poisson",
              f"{nu!r}",
              "--friction", f"{friction!r}", "-o", "out.nc")
    found, _ = maps.read(case.path("out.nc"))
    i, j = (int(case.rng.integers(n)) for n in surface.shape)
    at = [maps.cell_centres(n, s)[k] for n, s, k in zip(surface.shape, (surface.dx, surface.dy), (i, j))] + [depth]
    s = stress_of_cells(p, surface.dx, surface.dy, at, nu, friction)
    for name, value in s.items():
        ours = found[f"stress_{name}"][0, i, j]
        check(abs(ours - value) <= 1e-6 * p.max(), f"stress_{name} = {value!r} at {at}, not {ours!r}")
    mises = np.sqrt(((s["xx"] - s["yy"])**2 + (s["yy"] - s["zz"])**2 + (s["zz"] - s["xx"])**2) / 2
                    + 3 * (s["xy"]**2 + s["yz"]**2 + s["xz"]**2))
    check(abs(found["von_mises"][0, i, j] - mises) <= 1e-5 * p.max(), f"a von Mises stress of {mises!r}")
    return RIGHT


def stress_of_waves(case):
    """Below a periodic surface a wave of pressure is -(1 + q z) exp(-q z) of itself in stress_zz."""
    surface = surface_file(case, periodic=1)
    case.done("contact", "in.nc", *BODIES, "--boundary", "periodic", "--load", "3mN", "-o", "p.nc")
    p = maps.read(case.path("p.nc"))[0]["pressure"]
    depth = float(case.rng.uniform(0, 5)) * 1e-6
    case.done("stress", "p.nc", "--depths", f"{depth!r}m", "--components", "zz", "--resolution", "full", "-o", "out.nc")
    qx, qy = (2 * np.pi * np.fft.fftfreq(n, s) for n, s in zip(p.shape, (surface.dx, surface.dy)))
    qz = np.hypot(*np.meshgrid(qx, qy, indexing="ij")) * depth
    expected = -np.fft.ifft2(np.fft.fft2(p) * (1 + qz) * np.exp(-qz)).real
    found = maps.read(case.path("out.nc"))[0]["stress_zz"][0]
    check(close(found, expected, 0, 1e-9 * p.max()), f"the stress of each wave, {depth!r} m deep")
    return RIGHT


def stress_in_equilibrium(case):
    """Central differences of the stresses below smooth loads balance: div sigma = 0, but for the truncation of a small step."""
    surface, p, attributes = maps.pressed(case.rng, (13, 11))
    maps.write_netcdf(case.path("in.nc"), surface, fields={"pressure": (p, "Pa")}, attributes=attributes)
    x0, y0 = (float(v) for v in case.rng.uniform(-3e-6, 3e-6, 2))
    z0, h = float(case.rng.uniform(2e-6, 5e-6)), 2e-8
    steps = [(a, s) for a in range(3) for s in (1, -1)]
    places = []
    for axis, sign in steps:
        at = [x0, y0, z0]
        at[axis] += sign * h
        places.append(" ".join(f"{v!r}m" for v in at))
    case.path("places").write_text("\n".join(places) + "\n")
    run = case.done("stress", "in.nc", "--points", "places", "--components", "all", "--json")
    table = strict_json(run.out)
    names = [["xx", "xy", "xz"], ["xy", "yy", "yz"], ["xz", "yz", "zz"]]
    for row in names:
        slopes_of = []
        for axis, name in enumerate(row):
            column = next(c["values"] for key, c in table.items() if key.endswith(name))
            slopes_of.append((column[2 * axis] - column[2 * axis + 1]) / (2 * h))
        check(abs(sum(slopes_of)) <= 1e-3 * max(map(abs, slopes_of)) + 1e-4 * p.max() / 1e-6,
              f"stresses in balance along {row[0][0]}")
    return RIGHT


FAULTS = [texture_in_any_unit, periodic_line, periodic_wide, periodic_wide, lone_line_validate, noisy_table, noisy_table]
FAMILIES = [above_a_form, filtered, cut_and_thinned, holes_filled, acf_with_holes, ensemble_of_strangers, two_rough_bodies,
            load_and_approach, acf_by_sums, psd_by_transform, quantiles, slopes, heights_of_any_surface, same_in_any_unit,
            ensemble, periodic,
            noisy_table,
            contact, contact, contact, hertz, turned_contact, contact_in_any_unit, stress_by_quadrature,
            stress_in_equilibrium,
            narrow_validate]
