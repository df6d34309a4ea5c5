"""Published stresses below contacts. Each function yields rows (quantity, at, published, here, error, doubt), see run."""
import numpy as np
from scipy import special
from scipy.optimize import minimize_scalar

import asperity as asp
from scenes import MODULUS, NU, STEEL, YOUNG, of

MINOR, PEAK = 0.1e-3, 3e9  # the smaller half axis, and Hertz's pressure
JOHNSON = {0.2: (0.3215, 0.745), 0.4: (0.3252, 0.665), 0.6: (0.3221, 0.590), 0.8: (0.3165, 0.530), 1.0: (0.3100, 0.480)}


def curvatures(ratio):
    """Of Hertz's contact with the half axes MINOR / ratio and MINOR, along them: Johnson (4.26), (4.28)."""
    if ratio == 1:
        return (np.pi * PEAK / (2 * MODULUS * MINOR),) * 2
    major, k2 = MINOR / ratio, 1 - ratio**2
    first, second = special.ellipk(k2), special.ellipe(k2)
    scale = 2 * PEAK * ratio / (MODULUS * k2 * major)
    return scale * (first - second), scale * (second / ratio**2 - first)


def ellipse(ratio, n=384):
    along, across = curvatures(ratio)
    return asp.contact(smooth=True, shape=(n, n), size=asp.si((3 * MINOR / ratio, 3 * MINOR)),
                       radius_x=asp.si((1 / along, np.inf)), radius_y=asp.si((1 / across, np.inf)),
                       load=asp.si(2 / 3 * PEAK * np.pi * MINOR**2 / ratio), tolerance=1e-9, add="grid_errors", **STEEL)


def deepest(ratio, contact=None):
    """The largest shear stress in p0 and its depth in b, each with its error."""
    found = asp.stress(contact or ellipse(ratio), maximum=True, of="max_shear", add="grid_errors")
    return ((found.stress_max_shear / PEAK, found.stress_max_shear_error / PEAK),
            (found.stress_max_depth / MINOR, found.stress_max_depth_error / MINOR))


def axis_shear(z, ratio, n=200):
    """The largest shear stress in p0 on the axis, z in b: Boussinesq's point loads (Johnson (3.18)), by quadrature."""
    node, weight = np.polynomial.legendre.leggauss(n)
    t, f = np.pi / 4 * (node[:, None] + 1), 2 * np.pi * np.arange(n) / n
    x, y = np.sin(t) * np.cos(f) / ratio, np.sin(t) * np.sin(f)
    load = np.pi / 4 * weight[:, None] * np.sin(t) * np.cos(t) ** 2 / ratio / n  # p dA / 2 pi
    r2, rho = x**2 + y**2, np.sqrt(x**2 + y**2 + z**2)

    def along(x, y):
        spread = (x**2 - y**2) / (r2 * rho * (rho + z)) + z * y**2 / (r2 * rho**3)
        return (load * ((1 - 2 * NU) * spread - 3 * z * x**2 / rho**5)).sum()

    return np.ptp([along(x, y), along(y, x), (-3 * load * z**3 / rho**5).sum()]) / 2


def hertz():
    """Hertz's ellipses

    Pressure by H. Hertz (1882), as in K. L. Johnson, Contact Mechanics (1985), (4.22)-(4.29), and the
    largest shear stress below of his Table 4.1, for nu = 0.3. Its depth is that of Boussinesq's point
    loads, integrated over the ellipse. 384 x 384 cells.
    """
    for ratio, (shear, _) in JOHNSON.items():
        contact = ellipse(ratio)
        exact = minimize_scalar(lambda z: -axis_shear(z, ratio), bounds=(0.2, 1.2), method="bounded",
                                options={"xatol": 1e-7})
        found, depth = deepest(ratio, contact)
        yield "largest pressure / p0", ratio, 1, *of(contact, "max_pressure", PEAK), 0
        yield "largest shear stress / p0", ratio, shear, *found, 5e-5
        yield "its depth z/b", ratio, exact.x, *depth, 1e-5


def sliding():
    """Hamilton's sliding sphere

    sqrt(J2)/p0 below a sphere that slides with the friction mu, nu = 0.3: its largest value is below up to
    mu = 0.3, 0.3580 without friction and 0.3739 at 0.25, and then behind the sphere at the edge, by G. M.
    Hamilton's closed form (Proc. Inst. Mech. Eng. C 197 (1983) 53-59): sigma_x = (1 - 2 nu)/3 + pi mu (4 +
    nu)/8, sigma_y = 3 pi mu nu/8 - (1 - 2 nu)/3. At the edge the cells converge with the order 1/2 only,
    and no grid of this size comes close.
    """
    a, p0 = 0.2e-3, 2e9
    load, radius = 2 / 3 * p0 * np.pi * a**2, 2 * a * MODULUS / (np.pi * p0)
    contact = asp.contact(smooth=True, shape=(384, 384), size=asp.si((3 * a, 3 * a)), radius=asp.si((radius, np.inf)),
                          load=asp.si(load), tolerance=1e-9, **STEEL)
    for friction in (0, 0.25, 0.4, 0.5):
        found = asp.stress(contact, maximum=True, friction=friction, add="grid_errors")
        along = (1 - 2 * NU) / 3 + np.pi * friction * (4 + NU) / 8
        across = 3 * np.pi * friction * NU / 8 - (1 - 2 * NU) / 3
        edge = np.sqrt((along**2 + across**2 - along * across) / 3)
        published, doubt = {0: (0.3580, 5e-5), 0.25: (0.3739, 5e-5)}.get(friction, (edge, 0))
        scale = np.sqrt(3) * p0
        yield ("sqrt(J2) / p0" + ", at the edge" * (friction > 0.3), friction, published,
               found.stress_max_von_mises / scale, found.stress_max_von_mises_error / scale, doubt)


def line_contact():
    """Line contact, rolling and sliding

    On the axis of a line contact of half width a sigma_x = -p0 ((1 + 2 z^2)/sqrt(1 + z^2) - 2 z), sigma_z =
    -p0 / sqrt(1 + z^2), z in a (E. McEwen, Phil. Mag. 40 (1949) 454-459), so that the largest shear stress
    below is 0.30028 p0 at 0.78615 a. With a friction of 1/3 it is 0.43 p0 at the surface for nu = 0.25 (J.
    O. Smith, C. K. Liu, J. Appl. Mech. 20 (1953) 157-166). A referee asks for it since rollers and gears
    touch along lines. Cylinders that repeat along x, four rows of 256 cells: too few rows for errors of the
    grid, `error` is what 128 cells change.
    """
    coarse, fine = (rolled(n) for n in (128, 256))
    z = np.array(AXIS)
    root = np.sqrt(1 + z**2)
    golden = np.sqrt((np.sqrt(5) - 1) / 2)
    published = [*((1 + 2 * z**2) / root - 2 * z), *(1 / root), golden - golden**2 / np.sqrt(1 + golden**2), golden, 0.43]
    names = ["-sigma_x / p0"] * len(z) + ["-sigma_z / p0"] * len(z)
    names += ["largest shear stress / p0", "its depth z/a", "largest shear stress / p0 at mu = 1/3"]
    doubts = [0] * (2 * len(z) + 2) + [0.005]
    for name, at, exact, c, f, doubt in zip(names, [*AXIS, *AXIS, golden, golden, 0], published, coarse, fine, doubts):
        yield name, at, exact, f, abs(f - c), doubt


AXIS = (0.25, 0.5, 1, 1.5, 2)


def rolled(n, a=0.2e-3, p0=2e9, nu=0.25):
    """On n cells across: -sigma_x, -sigma_z on the axis, the largest shear stress, its depth, and that with friction."""
    modulus, width, rows = YOUNG / (1 - nu**2) / 2, 4 * a, 4
    contact = asp.contact(smooth=True, boundary="periodic_x", shape=(rows, n), size=asp.si((rows * width / n, width)),
                          young=asp.si(YOUNG), poisson=nu, radius_y=asp.si((modulus * a / (2 * p0), np.inf)),
                          load=asp.si(np.pi / 2 * a * p0 * rows * width / n), tolerance=1e-9)
    points = {"x [m]": [0] * len(AXIS), "y [m]": [0] * len(AXIS), "depth [m]": [z * a for z in AXIS]}
    stress = asp.stress(contact, points=points, components="yy,zz")
    still = asp.stress(contact, maximum=True, of="max_shear")
    slides = asp.stress(contact, maximum=True, of="max_shear", friction=1 / 3, friction_angle="90deg")
    return [*(-stress.stress_yy / p0), *(-stress.stress_zz / p0), still.stress_max_shear / p0, still.stress_max_depth / a,
            slides.stress_max_shear / p0]
