"""Contact of an elastic half-space by Polonsky's and Keer's conjugate gradients, as plainly as numpy allows.

It shares nothing with Asperity: neither code nor its algorithm. Pressures are bounded by 0 and a limit.

I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219, for the iteration; A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420,
for the displacement of a cell.
"""
import numpy as np


def potential(x, y):
    """Double integral of 1/r from the origin to (x, y)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.nan_to_num(x * np.arcsinh(y / np.abs(x))) + np.nan_to_num(y * np.arcsinh(x / np.abs(y)))


def free_operator(shape, dx, dy, modulus):
    """Pressure to displacement: every cell's on every other, by a padded FFT."""
    nx, ny = shape
    i = np.fft.fftfreq(2 * nx, 1 / (2 * nx)).astype(np.longdouble)[:, None] * dx
    j = np.fft.fftfreq(2 * ny, 1 / (2 * ny)).astype(np.longdouble)[None, :] * dy
    a, b = dx / 2, dy / 2
    cell = potential(i + a, j + b) - potential(i - a, j + b) - potential(i + a, j - b) + potential(i - a, j - b)
    symbol = np.fft.rfft2((cell / (np.pi * modulus)).astype(float))
    return lambda p: np.fft.irfft2(symbol * np.fft.rfft2(p, (2 * nx, 2 * ny)), (2 * nx, 2 * ny))[:nx, :ny]


def periodic_operator(shape, dx, dy, modulus):
    """The same of a surface that repeats: 2 / (E* q) of each wave."""
    q = 2 * np.pi * np.hypot(np.fft.fftfreq(shape[0], dx)[:, None], np.fft.rfftfreq(shape[1], dy)[None, :])
    symbol = np.divide(2, modulus * q, out=np.zeros_like(q), where=q > 0)
    return lambda p: np.fft.irfft2(symbol * np.fft.rfft2(p), shape)


def shifted(p, total, limit):
    """What touches, pressed more or less by the same amount within the bounds, so that the sum is right."""
    low, high, touches = -limit, limit, p > 0
    for _ in range(120):
        shift = (low + high) / 2
        out = np.where(touches, np.clip(p + shift, 0, limit), 0)
        low, high = (low, shift) if out.sum() > total else (shift, high)
    return out


def press(gap, operator, total, limit=np.inf, tolerance=1e-14, most=20000):
    """The pressure of this sum, and the approach."""
    p = np.full(gap.shape, total / gap.size)
    t, last, conjugate = np.zeros_like(p), 1.0, 0.0
    for _ in range(most):
        free = (p > 0) & (p < limit)
        g = operator(p) + gap
        approach = g[free].mean()
        g -= approach
        squares = (g[free] ** 2).sum()
        t = np.where(free, g + conjugate * squares / last * t, 0)
        last = squares
        r = operator(t)
        r -= r[free].mean()
        step = (g * t)[free].sum() / (r * t)[free].sum()
        before = p
        p = np.clip(p - step * t, 0, limit)
        pushed, pulled = (p == 0) & (g < 0), (p == limit) & (g > 0)
        conjugate = 0.0 if pushed.any() or pulled.any() else 1.0
        p[pushed | pulled] -= step * g[pushed | pulled]
        p = p * (total / p.sum()) if np.isinf(limit) else shifted(np.clip(p, 0, limit), total, limit)
        if np.abs(p - before).max() <= tolerance * p.max():
            return p, approach
    raise RuntimeError("no convergence")
