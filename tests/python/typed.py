#!/usr/bin/python3
"""What pyright --strict says of a user's file, and of the module's own types: it refuses the lines that are marked so, and no
other. Skipped without pyright.

    typed.py FOLDER MODULE     where the file is written, beside a copy of the module of the build
"""
import json
import pathlib
import shutil
import subprocess
import sys

FILE = '''
from pathlib import Path
import numpy as np
import xarray
import asperity as asp

texture: "asp.GenerateOptions" = {"shape": (128, 128), "size": "1mm", "rq": asp.si(4e-7), "length": "60um"}
surface = asp.generate(**texture)
pressed = surface.asp.contact(young=("208GPa", "70GPa"), poisson=0.3, load="20N", add=["grid_errors"])
area: float = pressed.asp.contact.area.value + pressed.asp.contact.area.error
done: bool = pressed.asp.contact.converged.value
side: str = pressed.asp.contact.boundary.value + pressed.asp.contact.load.unit
length: float = surface.asp.acf().asp.acf.length_10_x.value
part: xarray.Dataset = pressed.isel(x=slice(0, 64)).asp.filter(lambda_c="0.1mm", median=["3px", "5px"])
press = asp.contact(radius="50mm", young="208GPa", poisson=0.3, load="5kN")
largest: float = asp.pipe(surface, press, asp.stress(maximum=True)).asp.stress.max_von_mises.value
drawn = asp.pipe(asp.stage.generate(**texture), press).asp.contact.area.value
smooth = asp.contact(smooth=True, shape=(9, 9), size="1mm", radius="1m", young="1GPa", poisson=0.3, load="1N").asp.contact
print(smooth.hertz_pressure.value, smooth.load)
rows: int = len(asp.stats([surface, Path("map.x3p")], compare=True).columns)
many: int = len(asp.contact({"a": surface, "b": surface}, young="1GPa", poisson=0.3, load="1N").columns)
sweep: int = len(asp.contact(surface, young="1GPa", poisson=0.3, sweep="1N:9N:5").columns)
asp.plot(surface, kind="map", range=None).save("map.png")
code: bytes = asp.convert(surface, to="gsf")
heights = asp.dataset(np.zeros((4, 4)), size="1mm", periodic="x").asp.stats()
for one in asp.ensemble(asp.stage.generate(**texture), press, count=3):
    print(one.asp.contact.area)
for map in asp.ensemble(shape=(9, 9), size="1mm", rq="1um", length="99um", count=2):
    print(map.asp.generate.seed)
try:
    asp.stats("map.nc")
except asp.NoFile as error:
    print(error.filename, error.status)
except asp.NotConverged as error:
    print(error.dataset)

asp.contact(surface, raduis="50mm", young="1GPa", poisson=0.3, load="1N")  # refused
surface.asp.contact(raduis="50mm")  # refused
asp.stage.contact(raduis="50mm")  # refused
asp.contact(surface, young="1GPa", poisson=0.3, load=20)  # refused
asp.generate(shape=(9, 9), size="1mm", rq=4e-7, length="99um")  # refused
asp.generate(shape=(9, 9), size="1mm", rq="1um", length="99um", model="gausian")  # refused
asp.generate(shape=(9, 9), size="1mm", rq="1um", length="99um", periodic="yes")  # refused
asp.ensemble(shap=(9, 9), count=2)  # refused
asp.genrate(shape=(9, 9))  # refused
asp.stats(3)  # refused
asp.stats(surface, output=surface)  # refused
wrong: "asp.ContactOptions" = {"raduis": "50mm"}  # refused
print(pressed.asp.contact.aera)  # refused
print(pressed.asp.kontact)  # refused
print(press.pressure)  # refused
words: str = pressed.asp.contact.area.value  # refused
asp.pipe(surface)  # refused
asp.dataset(np.zeros((4, 4)), sise="1mm")  # refused
'''

pyright = shutil.which("pyright")
if not pyright:
    print("SKIPPED: pyright is not on PATH (npm install pyright)")
    sys.exit(77)
folder = pathlib.Path(sys.argv[1])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / "use.py").write_text(FILE)
shutil.copytree(pathlib.Path(sys.argv[2], "asperity"), folder / "asperity")
(folder / "pyrightconfig.json").write_text(json.dumps({
    "typeCheckingMode": "strict", "include": ["use.py", "asperity/*.pyi"], "reportMissingTypeStubs": False,
    "pythonVersion": "3.11"}))
run = subprocess.run([pyright, "--pythonpath", sys.executable, "--outputjson"], cwd=folder, capture_output=True, text=True)
refused, wrong = {}, 0
for one in json.loads(run.stdout)["generalDiagnostics"]:
    line, text = one["range"]["start"]["line"], f"{one.get('rule')}: {one['message'].splitlines()[0]}"
    if pathlib.Path(one["file"]).name == "use.py":
        refused.setdefault(line, []).append(text)
    else:
        print(f"{one['file']}:{line + 1}: {text}")
        wrong = 1
for number, line in enumerate(FILE.split("\n")):
    if line.endswith("# refused") != (number in refused):
        print(f"{number}: {line}", *refused.get(number, ["is not refused"]), sep="\n    ")
        wrong = 1
print(f"{len(refused)} lines of {FILE.count(chr(10))} are refused")
sys.exit(wrong)
