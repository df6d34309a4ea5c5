#!/usr/bin/python3
"""Runs the notebooks in a new virtual environment on Debian's packages alone, into which pip has installed tools and module
from the source tree and what its build installs, without a network.

    notebooks.py FOLDER BUILD     where the environment is made and the figures are written; the build
"""
import concurrent.futures
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

HERE, FOLDER, BUILD = pathlib.Path(__file__).resolve().parent, pathlib.Path(sys.argv[1]), sys.argv[2]
ROOT = HERE.parents[1]

for needed in ("matplotlib", "pip", "xarray", "venv"):
    if importlib.util.find_spec(needed) is None:
        print(f"SKIPPED: {needed} is not installed")
        sys.exit(77)


def run(*command, **how):
    return subprocess.run(command, check=True, **how)


def run_notebook(notebook):
    return notebook, subprocess.run([python, "-B", HERE / "run_notebook", notebook, FOLDER], cwd=notebook.parent,
                                    capture_output=True, text=True)


shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
os.environ.pop("PYTHONPATH", None)
run(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", FOLDER / "venv")
python = FOLDER / "venv/bin/python"
run("cmake", "--install", BUILD, "--prefix", FOLDER / "prefix", stdout=subprocess.DEVNULL)
run(sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-index", "--no-deps",
    f"--config-settings=prefix={FOLDER}/prefix", ROOT)
found = run(python, "-c", "import asperity; print(asperity.__file__, asperity.__version__)", capture_output=True, text=True)
assert found.stdout.startswith(str(FOLDER / "venv")), found.stdout
wrong = 0
with concurrent.futures.ThreadPoolExecutor(2) as pool:
    for notebook, outcome in pool.map(run_notebook, sorted((ROOT / "examples/notebooks").glob("*.ipynb"))):
        figures = len(list(FOLDER.glob(f"{notebook.stem}-*.png")))
        print(f"{notebook.name}: exit {outcome.returncode}, {figures} figures")
        if outcome.returncode != 0 or figures < 3:
            print(outcome.stdout, outcome.stderr)
            wrong = 1
sys.exit(wrong)
