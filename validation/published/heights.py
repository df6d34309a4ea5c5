"""Published statistics of random surfaces: functions that yield rows (quantity, at, published, here, error, doubt)."""
import numpy as np
from scipy import special

import asperity as asp
from scenes import SIDE, mean

EFOLD = np.exp(-1)


def peaks():
    """Whitehouse and Archard's peaks

    Of profiles with the autocorrelation rho of neighbours and rho^2 of next ones the share atan sqrt((3 -
    rho)/(1 + rho)) / pi is higher than both neighbours (D. J. Whitehouse, J. F. Archard, Proc. R. Soc. A
    316 (1970) 97-121): a third where points are independent, a quarter where they are close. The profiles
    of one exponential surface of 1024 x 1024 points, each 1, 2, 4, 8, 16 points.
    """
    length = 20
    body = asp.generate(periodic=True, shape=(1024, 1024), size=asp.si(SIDE), rq="1um", model="exponential",
                        length=f"{length}px", length_level=EFOLD, seed=1)
    for step in (1, 2, 4, 8, 16):
        z = body.heights.values[::step]
        higher = (z > np.roll(z, 1, 0)) & (z > np.roll(z, -1, 0))
        rho = np.exp(-step / length)
        strips = higher.reshape(len(z), 16, 64).mean((0, 2))  # of 64 profiles, three lengths wide
        yield "share of peaks", rho, np.arctan(np.sqrt((3 - rho) / (1 + rho))) / np.pi, *mean(strips), 0


def summits():
    """Nayak's summits

    Density m4 / (6 pi sqrt(3) m2), mean height 4 sqrt(m0 / (pi alpha)) and deviation sqrt((1 -
    0.8968/alpha) m0) of the summits of Gaussian surfaces (P. R. Nayak, J. Lubr. Technol. 93 (1971) 398-407;
    the latter two after J. I. McCool, Wear 107 (1986) 37-60), by the bandwidth alpha = m0 m4 / m2^2. The
    moments are those of the waves that were drawn; asperity-stats counts. 32 cells in the shortest wave.
    """
    n = 1024
    q = 2 * np.pi / SIDE * np.fft.fftfreq(n, 1 / n)
    for rolloff, hurst in ((36, 0.8), (128, 0.3), (256, 0.3), (256, 0.8)):
        body = asp.generate(periodic=True, shape=(n, n), size=asp.si(SIDE), rq="0.1um", model="self-affine",
                            hurst=hurst, rolloff=f"{rolloff}px", cutoff="32px", seed=5)
        power = np.abs(np.fft.fft2(body.heights.values)) ** 2 / n**4
        m0, m2, m4 = (((np.abs(q[:, None]) ** k + np.abs(q[None, :]) ** k) / 2 * power).sum() for k in (0, 2, 4))
        alpha, found = m0 * m4 / m2**2, asp.stats(body, parameters="hybrid")
        for name, label, published in (("density", "density / (m4/m2)", 1 / (6 * np.pi * np.sqrt(3))),
                                       ("height", "mean height / Sq", 4 / np.sqrt(np.pi * alpha)),
                                       ("deviation", "deviation / Sq", np.sqrt(1 - 0.8968 / alpha))):
            row, unit = found.loc[f"summit_{name}"], m4 / m2 if name == "density" else np.sqrt(m0)
            yield label, alpha, published, row.value / unit, row.standard_error / unit, 0


def kernels():
    """Garcia and Stoll's kernel

    White noise averaged with the weights 2/sqrt(pi) exp(-2 r^2) has the autocorrelation exp(-r^2), lengths
    in l and weights in l^2 a cell (N. Garcia, E. Stoll, Phys. Rev. Lett. 52 (1984) 1798-1801). The root of
    the spectrum of exp(-r) gives likewise the weights K_1/4(r) (2/r)^(1/4) / (sqrt(2 pi) G(3/4)).
    asperity-kernel solves for those of the cells, 16 in l; `error` is what 8 change there or further out.
    """
    closed = {"gaussian": lambda r: 2 / np.sqrt(np.pi) * np.exp(-2 * r**2),
              "exponential": lambda r: special.kv(0.25, r) * (2 / r) ** 0.25 / (np.sqrt(2 * np.pi) * special.gamma(0.75))}
    radii = np.array([0.25, 0.5, 0.75, 1, 1.5, 2])
    for model, weight in closed.items():
        found = []
        for cells in (8, 16):
            values = asp.kernel(model=model, length=f"{cells}px", length_level=EFOLD, spacing="1um",
                                acf_tolerance=1e-5).kernel.values
            middle = values.shape[0] // 2
            found.append(values[middle + (radii * cells).astype(int), middle] * cells)
        change = np.maximum.accumulate(np.abs(np.diff(found, axis=0))[0, ::-1])[::-1]
        for r, fine, error in zip(radii, found[1], change):
            yield f"weight, {model}", r, weight(r), fine, error, 0


def spectrum():
    """The slope of a self-affine spectrum

    C(q) ~ q^-2(1 + H) (B. N. J. Persson et al., J. Phys.: Condens. Matter 17 (2005) R1-R62). A referee asks
    whether the exponent that went into a surface comes out of its measured spectrum. Drawn by
    asperity-generate, 1024 x 1024 points, roll-off at 128 and cut-off at 8 points; a straight line through
    the rings of asperity-psd between, each with its error. Of 24 seeds at H = 0.8 the exponents deviate by
    1.01 of the line's error.
    """
    for seed, hurst in enumerate((0.2, 0.4, 0.6, 0.8, 1.0), 20):
        body = asp.generate(periodic=True, shape=(1024, 1024), size=asp.si(SIDE), rq="0.1um", model="self-affine",
                            hurst=hurst, rolloff="128px", cutoff="8px", seed=seed)
        rings = asp.psd(body, result="radial")
        longest, shortest = 2 * np.pi * 1024 / SIDE / 100, 2 * np.pi * 1024 / SIDE / 9
        rings = rings[(rings.wave_number > longest) & (rings.wave_number < shortest)]
        line, covariance = np.polyfit(np.log(rings.wave_number), np.log(rings.psd), 1, w=rings.psd / rings.standard_error,
                                      cov="unscaled")
        yield "exponent of C(q)", hurst, -2 * (1 + hurst), line[0], np.sqrt(covariance[0, 0]), 0
