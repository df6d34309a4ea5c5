"""Stress below a pressure on rectangular cells: the point loads of Boussinesq and Cerruti, integrated over each cell by Gauss's rule.

It shares nothing with Asperity, which has closed forms for a cell. Tension is positive, z points into the body.

K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), (3.19) and (3.76), for the point loads.
"""
import numpy as np


def normal_load(x, y, z, nu):
    """xx, yy, zz, xy, xz, yz of a unit force along z at the origin, times 2 pi."""
    r = np.sqrt(x * x + y * y + z * z)
    s, u = r + z, 1 - 2 * nu
    common = u * (z / r**3 - 1 / (r * s))
    mixed = u * (2 * r + z) / (r**3 * s**2) - 3 * z / r**5
    return [common + x * x * mixed, common + y * y * mixed, -3 * z**3 / r**5, x * y * mixed, -3 * x * z * z / r**5,
            -3 * y * z * z / r**5]


def tangential_load(x, y, z, nu):
    """The same of a unit force along x."""
    r = np.sqrt(x * x + y * y + z * z)
    s, u = r + z, 1 - 2 * nu
    third = u * (1 / (r**3 * s**2) + 2 / (r**2 * s**3)) - 3 / r**5
    return [x**3 * third + u * x * (1 / r**3 - 3 / (r * s * s)), x * y * y * third + u * x * (1 / r**3 - 1 / (r * s * s)),
            -3 * x * z * z / r**5, x * x * y * third - u * y / (r * s * s), -3 * x * x * z / r**5, -3 * x * y * z / r**5]


def stress_at(point, pressure, dx, dy, nu, friction=0.0, nodes=12):
    """Six stresses at (x, y, depth) under a pressure on cells about the origin, and a traction friction * pressure along x."""
    nx, ny = pressure.shape
    loaded = np.argwhere(pressure > 0)
    x = point[0] - (loaded[:, 0] + 0.5 - nx / 2) * dx
    y = point[1] - (loaded[:, 1] + 0.5 - ny / 2) * dy
    at, weight = np.polynomial.legendre.leggauss(nodes)
    p = pressure[pressure > 0]
    total = np.zeros(6)
    for s, v in zip(at, weight):
        for t, w in zip(at, weight):
            place = x + s * dx / 2, y + t * dy / 2, point[2]
            for load, share in ((normal_load, 1.0), (tangential_load, friction)):
                if share != 0:
                    total += share * v * w / 4 * np.array([(p * part).sum() for part in load(*place, nu)])
    return total * dx * dy / (2 * np.pi)
