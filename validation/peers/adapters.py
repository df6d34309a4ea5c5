"""What run gives to each code, and how it is called: functions of gap, load, limit and period that return seconds and
pressures."""
import contextlib
import importlib
import io
import itertools
import os
import pathlib
import resource
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "python"))
os.environ["PATH"] = f"{ROOT / 'build' / 'bin'}:{os.environ['PATH']}"
os.environ["OMP_NUM_THREADS"] = "1"

import numpy as np

import asperity as asp

YOUNG, NU, SIDE = 208e9, 0.3, 3e-3
MODULUS = YOUNG / (1 - NU**2) / 2

number = itertools.count()  # for slippy, whose materials have names of their own


def processor():
    """Seconds of the processor that this process and its children took."""
    return sum(sum(resource.getrusage(who)[:2]) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))


def centres(n):
    x = (np.arange(n) + 0.5 - n / 2) * SIDE / n
    return x[:, None], x[None, :]


def spheres(n):
    """Two of 50 mm radius."""
    x, y = centres(n)
    return (x**2 + y**2) / 50e-3


def rough(n):
    """A surface of 0.4 um rms height and a correlation length of 0.1 mm."""
    drawn = asp.generate(shape=(n, n), size=asp.si(SIDE), rq="0.4um", model="gaussian", length="0.1mm", seed=7)
    return drawn.heights.values


def egg_box(n, share, height=1e-6):
    x, y = centres(n)
    wave = height * np.cos(2 * np.pi * x / SIDE) * np.cos(2 * np.pi * y / SIDE)
    return -wave, share * np.sqrt(2) * np.pi * MODULUS * height * SIDE


def asperity(gap, load, limit, periodic, tight):
    body = asp.dataset(-gap, size=asp.si((SIDE, SIDE)))
    for axis in ("x", "y"):
        body[axis].attrs["periodic"] = np.int32(periodic)
    options = {"load": asp.si(load), "young": asp.si(YOUNG), "poisson": NU, "threads": 1,
               "tolerance": 1e-12 if tight else 1e-6}
    if np.isfinite(limit):
        options["limit_pressure"] = asp.si(limit)
    start = processor()
    pressed = asp.contact(body, **options)
    return processor() - start, pressed.pressure.values


def slippy(gap, load, limit, periodic, tight):
    import slippy as code
    code.CORES = 1
    import slippy.contact as c
    import slippy.surface as s
    start = processor()
    first, second = s.Surface(profile=-gap, grid_spacing=SIDE / len(gap)), s.FlatSurface(shift=(0, 0))
    options = {"use_frequency_domain": periodic}  # its default, True, errs by 2e-3 where nothing repeats
    if np.isfinite(limit):
        options["max_load"] = limit
    for body in (first, second):
        body.material = c.Elastic(f"steel {next(number)}", {"E": YOUNG, "v": NU}, **options)
    model = c.ContactModel("contact", first, second)
    tolerances = {"tolerance": 1e-10, "tolerance_outer": 1e-8} if tight else {}
    model.add_step(c.StaticStep("load", normal_load=load, periodic_axes=(periodic, periodic), **tolerances))
    with contextlib.redirect_stdout(io.StringIO()):
        state = model.solve(skip_data_check=True)
    return processor() - start, np.asarray(state["loads_z"])


def contact_mechanics(gap, load, limit, periodic, tight):
    import ContactMechanics as code
    from SurfaceTopography import PlasticTopography, Topography
    start = processor()
    n = len(gap)
    make = code.PeriodicFFTElasticHalfSpace if periodic else code.FreeFFTElasticHalfSpace
    substrate = make((n, n), MODULUS, (SIDE, SIDE))
    topography = Topography(-gap, (SIDE, SIDE), periodic=periodic)
    if np.isfinite(limit):
        system = code.make_plastic_system(substrate=substrate, surface=PlasticTopography(topography, limit))
    else:
        system = code.make_system(substrate=substrate, surface=topography)
    tolerances = {"pentol": 1e-9 * np.ptp(gap), "forcetol": 1e-9, "maxiter": 10000} if tight else {}
    result = system.minimize_proxy(external_force=load, **tolerances)
    return processor() - start, np.asarray(result.jac)[:n, :n] / (SIDE / n) ** 2


CODES = {"asperity-contact": asperity, "slippy": slippy, "ContactMechanics": contact_mechanics}


def installed():
    """Of the codes that are here: their versions."""
    found = {"asperity-contact": asp.__version__}
    for code in ("slippy", "ContactMechanics"):
        try:
            found[code] = importlib.import_module(code).__version__
        except ImportError as missing:
            print(f"peers: {code} is not run: {missing}", file=sys.stderr)
    return found
