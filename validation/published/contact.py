"""Published contacts of smooth bodies. Each function yields rows (quantity, at, published, here, error, doubt), see run."""
import numpy as np
from scipy import special

import asperity as asp
from scenes import MODULUS, SIDE, STEEL, cells, of, pressed, surface


def westergaard():
    """Westergaard's wavy flat

    A flat of waves D cos(2 pi x / L) under a mean pressure below p* = pi E* D / L touches on the share 2/pi
    asin sqrt(p/p*), with the largest pressure 2 sqrt(p p*) (H. M. Westergaard, Bearing pressures and
    cracks, J. Appl. Mech. 6 (1939) A49-A53); the mean gap as K. L. Johnson gives it (Contact Mechanics,
    1985, section 13.2). 1024 cells in a wave.
    """
    height, n, m = 1e-6, 1024, 128
    x, _ = cells(n, m)
    full, area = np.pi * MODULUS * height / SIDE, SIDE * SIDE * m / n
    shares = [0.1, 0.3, 0.5, 0.7, 0.9]
    contacts = pressed(height * np.cos(2 * np.pi * x / SIDE), [share * full * area for share in shares])
    for share, contact in zip(shares, contacts):
        gap = 2 * ((1 - share) / 2 + share * np.log(np.sqrt(share)))
        yield "area share", share, 2 / np.pi * np.arcsin(np.sqrt(share)), *of(contact, "area_corrected", area), 0
        yield "mean gap / D", share, gap, *of(contact, "mean_gap", height), 0
        yield "largest pressure / p*", share, 2 * np.sqrt(share), *of(contact, "max_pressure", full), 0


EGG_BOX = [0.1, 0.3, 0.5, 0.7]  # loads at which others have solved it


def egg_box_at(shares, n=512, height=1e-6):
    """Contacts on an egg box of one period, D cos cos, at these shares of p*."""
    x, y = cells(n)
    full = np.sqrt(2) * np.pi * MODULUS * height / SIDE
    heights = height * np.cos(2 * np.pi * x / SIDE) * np.cos(2 * np.pi * y / SIDE)
    return pressed(heights, [share * full * SIDE**2 for share in shares])


def egg_box():
    """The egg box of Johnson, Greenwood and Higginson

    D cos(2 pi x / L) cos(2 pi y / L), p* = sqrt(2) pi E* D / L: Hertz's area at a low load, 1 - 3 (1 -
    p/p*)/(2 pi) near full contact (K. L. Johnson, J. A. Greenwood, J. G. Higginson, The contact of elastic
    regular wavy surfaces, Int. J. Mech. Sci. 27 (1985) 383-396). Between, no closed form is known: the
    published figures there are of two other codes. The doubt of Hertz's law is what neighbours add, here a
    hundredth.
    """
    hertz = np.pi * (3 / (8 * np.pi) * 0.001) ** (2 / 3)
    low, *middle, high = egg_box_at([0.001, *EGG_BOX, 0.95])
    yield "area share, Hertz", 0.001, hertz, *of(low, "area_corrected", SIDE**2), 0.01 * hertz
    for share, published, contact in zip(EGG_BOX, (0.1906, 0.5143, 0.7042, 0.8399), middle):
        yield "area share, two other codes", share, published, *of(contact, "area_corrected", SIDE**2), 5e-4
    yield "area share, full contact", 0.95, 1 - 3 / (2 * np.pi) * 0.05, *of(high, "area_corrected", SIDE**2), 2e-4


def bearing(make, depth):
    """The load on a rigid body that sinks into a half-space, and twice what half as many cells change, for order one."""
    coarse, fine = (asp.contact(surface(make(n)), approach=asp.si(depth), tolerance=1e-9, **STEEL).contact_load
                    for n in (256, 512))
    return fine, 2 * abs(fine - coarse)


DEPTH = 1e-6


def square_punch():
    unit = MODULUS * SIDE / 2 * DEPTH
    shape = lambda n: np.where(np.maximum(*np.abs(cells(n))) < SIDE / 4, 0.0, -1e-3)
    return (load / unit for load in bearing(shape, DEPTH))


def punches():
    """Indenters of powers of the radius, and the square punch

    A body of the shape c r^n that sinks by d touches to the radius a, where d = c a^n sqrt(pi) G(n/2 + 1) /
    G(n/2 + 1/2), and bears 2 n/(n + 1) E* a d (L. A. Galin, 1946; I. N. Sneddon, Int. J. Eng. Sci. 3 (1965)
    47-57): a cone, a sphere and blunter bodies. A square punch of side L bears 1.1522966 E* L d (F. H.
    Read, cited with R. B. King, Int. J. Solids Struct. 23 (1987) 1657-1664).
    """
    radius = SIDE / 5
    for n in (1, 2, 4, 6):
        steep = DEPTH / (radius**n * np.sqrt(np.pi) * special.gamma(n / 2 + 1) / special.gamma(n / 2 + 0.5))
        load, error = bearing(lambda m: -steep * np.hypot(*cells(m)) ** n, DEPTH)
        unit = 2 * MODULUS * radius * DEPTH
        yield "load of c r^n / (2 E* a d)", n, n / (n + 1), load / unit, error / unit, 0
    yield "load of a square punch / (E* L d)", 8, 1.1522966, *square_punch(), 0


def off():
    """Published figures that are off

    R. L. Jackson and J. L. Streator's fit to the egg box (Wear 261 (2006) 1337-1347, equation (12)) errs by
    a tenth at a tenth of p*; slippy and ContactMechanics find the same cells in contact as the tools do (at
    0.3 p*, validation/peers/figures.tsv). King's 1.012 E* 2 sqrt(A/pi) d for the square punch (1987) is 0.9
    % less than Read's series, which the tools meet. In Johnson's Table 4.1 (1985) the depths z/b of the
    largest shear stress end in 0 or 5, and three of the five are further off than that explains; integrals
    of point loads and the tools have the same depth there, see Hertz's ellipses. The claim is that neither
    error explains the difference.
    """
    from stress import JOHNSON, deepest
    for share, contact in zip(EGG_BOX[:3], egg_box_at(EGG_BOX[:3])):
        low, high = np.pi * (3 / (8 * np.pi) * share) ** (2 / 3), 1 - 3 / (2 * np.pi) * (1 - share)
        fit = low * (1 - share**1.51) + high * share**1.04
        yield "area share of an egg box, Jackson and Streator's fit", share, fit, *of(contact, "area_corrected", SIDE**2), 0
    for ratio in (0.2, 0.6, 0.8):
        _, (depth, error) = deepest(ratio)
        yield "z/b of the largest shear stress, Johnson's Table 4.1", ratio, JOHNSON[ratio][1], depth, error, 0.0025
    yield "load of a square punch / (E* L d), King", 1, 1.012 * 2 / np.sqrt(np.pi), *square_punch(), 6e-4
