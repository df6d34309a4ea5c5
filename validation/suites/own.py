"""Our own computation where a project expects another figure: by numpy alone, from the heights of the map."""
from functools import cache, cached_property

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


def neighbours(values):
    """Pairs of arrays of the values at points that touch, by sides or corners."""
    rows, columns = slice(None, -1), slice(1, None)
    for one, other in (((slice(None), rows), (slice(None), columns)), ((rows, slice(None)), (columns, slice(None))),
                       ((rows, rows), (columns, columns)), ((rows, columns), (columns, rows))):
        yield values[one], values[other]


def plateau_of_point(z):
    """The least number of a point of those of one height that touch."""
    number, before = np.arange(z.size).reshape(z.shape), None
    while before is None or (number != before).any():
        before = number.copy()
        for (high, low), (one, other) in zip(neighbours(z), neighbours(number)):
            least = np.where(high == low, np.minimum(one, other), z.size)
            np.minimum(one, least, out=one), np.minimum(other, least, out=other)
    return number


def hills(z, least):
    """The hill of each point: by steepest ascent from plateau to plateau, then pruned as Wolf's pruning is worded:
    the hill of the least local height merges across its highest saddle, and again, until none is below `least`."""
    plateaus = plateau_of_point(z)
    height = dict(zip(plateaus.flat, z.flat))
    pairs = {pair for one, other in neighbours(plateaus) for pair in zip(one.flat, other.flat)}
    pairs |= {(q, p) for p, q in pairs}
    up = {p: p for p in height}
    for p, q in pairs:
        up[p] = max(up[p], q, key=height.get)

    def top(p):
        return p if up[p] == p else top(up[p])

    saddles = {p: {} for p in height if up[p] == p}
    for p, q in pairs:
        if top(p) != top(q):
            known = saddles[top(p)]
            known[top(q)] = max(known.get(top(q), -np.inf), min(height[p], height[q]))
    while len(saddles) > 1:
        local = {hill: height[hill] - max(known.values()) for hill, known in saddles.items()}
        hill = min(local, key=local.get)
        if local[hill] >= least:
            break
        known = saddles.pop(hill)
        up[hill] = across = max(known, key=known.get)  # which is higher
        for other, saddle in known.items():
            del saddles[other][hill]
            if other != across:
                for a, b in ((across, other), (other, across)):
                    saddles[a][b] = max(saddles[a].get(b, -np.inf), saddle)
    return np.array([top(p) for p in plateaus.flat]).reshape(z.shape)


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
        starts = np.sort(np.concatenate((p[p <= 0.6], p[p >= 0.4] - 0.4)))
        falls, tiny = np.interp(starts, p, c) - np.interp(starts + 0.4, p, c), 1e-13 * np.abs(c).max()
        start = starts[falls <= falls.min() + tiny][0]  # the first of those that are equally flat
        q = np.unique(np.concatenate(([start, start + 0.4], p[(p > start) & (p < start + 0.4)])))
        upper, fall = least_squares(q, np.interp(q, p, c))
        lower = upper + fall
        smr1, smr2 = np.interp([-upper - tiny, -lower + tiny], -c, p)
        (c10, c80), (c2, c50) = np.interp([0.1, 0.8], p, c), np.interp([0.025, 0.5], p, c)
        at = np.union1d(p, [smr1, smr2, 0.1, 0.8])
        over = lambda level: trapezoid(np.maximum(np.interp(at, p, c) - level, 0), at)
        under = lambda level: trapezoid(np.maximum(level - np.interp(at, p, c), 0), at)
        peaks, dales = over(upper), under(lower)
        return {"Sk": upper - lower, "Smr1": smr1, "Smr2": smr2,
                "Spk": 2 * peaks / smr1, "Svk": 2 * dales / (1 - smr2) if smr2 < 1 else 0,
                "Spkx": c[0] - upper, "Svkx": lower - c[-1], "Sak1": peaks, "Sak2": dales, "Sxp": c2 - c50,
                "Vmp": over(c10), "Vmc": over(c80) - over(c10),
                "Vvv": under(c80), "Vvc": under(c10) - under(c80)}

    @cache
    def features(self, sign=1, share=0.05):
        """Spd, S5p, Sha, Shv of hills whose local height is a share of Sz, at least; sign = -1: of dales."""
        z, cell = sign * (self.z - self.z.mean()), self.h[0] * self.h[1]
        of_point = hills(z, share * np.ptp(z))
        edge = np.pad(np.zeros(np.subtract(z.shape, 2), bool), 1, constant_values=True)
        peaks, areas, volumes = [], [], []
        for hill in np.unique(of_point):
            own, above = of_point == hill, (of_point == hill) & (z > np.median(z))
            tops, _ = ndimage.label(z == z[own].max(), np.ones((3, 3)))
            if any(not edge[tops == top].any() for top in np.unique(tops[own])[np.unique(tops[own]) > 0]):
                peaks.append(z[own].max())
            if above.any() and not (above & edge).any():
                areas.append(above.sum() * cell), volumes.append(np.sum(z[above] - np.median(z)) * cell)
        return {"Spd": len(peaks) / (~edge).sum() / cell, "S5p": np.mean(np.sort(peaks)[-5:]) if peaks else np.nan,
                "Sha": np.mean(areas or np.nan), "Shv": np.mean(volumes or np.nan)}

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
