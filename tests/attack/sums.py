"""What the library computes by transforms and recurrences, as plain sums."""
import numpy as np
from scipy import signal

MODULUS, POISSON = 200e9, 0.3
COMPOSITE = MODULUS / (2 * (1 - POISSON**2))


def autocorrelation(z):
    """R(p, q) / R(0, 0) for p >= 0, each divided by its pairs: sums, lag by lag."""
    d = z - z.mean()
    sums = signal.correlate(d, d, method="direct")
    pairs = signal.correlate(np.ones_like(d), np.ones_like(d), method="direct").round()
    whole = sums / pairs / (d**2).mean()
    return whole[z.shape[0] - 1:], pairs[z.shape[0] - 1:]


def wrapped(length, shape):
    """exp(-ln 10 r / length), summed over the periods, 1 at the origin."""
    nx, ny = (int(4 * length / n) + 2 for n in shape)  # periods to either side, as many as the correlation reaches
    x, y = (np.arange(-periods * n, (periods + 1) * n) for periods, n in zip((nx, ny), shape))
    r = np.hypot(*np.meshgrid(x, y, indexing="ij"))
    rho = np.exp(-np.log(10) * r / length).reshape(2 * nx + 1, shape[0], 2 * ny + 1, shape[1]).sum((0, 2))
    return rho / rho[0, 0]


def love(nx, ny, dx, dy):
    """Displacement at (i dx, j dy) per unit of pressure on a cell at the origin, by Love's logarithms."""
    x, y = np.meshgrid(np.arange(-nx + 1, nx) * dx, np.arange(-ny + 1, ny) * dy, indexing="ij")
    xp, xm, yp, ym = x + dx / 2, x - dx / 2, y + dy / 2, y - dy / 2

    def part(a, b, c):
        return a * np.log((b + np.hypot(a, b)) / (c + np.hypot(a, c)))

    return (part(xp, yp, ym) + part(yp, xp, xm) + part(xm, ym, yp) + part(ym, xm, xp)) / (np.pi * COMPOSITE)


def displacement_of(p, dx, dy, is_periodic):
    if is_periodic:
        qx, qy = (2 * np.pi * np.fft.fftfreq(n, s) for n, s in zip(p.shape, (dx, dy)))
        q = np.hypot(*np.meshgrid(qx, qy, indexing="ij"))
        q[0, 0] = np.inf
        return np.real(np.fft.ifft2(np.fft.fft2(p) * 2 / (COMPOSITE * q)))
    return signal.convolve(p, love(*p.shape, dx, dy), mode="same", method="direct") if p.size < 300 else \
        signal.fftconvolve(np.pad(p, [(0, 0), (0, 0)]), love(*p.shape, dx, dy), mode="full")[
            p.shape[0] - 1:2 * p.shape[0] - 1, p.shape[1] - 1:2 * p.shape[1] - 1]


def boussinesq(x, y, z, nu):
    """Stresses below a unit force on a half-space (Johnson, Contact Mechanics, eq. 3.19), tension positive."""
    r2, rho = x**2 + y**2, np.sqrt(x**2 + y**2 + z**2)
    side = (1 - 2 * nu) / r2
    out = {"xx": side * ((1 - z / rho) * (x**2 - y**2) / r2 + z * y**2 / rho**3) - 3 * z * x**2 / rho**5,
           "yy": side * ((1 - z / rho) * (y**2 - x**2) / r2 + z * x**2 / rho**3) - 3 * z * y**2 / rho**5,
           "zz": -3 * z**3 / rho**5,
           "xy": side * ((1 - z / rho) * 2 * x * y / r2 - x * y * z / rho**3) - 3 * x * y * z / rho**5,
           "xz": -3 * x * z**2 / rho**5, "yz": -3 * y * z**2 / rho**5}
    return {name: value / (2 * np.pi) for name, value in out.items()}


def cerruti(x, y, z, nu):
    """Stresses below a unit force along x on the surface of a half-space (Johnson, eq. 3.76), tension positive."""
    rho = np.sqrt(x**2 + y**2 + z**2)
    near, side = rho + z, 1 - 2 * nu
    out = {"xx": -3 * x**3 / rho**5 + side * (x / rho**3 - 3 * x / (rho * near**2) + x**3 / (rho**3 * near**2)
                                              + 2 * x**3 / (rho**2 * near**3)),
           "yy": -3 * x * y**2 / rho**5 + side * (x / rho**3 - x / (rho * near**2) + x * y**2 / (rho**3 * near**2)
                                                  + 2 * x * y**2 / (rho**2 * near**3)),
           "zz": -3 * x * z**2 / rho**5,
           "xy": -3 * x**2 * y / rho**5 + side * (-y / (rho * near**2) + x**2 * y / (rho**3 * near**2)
                                                  + 2 * x**2 * y / (rho**2 * near**3)),
           "xz": -3 * x**2 * z / rho**5, "yz": -3 * x * y * z / rho**5}
    return {name: value / (2 * np.pi) for name, value in out.items()}


def stress_of_cells(p, dx, dy, at, nu, friction=0.0):
    """Every component at a point, by Gauss's rule with ten by ten points in each cell."""
    nodes, weights = np.polynomial.legendre.leggauss(10)
    sources = [((np.arange(n) + 0.5 - n / 2)[:, None] * s + nodes * s / 2).ravel() for n, s in zip(p.shape, (dx, dy))]
    share = np.outer(np.tile(weights, p.shape[0]), np.tile(weights, p.shape[1])) / 4 * dx * dy
    force = np.kron(p, np.ones((10, 10))) * share
    away = np.meshgrid(at[0] - sources[0], at[1] - sources[1], indexing="ij")
    normal, along = boussinesq(*away, at[2], nu), cerruti(*away, at[2], nu)
    return {name: ((normal[name] + friction * along[name]) * force).sum() for name in normal}
