#!/usr/bin/env bash
# pip makes a wheel of the installation, and compiles nothing. The environment is not active, so PATH does not tell of it.
set -euo pipefail
/usr/bin/python3 -c 'import pip, venv, xarray' 2>/dev/null || { echo "SKIPPED: Python's pip, venv or xarray is not installed"; exit 77; }
rm -rf "$1" && mkdir -p "$1/empty"
export PYTHONDONTWRITEBYTECODE=1
/usr/bin/python3 -m venv --system-site-packages --without-pip "$1/venv"
/usr/bin/python3 -m pip --python "$1/venv/bin/python" install --quiet --no-index --no-deps --config-settings=prefix="$prefix" "$source"
env -i PATH=/usr/bin:/bin "$1/venv/bin/python" - "$1/venv" "$version" <<'PYTHON'
import importlib.metadata, sys
import asperity
from asperity import _options
venv, version = sys.argv[1:]
assert importlib.metadata.version("asperity") == version == asperity.__version__
assert asperity.__file__.startswith(venv) and _options.program("stats") == f"{venv}/bin/asperity-stats"
assert "contact" in dir(asperity)
print(asperity.stats(asperity.generate(shape=(64, 64), size="1mm", rq="0.4um", length="60um", seed=7)).loc["Sq"])
PYTHON
cd "$source/cmake/wheel"
refused() {
  /usr/bin/python3 -c "import asperity_wheel; asperity_wheel.build_wheel('$1', {'$2': '$1/empty'})" 2>"$1/said" && exit 1
  diff <(echo "asperity: $3") "$1/said"
}
refused "$1" prefix "prefix=$1/empty has no bin/asperity or no lib/python3/dist-packages/asperity: cmake --install makes both"
refused "$1" folder "--config-settings has no 'folder': write cmake=OPTION or prefix=FOLDER"
