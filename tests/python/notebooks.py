#!/usr/bin/python3
"""Runs the notebooks in a new virtual environment on Debian's packages alone, into which pip has installed the module
from a copy of the source tree, without a network.

    notebooks.py FOLDER     where the environment is made and the figures are written
"""
import concurrent.futures
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

HERE, FOLDER = pathlib.Path(__file__).resolve().parent, pathlib.Path(sys.argv[1])
SOURCE = HERE.parents[1] / "tools/python"

for needed in ("matplotlib", "pip", "setuptools", "wheel", "xarray", "venv"):
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
shutil.copytree(SOURCE, FOLDER / "source", ignore=shutil.ignore_patterns("notebooks", "__pycache__"))
run(sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-index", "--no-build-isolation",
    "--no-deps", FOLDER / "source")
found = run(python, "-c", "import asperity; print(asperity.__file__, asperity.__version__)", capture_output=True, text=True)
assert found.stdout.startswith(str(FOLDER / "venv")), found.stdout
wrong = 0
with concurrent.futures.ThreadPoolExecutor(2) as pool:
    for notebook, outcome in pool.map(run_notebook, sorted((SOURCE / "notebooks").glob("*.ipynb"))):
        figures = len(list(FOLDER.glob(f"{notebook.stem}-*.png")))
        print(f"{notebook.name}: exit {outcome.returncode}, {figures} figures")
        if outcome.returncode != 0 or figures < 3:
            print(outcome.stdout, outcome.stderr)
            wrong = 1
sys.exit(wrong)
