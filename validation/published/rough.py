"""Published contacts of rough bodies. Each function yields rows (quantity, at, published, here, error, doubt), see run."""
import numpy as np

import asperity as asp
from greenwood_tripp import solve
from scenes import MODULUS, SIDE, STEEL, cells, mean, of, pressed, self_affine, slope, surface

PERSSON, BUSH = np.sqrt(8 / np.pi), np.sqrt(2 * np.pi)  # kappa = A/A0 E* Sdq / p at light loads


def area_law():
    """Area and load of self-affine surfaces

    kappa = A/A0 E* Sdq / p at light loads lies between sqrt(8/pi) (B. N. J. Persson, J. Chem. Phys. 115
    (2001) 3840-3861) and sqrt(2 pi) (A. W. Bush, R. D. Gibson, T. R. Thomas, Wear 35 (1975) 87-111), and
    falls with the load (S. Hyun et al., Phys. Rev. E 70 (2004) 026117; V. A. Yastrebov, G. Anciaux, J.-F.
    Molinari, Int. J. Solids Struct. 52 (2015) 83-102). Persson's area at all loads is erf(sqrt(2) p / (E*
    Sdq)). Four surfaces, H = 0.8, waves of 1/4 to 1/32 of the side, 16 cells in the shortest.
    """
    for reduced in (0.005, 0.01, 0.02):
        found = []
        for seed in range(4):
            heights = self_affine(512, 4, 32, 0.8, seed)
            (contact,) = pressed(heights, [reduced * MODULUS * slope(heights) * SIDE**2], add="contact_ratios")
            found.append(contact.contact_area_corrected / SIDE**2 / reduced)
        yield "kappa, Persson to Bush, Gibson and Thomas", reduced, (PERSSON + BUSH) / 2, *mean(found), (BUSH - PERSSON) / 2


def gap_and_stiffness():
    """Mean gap and stiffness

    p ~ exp(-u / (gamma h_rms)) of the mean gap u, so that dp/du = p / (gamma h_rms): gamma = 0.48 by S.
    Akarapu, T. Sharp, M. O. Robbins (Phys. Rev. Lett. 106 (2011) 204301), 0.4 by theory (B. N. J. Persson,
    Phys. Rev. Lett. 99 (2007) 125502), 0.4 to 0.5 in simulations. Four surfaces as before.
    """
    reduced = np.array([0.01, 0.02, 0.04])
    gaps, stiffnesses = [], []
    for seed in range(4):
        heights = self_affine(512, 4, 32, 0.8, seed)
        unit = MODULUS * slope(heights) * SIDE**2
        table = asp.contact(surface(heights, True), sweep=",".join(f"{r * unit!r}N" for r in reduced), **STEEL)
        u, p = np.array(table.mean_gap), np.array(table.load) / SIDE**2
        gaps.append(-np.diff(u) / np.diff(np.log(p)) / heights.std())
        stiffnesses.append(p * SIDE**2 / np.array(table.stiffness) / heights.std())
    for at, found in zip(np.sqrt(reduced[1:] * reduced[:-1]), np.transpose(gaps)):
        yield "gamma, from the gap", at, 0.45, *mean(found), 0.05
    for at, found in zip(reduced, np.transpose(stiffnesses)):
        yield "gamma, from the stiffness", at, 0.45, *mean(found), 0.05


def full_contact():
    """Persson's full contact

    In full contact every wave q of height h carries E* q h / 2, so that the pressure's deviation is E* Sdq
    / 2, whatever the spectrum (B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840-3861).
    """
    for hurst in (0.2, 0.5, 0.8):
        heights = self_affine(256, 4, 32, hurst, 3)
        (contact,) = pressed(heights, [20 * MODULUS * slope(heights) * SIDE**2], add="contact_ratios")
        deviation = float(contact.pressure.std()) / (MODULUS * slope(heights))
        yield "deviation of the pressure / (E* Sdq)", hurst, 0.5, deviation, 1e-8, 0


def rough_sphere_at(alpha, seeds, n=384, a=SIDE / 6, radius=50e-3):
    """Of these surfaces: the effective radius in a0, the pressure at the centre in p0, and (alpha, mu) by their summits."""
    load, peak = 4 * MODULUS * a**3 / (3 * radius), 2 * MODULUS * a / (np.pi * radius)
    near, rows = np.hypot(*cells(n)) < a / 3, []
    for seed in seeds:
        body = asp.generate(shape=(n, n), size=asp.si(SIDE), rq=asp.si(alpha * a**2 / radius), model="gaussian",
                            length="3px", length_level=np.exp(-1), seed=seed)
        summits = asp.stats(body, parameters="hybrid").value
        deviation = summits["summit_deviation"]
        contact = asp.contact(body, radius=asp.si((radius, np.inf)), load=asp.si(load), **STEEL)
        centre = contact.displacement.values[n // 2 - 1 : n // 2 + 1, n // 2 - 1 : n // 2 + 1].mean()
        rows.append((3 * load / (4 * MODULUS * centre) / a,
                     contact.pressure.values[near].mean() / peak / (6 * (1 - (8 / 9) ** 1.5)),
                     deviation * radius / a**2,
                     8 / 3 * summits["summit_density"] * deviation * np.sqrt(2 * radius * summits["summit_radius"])))
    return np.transpose(rows)


def rough_sphere():
    """The rough sphere

    Of alpha = sigma R / a0^2 below 0.05 Hertz's area and pressure err by 7 % at most (J. A. Greenwood, K.
    L. Johnson, E. Matsubara, Wear 100 (1984) 47-57). Above, the theory of J. A. Greenwood and J. H. Tripp
    (J. Appl. Mech. 34 (1967) 153-159), whose summits do not feel each other; its equations are solved for
    the summits that asperity-stats counts (mu = 2 to 6). a* = 3 pi int p r dr / (4 int p dr), here by the
    displacement 3 F / (4 E* a*) of the centre; p(0) over the inner third. Twelve surfaces at each alpha.
    """
    for alpha in (0.02, 0.05, 0.2, 0.5, 1.0):
        radii, pressures, by_summits, mu = rough_sphere_at(alpha, range(1, 13))
        pressure, effective = (1, 1) if alpha <= 0.05 else solve(by_summits.mean(), mu.mean())
        doubt = 0.07 if alpha <= 0.05 else 0
        yield "a* / a0", alpha, effective, *mean(radii), doubt
        yield "p(0) / p0", alpha, pressure, *mean(pressures), doubt


def threshold(body, axis, unit, low=0.1, high=0.4):
    """The area share at which contact percolates along this axis, by halving the load, and the last step of area."""
    areas = []
    for _ in range(6):
        middle = (low + high) / 2
        contact = asp.contact(body, load=asp.si(middle * unit), add="patches", **STEEL)
        low, high = (low, middle) if contact.attrs[f"contact_percolates_{axis}"] else (middle, high)
        areas.append(contact.contact_area_corrected / SIDE**2)
    return areas[-1], abs(areas[-1] - areas[-2])


def percolation():
    """When a seal closes

    Contact percolates, and the last channel of a seal closes, at a share of contact near 0.42 (W. B. Dapp,
    A. Luecke, B. N. J. Persson, M. H. Mueser, Phys. Rev. Lett. 108 (2012) 244301); 0.415 by A. Wang and M.
    H. Mueser (Tribol. Lett. 69 (2021) 1). Six surfaces for each H, waves of 1/4 to 1/32 of the side, along
    x and y.
    """
    for hurst in (0.3, 0.8):
        found, step = [], []
        for seed in range(6):
            heights = self_affine(256, 4, 32, hurst, seed)
            body, unit = surface(heights, True), MODULUS * slope(heights) * SIDE**2
            both = np.transpose([threshold(body, axis, unit) for axis in "xy"])
            found.append(both[0].mean())
            step.append(both[1].mean())
        share, error = mean(found)
        yield "area share where contact percolates", hurst, 0.415, share, error + np.mean(step) / np.sqrt(6), 0.005


def plastic():
    """Bowden and Tabor's area of plastic contact

    Where the limit pressure H is far below E* Sdq, the area is the load over H (F. P. Bowden, D. Tabor, The
    friction and lubrication of solids, 1950); far above, it is that of elastic contact, kappa H / (E* Sdq)
    of it. A referee asks for it since no figure above tests the limit pressure. One surface as before under
    p = 0.02 E* Sdq, on 256 x 256 cells. The correction of the outline presumes pressures that end at zero;
    where cells are at the limit its stated error tells of the doubt, and no area is below F / H.
    """
    heights = self_affine(256, 4, 32, 0.8, 0)
    stiff = MODULUS * slope(heights)
    for ratio in (0.0625, 0.125, 0.25, 8, 16, 32):
        limit = stiff / ratio
        contact = asp.contact(surface(heights, True), load=asp.si(0.02 * stiff * SIDE**2), limit_pressure=asp.si(limit),
                              **STEEL)
        share, error = (number / (0.02 * ratio) for number in of(contact, "area_corrected", SIDE**2))
        if ratio < 1:
            middle, doubt = (BUSH + PERSSON) / 2 / ratio, (BUSH - PERSSON) / 2 / ratio
            yield "A H / F, elastic", ratio, middle, share, error, doubt
        else:
            yield "A H / F, plastic", ratio, 1, share, error, 0
