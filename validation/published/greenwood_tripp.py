"""A smooth sphere on a rough plane whose summits yield like Hertz's and do not feel each other.

J. A. Greenwood, J. H. Tripp, The elastic contact of rough spheres, J. Appl. Mech. 34 (1967) 153-159. With lengths in
a0, pressures in p0 and heights in a0^2/R of the smooth sphere, alpha = sigma R/a0^2 and mu = 8/3 eta sigma sqrt(2 R beta)
of summits of the radius beta, eta an area, which deviate by sigma:
    p(r) = pi mu sqrt(alpha) / (4 sqrt 2) F(d(r)/alpha)
    F(h) = int_h^inf (s - h)^(3/2) phi(s) ds,   d = r^2/2 - delta + w[p]
"""
import numpy as np
from scipy import special
from scipy.optimize import brentq


def excess(m, h):
    """int_h^inf (s - h)^m phi(s) ds, phi the standard normal density, by the parabolic cylinder function."""
    h = np.clip(h, -45, 35)
    return special.gamma(m + 1) / np.sqrt(2 * np.pi) * np.exp(-(h**2) / 4) * special.pbdv(-m - 1, h)[0]


def disc(r, radius):
    """Displacement at r of a disc of uniform pressure p0, in a0^2/R (K. L. Johnson, Contact Mechanics, 1985, (3.29))."""
    ratio = np.minimum(r, radius) / np.maximum(r, radius)
    first, second = special.ellipk(ratio**2), special.ellipe(ratio**2)
    return 8 / np.pi**2 * np.where(r < radius, radius * second, r * (second - (1 - ratio**2) * first))


def solve(alpha, mu, n=150):
    """Pressure at the centre in p0, and the effective radius 3 pi int p r dr / (4 int p dr) in a0."""
    edge = np.linspace(0, 1.5 + 3 * np.sqrt(alpha), n + 1)
    r, ring = (edge[1:] + edge[:-1]) / 2, np.pi * np.diff(edge**2)
    elastic = disc(r[:, None], edge[None, 1:])
    elastic[:, 1:] -= elastic[:, :-1].copy()
    scale = np.pi * mu * np.sqrt(alpha) / (4 * np.sqrt(2))

    def pressure(delta):
        p = np.zeros(n)
        for _ in range(50):  # Newton's: F is convex, so that it arrives from one side
            h = (r**2 / 2 - delta + elastic @ p) / alpha
            jacobian = np.eye(n) + 1.5 * scale / alpha * excess(0.5, h)[:, None] * elastic
            step = np.linalg.solve(jacobian, scale * excess(1.5, h) - p)
            p = p + step
            if np.abs(step).max() < 1e-9:
                break
        return p

    p = pressure(brentq(lambda delta: pressure(delta) @ ring - 2 / 3 * np.pi, -4 * alpha, 2 + 4 * alpha, xtol=1e-7))
    return p[0], 3 * np.pi / 4 * (p * r).sum() / p.sum()
