#!/usr/bin/python3
"""Kernels of the exponential autocorrelation by Newton's method on dense Jacobians: the digits of tests/acf/kernel.cpp.

    validation/independent/kernel.py        half a minute

It shares nothing with Asperity. R(p, q) = exp(-c hypot(p/n, q/m)) at the lags p < n, q < m is the autocorrelation of white
noise averaged with the kernel a: of a kernel that is even in both indices, 2n-1 x 2m-1 weights, or of Patir's n x m weights.
"""
import numpy as np


def at(a, k, l):
    """Weights at these indices, zero outside the kernel."""
    inside = (k >= 0) & (l >= 0) & (k < a.shape[0]) & (l < a.shape[1])
    return np.where(inside, a[np.clip(k, 0, a.shape[0] - 1), np.clip(l, 0, a.shape[1] - 1)], 0)


def even(quadrant):
    half = np.vstack([quadrant[:0:-1], quadrant])
    return np.hstack([half[:, :0:-1], half])


def correlation(a, n, m):
    """Of the full kernel at the lags p < n, |q| < m: column m-1 is q = 0."""
    spectrum = np.abs(np.fft.fft2(a, (2 * a.shape[0], 2 * a.shape[1]))) ** 2
    return np.roll(np.fft.ifft2(spectrum).real, m - 1, 1)[:n, : 2 * m - 1]


def solve(n, m, c, patir=False):
    """The full kernel, by steps that are halved until the largest residual falls."""
    p, q = (index.ravel()[:, None] for index in np.indices((n, m)))
    k, l = p.T, q.T
    target = np.exp(-c * np.hypot(p / n, q / m)).ravel()
    full = (lambda a: a) if patir else even

    def residual(a):
        return correlation(full(a), n, m)[:, m - 1 :].ravel() - target

    def jacobian(a):
        if patir:
            return at(a, k + p, l + q) + at(a, k - p, l - q)
        around = [(s * k, t * l) for s in (1, -1) for t in (1, -1)]
        share = 1 / (np.where(k == 0, 2, 1) * np.where(l == 0, 2, 1))  # an index of zero is its own mirror image
        return 2 * share * sum(at(even(a), u + p + n - 1, v + q + m - 1) for u, v in around)

    a = np.zeros((n, m))
    a[0, 0] = 1
    for share in (0.25, 0.5, 0.75, 1):  # from independent heights to the target
        goal = share * target
        goal[0] = 1
        for _ in range(50):
            f = residual(a) + target - goal
            if np.abs(f).max() < 3e-16 * n * m:
                break
            step, length = np.linalg.solve(jacobian(a), f).reshape(n, m), 1.0
            while length > 1e-3 and np.abs(residual(a - length * step) + target - goal).max() > np.abs(f).max():
                length /= 2
            a = a - length * step
    return full(a), np.abs(residual(a)).max()


def main():
    for n, m, c, patir in ((3, 3, 4.6, False), (7, 4, 4.6, False), (31, 31, 4.6, False), (31, 31, 7, False),
                           (7, 7, 4.6, True), (31, 31, 4.6, True)):
        a, left = solve(n, m, c, patir)
        row, column = (0, 0) if patir else (n - 1, m - 1)
        p, q = np.indices((n, 2 * m - 1))
        off = np.abs(correlation(a, n, m) - np.exp(-c * np.hypot(p / n, (q - m + 1) / m)))[1:, : m - 1].max()
        print(f"{n} x {m}, c = {c}{', Patir' * patir}: first {a[row, column]:.12f}, next {a[row, column + 1]:.12f}, "
              f"sum {a.sum():.12f}, mirrored lags off by {off:.6f}, residual {left:.0e}")


if __name__ == "__main__":
    main()
