"""Surfaces, bodies and figures that the published results share: steel, a square of 1 mm, waves between two wavelengths."""
import numpy as np

import asperity as asp

YOUNG, NU = 210e9, 0.3
MODULUS = YOUNG / (1 - NU**2) / 2
STEEL = {"young": asp.si(YOUNG), "poisson": NU}
SIDE = 1e-3


def cells(n, m=None):
    """Centres of n x m cells on a square of 1 mm about the origin, or on a strip of square cells."""
    step = SIDE / n
    x = (np.arange(n) + 0.5 - n / 2) * step
    y = (np.arange(m or n) + 0.5 - (m or n) / 2) * step
    return np.meshgrid(x, y, indexing="ij")


def surface(heights, periodic=False):
    n, m = heights.shape
    out = asp.dataset(heights, size=asp.si((SIDE, SIDE * m / n)))
    for axis in ("x", "y"):
        out[axis].attrs["periodic"] = np.int32(periodic)
    return out


def pressed(heights, loads, **options):
    """Contacts of flats that repeat under these loads, with the errors of the grid."""
    body = surface(heights, True)
    options = {"add": "grid_errors", "tolerance": 1e-9, **STEEL, **options}
    return [asp.contact(body, load=asp.si(load), **options) for load in loads]


def of(contact, name, unit=1.0):
    """A figure and its error, in this unit."""
    return contact.attrs[f"contact_{name}"] / unit, contact.attrs.get(f"contact_{name}_error", np.nan) / unit


def mean(found):
    """The mean over surfaces and its standard error."""
    return np.mean(found), np.std(found, ddof=1) / np.sqrt(len(found))


def self_affine(n, low, high, hurst, seed):
    """Gaussian heights of 0.1 um rms with waves of low to high periods a side, C ~ q^-2(1+H)."""
    random = np.random.default_rng(seed)
    k = np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.rfftfreq(n, 1 / n)[None, :])
    amplitude = np.where((k >= low) & (k <= high), np.maximum(k, 1) ** -(1 + hurst), 0)
    heights = np.fft.irfft2(amplitude * np.fft.rfft2(random.standard_normal((n, n))))
    return 1e-7 * heights / heights.std()


def slope(heights):
    """The rms slope, by all waves."""
    n = heights.shape[0]
    q = 2 * np.pi / SIDE * np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.fftfreq(n, 1 / n)[None, :])
    return np.sqrt((q**2 * np.abs(np.fft.fft2(heights)) ** 2).sum()) / n**2
