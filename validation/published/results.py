"""Published results, computed by the tools: each a function that yields rows (quantity, published, here, error, doubt).

`error` is what the tools state for their figure, or where they state none, what twice as coarse a grid or more samples change;
`doubt` is that of the published figure: its last digit, or the scatter that its authors give.
"""
import numpy as np
from scipy import special

import asperity as asp

YOUNG, NU = 210e9, 0.3
MODULUS = YOUNG / (1 - NU**2) / 2
STEEL = {"young": YOUNG, "poisson": NU}
SIDE = 1e-3


def cells(n, m=None):
    """Centres of n x m cells on a square of 1 mm about the origin, or on a strip of square cells."""
    step = SIDE / n
    x = (np.arange(n) + 0.5 - n / 2) * step
    y = (np.arange(m or n) + 0.5 - (m or n) / 2) * step
    return np.meshgrid(x, y, indexing="ij")


def surface(heights, periodic=False):
    n, m = heights.shape
    out = asp.dataset(heights, size=(SIDE, SIDE * m / n))
    for axis in ("x", "y"):
        out[axis].attrs["periodic"] = np.int32(periodic)
    return out


def pressed(heights, loads):
    """Contacts of flats that repeat under these loads, with the errors of the grid."""
    body = surface(heights, True)
    return [asp.contact(body, load=load, add="grid_errors", tolerance=1e-9, **STEEL) for load in loads]


def of(contact, name, unit=1.0):
    """A figure and its error, in this unit."""
    return contact.attrs[f"contact_{name}"] / unit, contact.attrs.get(f"contact_{name}_error", np.nan) / unit


def westergaard():
    """H. M. Westergaard, Bearing pressures and cracks, J. Appl. Mech. 6 (1939) A49-A53: a wavy flat under a mean pressure below
    p* = pi E* D / L touches on a share 2/pi asin sqrt(p/p*); the mean gap as K. L. Johnson gives it (1985, section 13.2)."""
    height, n, m = 1e-6, 1024, 128
    x, _ = cells(n, m)
    full, area = np.pi * MODULUS * height / SIDE, SIDE * SIDE * m / n
    shares = [0.1, 0.3, 0.5, 0.7, 0.9]
    contacts = pressed(height * np.cos(2 * np.pi * x / SIDE), [share * full * area for share in shares])
    for share, contact in zip(shares, contacts):
        gap = 2 * ((1 - share) / 2 + share * np.log(np.sqrt(share)))
        yield f"area share at {share:g} p*", 2 / np.pi * np.arcsin(np.sqrt(share)), *of(contact, "area_corrected", area), 0
        yield f"mean gap / D at {share:g} p*", gap, *of(contact, "mean_gap", height), 0
        yield f"largest pressure / p* at {share:g} p*", 2 * np.sqrt(share), *of(contact, "max_pressure", full), 0


def egg_box():
    """K. L. Johnson, J. A. Greenwood, J. G. Higginson, The contact of elastic regular wavy surfaces, Int. J. Mech. Sci. 27 (1985)
    383-396: cos cos, p* = sqrt(2) pi E* D / L. By Hertz at a low load; one minus 3/(2 pi) (1 - p/p*) near full contact. The fit of
    R. L. Jackson and J. L. Streator, Wear 261 (2006) 1337-1347, equation (12), for comparison: it is off by up to a tenth."""
    height, n = 1e-6, 512
    x, y = cells(n)
    heights = height * np.cos(2 * np.pi * x / SIDE) * np.cos(2 * np.pi * y / SIDE)
    full = np.sqrt(2) * np.pi * MODULUS * height / SIDE
    area = SIDE**2
    radius = area / (4 * np.pi**2 * height)  # of two summits on the square
    low, high = pressed(heights, [0.001 * full * area, 0.95 * full * area])
    hertz = 2 * np.pi * (3 * (0.001 * full * area / 2) * radius / (4 * MODULUS)) ** (2 / 3) / area
    yield "area share at 0.001 p*, by Hertz", hertz, *of(low, "area_corrected", area), 0.01 * hertz
    yield "area share at 0.95 p*", 1 - 3 / (2 * np.pi) * 0.05, *of(high, "area_corrected", area), 2e-4
    for share, published in ((0.1, 0.1906), (0.3, 0.5143), (0.5, 0.7042), (0.7, 0.8399)):
        (middle,) = pressed(heights, [share * full * area])
        yield f"area share at {share:g} p*, by two other codes", published, *of(middle, "area_corrected", area), 5e-4


def ellipse(ratio, minor, p0):
    """Curvatures of Hertz's contact with the semi-axes minor / ratio and minor, along them: Johnson (4.26), (4.28)."""
    major, k2 = minor / ratio, 1 - ratio**2
    if ratio == 1:
        return (np.pi * p0 / (2 * MODULUS * minor),) * 2
    first, second = special.ellipk(k2), special.ellipe(k2)
    scale = 2 * p0 * ratio / (MODULUS * k2 * major)
    return scale * (first - second), scale * (second / ratio**2 - first)


def hertz():
    """H. Hertz (1882) as in K. L. Johnson, Contact Mechanics (1985), (4.22)-(4.29), and his Table 4.1 of the largest shear stress
    below, for nu = 0.3. The depths of the table are rounded to what a coarse search leaves."""
    minor, p0 = 0.1e-3, 3e9
    printed = {0.2: (0.3215, 0.745), 0.4: (0.3252, 0.665), 0.6: (0.3221, 0.590), 0.8: (0.3165, 0.530), 1.0: (0.3100, 0.480)}
    for ratio, (shear, depth) in printed.items():
        along, across = ellipse(ratio, minor, p0)
        contact = asp.contact(smooth=True, shape=(384, 384), size=(3 * minor / ratio, 3 * minor), radius_x=(1 / along, np.inf),
                              radius_y=(1 / across, np.inf), load=2 / 3 * p0 * np.pi * minor**2 / ratio, tolerance=1e-9,
                              add="grid_errors", **STEEL)
        yield f"p0 at b/a = {ratio:g} [GPa]", p0 / 1e9, *of(contact, "max_pressure", 1e9), 0
        found = asp.stress(contact, maximum=True, of="max_shear", add="grid_errors")
        yield f"tau_max / p0 at b/a = {ratio:g}", shear, found.stress_max_shear / p0, found.stress_max_shear_error / p0, 5e-5
        yield f"z/b there, b/a = {ratio:g}", depth, found.stress_max_depth / minor, found.stress_max_depth_error / minor, 0.006


def full_contact():
    """B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840-3861: in full contact every wave q of height h carries E* q h / 2, so that the
    pressure's deviation is E* Sdq / 2."""
    heights = self_affine(256, 4, 32, 0.8, 3) * 1e-7
    slope = spectral_slope(heights)
    contact = asp.contact(surface(heights, True), load=20 * MODULUS * slope * SIDE**2, tolerance=1e-9, **STEEL)
    yield "std(p) / (E* Sdq)", 0.5, float(contact.pressure.std()) / (MODULUS * slope), 1e-8, 0


def self_affine(n, low, high, hurst, seed):
    """Gaussian heights with waves of low to high periods a side, C ~ q^-2(1+H); unit slope is not implied."""
    random = np.random.default_rng(seed)
    k = np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.rfftfreq(n, 1 / n)[None, :])
    amplitude = np.where((k >= low) & (k <= high), np.maximum(k, 1) ** -(1 + hurst), 0)
    heights = np.fft.irfft2(amplitude * np.fft.rfft2(random.standard_normal((n, n))))
    return heights / heights.std()


def spectral_slope(heights):
    n = heights.shape[0]
    q = 2 * np.pi / SIDE * np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.fftfreq(n, 1 / n)[None, :])
    return np.sqrt((q**2 * np.abs(np.fft.fft2(heights)) ** 2).sum()) / n**2


def area_law():
    """Area over load of self-affine surfaces: S. Hyun et al., Phys. Rev. E 70 (2004) 026117; V. A. Yastrebov, G. Anciaux,
    J.-F. Molinari, Int. J. Solids Struct. 52 (2015) 83-102: kappa = A/A0 E* Sdq / p lies between Persson's sqrt(8/pi) and
    sqrt(2 pi) of Bush, Gibson and Thomas at light loads."""
    low, high, reduced = np.sqrt(8 / np.pi), np.sqrt(2 * np.pi), 0.01
    found = []
    for seed in range(4):
        heights = self_affine(512, 4, 32, 0.8, seed) * 1e-7
        (contact,) = pressed(heights, [reduced * MODULUS * spectral_slope(heights) * SIDE**2])
        found.append(contact.contact_area_corrected / SIDE**2 / reduced)
    yield f"kappa at p/(E* Sdq) = {reduced:g}", (low + high) / 2, np.mean(found), np.std(found, ddof=1) / 2, (high - low) / 2


def punches():
    """I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57: a cone of slope tan b that sinks by d bears 2/pi E* d^2 / tan b; and his other shapes alike. F. H. Read, cited with King's punch (R. B. King, Int. J.
    Solids Struct. 23 (1987) 1657-1664): a square punch of side L bears 1.1522966 E* L d; King's 1.012 E* 2 sqrt(A/pi) d is 0.9 % less."""
    def load(n, heights, depth):
        return asp.contact(surface(heights), approach=depth, tolerance=1e-9, **STEEL).contact_load

    def refined(make, depth):
        coarse, fine = (load(n, make(n), depth) for n in (256, 512))
        return fine, 2 * abs(fine - coarse)  # of order one or more

    depth, slope = 1e-6, 5e-3
    here, error = refined(lambda n: -slope * np.hypot(*cells(n)), depth)
    exact = 2 / np.pi * MODULUS * depth**2 / slope
    yield "load of a cone / Sneddon's", 1, here / exact, error / exact, 0
    square = lambda n: np.where(np.maximum(*np.abs(cells(n))) < SIDE / 4, 0.0, -1e-3)
    here, error = refined(square, depth)
    yield "load of a square punch / (E* L d)", 1.1522966, here / (MODULUS * SIDE / 2 * depth), error / (MODULUS * SIDE / 2 * depth), 0


def sliding():
    """G. M. Hamilton, Proc. Inst. Mech. Eng. C 197 (1983) 53-59: largest sqrt(J2)/p0 below a sliding sphere, nu = 0.3."""
    p0, radius_a = 2e9, 0.2e-3
    load, radius = 2 / 3 * p0 * np.pi * radius_a**2, 2 * radius_a * MODULUS / (np.pi * p0)
    contact = asp.contact(smooth=True, shape=(384, 384), size=(3 * radius_a, 3 * radius_a), radius=(radius, np.inf), load=load,
                          tolerance=1e-9, **STEEL)
    for friction, published in ((0.0, 0.3580), (0.25, 0.3739)):
        found = asp.stress(contact, maximum=True, friction=friction, add="grid_errors")
        yield (f"sqrt(J2)/p0 at mu = {friction:g}", published, found.stress_max_von_mises / np.sqrt(3) / p0,
               found.stress_max_von_mises_error / np.sqrt(3) / p0, 5e-5)


def gap_and_stiffness():
    """B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502; S. Akarapu, T. Sharp, M. O. Robbins, Phys. Rev. Lett. 106 (2011) 204301:
    p ~ exp(-u / (gamma h_rms)) of the mean gap u, so that dp/du = p / (gamma h_rms); gamma = 0.48, in simulations 0.4 to 0.5."""
    gaps, stiffnesses = [], []
    for seed in range(4):
        heights = self_affine(512, 4, 32, 0.8, seed) * 1e-7
        slope, reduced = spectral_slope(heights), np.array([0.01, 0.02, 0.04])
        table = asp.contact(surface(heights, True), sweep=",".join(f"{r * MODULUS * slope * SIDE**2!r}N" for r in reduced), **STEEL)
        u, p = np.array(table.mean_gap), np.array(table.load) / SIDE**2
        gaps.append(-np.polyfit(np.log(p), u, 1)[0] / heights.std())
        stiffnesses.append(p[1] / (np.array(table.stiffness)[1] / SIDE**2) / heights.std())
    for name, found in (("gamma from the gap", gaps), ("gamma from the stiffness", stiffnesses)):
        yield name, 0.45, np.mean(found), np.std(found, ddof=1) / np.sqrt(len(found)), 0.05


ALL = [westergaard, egg_box, punches, hertz, sliding, area_law, gap_and_stiffness, full_contact]
