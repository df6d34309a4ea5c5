"""Our own computation where a project expects another figure: by numpy alone, from the heights of the map."""
from functools import cached_property

import numpy as np
from scipy import ndimage
from scipy.integrate import trapezoid


def least_squares(x, y):
    """The line a + b x closest to the polygon through these points."""
    dx, length, middle = np.diff(x), x[-1] - x[0], (x[0] + x[-1]) / 2
    mean = np.sum(dx * (y[1:] + y[:-1]) / 2) / length
    left, right = (x[:-1] - middle) * (2 * y[:-1] + y[1:]), (x[1:] - middle) * (y[:-1] + 2 * y[1:])
    moment = np.sum(dx * (left + right) / 6)
    slope = 12 * moment / length**3
    return mean - slope * middle, slope


class Map:
    """Heights z [m], with steps h in x and y [m]; or the file that they come from."""

    def __init__(self, z, h, file):
        self.z, self.h, self.file = z, h, file

    def slope(self):
        """Sdq: sqrt(mean a^2 + mean b^2) of all sides in x, and all in y."""
        return np.sqrt(sum(np.mean(np.diff(self.z, axis=k) ** 2) / self.h[k] ** 2 for k in (0, 1)))

    def developed(self):
        """Sdr, by four triangles between the sides of a cell and its middle, at the corners' mean height."""
        a, b = (np.diff(self.z, axis=k) / self.h[k] for k in (0, 1))
        mean_a, mean_b = (a[:, 1:] + a[:, :-1]) / 2, (b[1:] + b[:-1]) / 2
        gradients = (a[:, 1:], mean_b), (a[:, :-1], mean_b), (mean_a, b[1:]), (mean_a, b[:-1])
        return np.mean([np.sqrt(1 + p**2 + q**2) for p, q in gradients]) - 1

    def slope_of_seven_points(self):
        """Pdq by the formula of ISO 4287 and ISO 21920-2, at points with three neighbours on both sides."""
        weights = np.array([-1, 9, -45, 0, 45, -9, 1]) / (60 * self.h[0])
        slopes = sum(weight * self.z[k:len(self.z) - 6 + k] for k, weight in enumerate(weights))
        return np.sqrt(np.mean(slopes**2))

    @cached_property
    def material(self):
        """Of the material ratio curve, with straight lines between all heights: ISO 25178-2, ISO 13565-2."""
        c = np.sort(self.z, axis=None)[::-1]
        p = np.linspace(0, 1, c.size)
        starts = np.concatenate((p[p <= 0.6], p[p >= 0.4] - 0.4))
        start = starts[np.argmin(np.interp(starts, p, c) - np.interp(starts + 0.4, p, c))]
        q = np.unique(np.concatenate(([start, start + 0.4], p[(p > start) & (p < start + 0.4)])))
        upper, fall = least_squares(q, np.interp(q, p, c))
        lower = upper + fall
        smr1, smr2 = np.interp([-upper, -lower], -c, p)
        over = lambda level: trapezoid(np.maximum(c - level, 0), p)
        under = lambda level: trapezoid(np.maximum(level - c, 0), p)
        c10, c80 = np.interp([0.1, 0.8], p, c)
        return {"Sk": upper - lower, "Smr1": smr1, "Smr2": smr2,
                "Spk": 2 * over(upper) / smr1, "Svk": 2 * under(lower) / (1 - smr2),
                "Vmp": over(c10), "Vmc": over(c80) - over(c10),
                "Vvv": under(c80), "Vvc": under(c10) - under(c80)}

    def filtered(self, cutoff):
        """Sq after the Gaussian filter of ISO 16610-61, whose weights have the sum one at the edges too."""
        sigma = [cutoff / step * np.sqrt(np.log(2) / 2) / np.pi for step in self.h]
        blur = lambda values: ndimage.gaussian_filter(values, sigma, mode="constant", truncate=8)
        return np.std(blur(self.z) / blur(np.ones(self.z.shape)))

    def measured_points(self):
        """Sq of a .sur file without the special points that its header announces: the least height less 2."""
        head = self.file.read_bytes()[:512]
        special = head[86]
        least, scale = np.frombuffer(head, "<i4", 1, 100)[0], np.frombuffer(head, "<f4", 1, 128)[0]
        heights = np.fromfile(self.file, "<i4", offset=512)
        return float(scale) * np.std(heights[heights != least - 2].astype(float)) if special else np.nan
