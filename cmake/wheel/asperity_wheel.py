"""Makes the wheel: what CMake installs, in the folders of a wheel. The interface is that of PEP 517, for pip and others.

    pip install .                                                        compiles, in build-wheel
    pip install . --config-settings=cmake=-DASPERITY_NATIVE=ON           an option for CMake
    pip install . --config-settings=prefix=FOLDER                        compiles nothing: packs an installation

Programs become scripts of the environment, on PATH; libexec and share keep their places beside them, so that programs
find their libraries and pages; the module goes to site-packages. (pip install --target loses a folder lib.) CMake finds
compiler and libraries on this machine (cmake/packages), and such a wheel needs them there; a release puts them into
FOLDER (cmake/wheel/bundle).
"""
import base64
import hashlib
import pathlib
import re
import shutil
import subprocess
import sysconfig
import tempfile
import tomllib
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MODULE = pathlib.PurePath("lib/python3/dist-packages")
WHEEL = "Wheel-Version: 1.0\nGenerator: asperity_wheel\nRoot-Is-Purelib: false\nTag: {}\n"


def get_requires_for_build_wheel(config_settings=None):
    """Programs that PyPI has as packages, where the machine lacks them."""
    needed = () if "prefix" in (config_settings or {}) else ("cmake", "ninja")
    return [program for program in needed if shutil.which(program) is None]


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = pathlib.Path(metadata_directory, f"asperity-{_version()}.dist-info")
    folder.mkdir()
    for name, text in _metadata().items():
        (folder / name).write_text(text)
    return folder.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    for unknown in settings.keys() - {"cmake", "prefix"}:
        raise SystemExit(f"asperity: --config-settings has no {unknown!r}: write cmake=OPTION or prefix=FOLDER")
    with tempfile.TemporaryDirectory() as own:
        if "prefix" not in settings:
            _build(own, settings.get("cmake", []))
        return _pack(pathlib.Path(settings.get("prefix", own)), pathlib.Path(wheel_directory))


def _build(prefix, options):
    options = [options] if isinstance(options, str) else options
    commands = [["--preset", "wheel", "--log-level=WARNING", *options], ["--build", "--preset", "wheel"]]
    for component in ("tools", "runtime", "python"):
        commands.append(["--install", "build-wheel", "--strip", "--prefix", prefix, "--component", component])
    for command in commands:
        if subprocess.run(["cmake", *command], cwd=SOURCE).returncode != 0:
            raise SystemExit(f"asperity: cmake {command[0]} failed, see above; Debian's packages that it needs are in "
                             f"{SOURCE / 'cmake/packages'}; the wheel of a release needs no compiler")


# ---- the project ----


def _version():
    return re.search(r"^  VERSION ([0-9.]+)$", (SOURCE / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


def _tag():
    return "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def _metadata():
    project = tomllib.loads((SOURCE / "pyproject.toml").read_text())["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {_version()}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {needed}" for needed in project["dependencies"]]
    for extra, needs in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {needed}; extra == "{extra}"' for needed in needs)]
    return {"METADATA": "\n".join(lines) + "\n", "WHEEL": WHEEL.format(_tag())}


# ---- the archive ----


def _pack(prefix, folder):
    """Writes the wheel of an installation."""
    if not (prefix / "bin/asperity").is_file() or not (prefix / MODULE / "asperity").is_dir():
        raise SystemExit(f"asperity: prefix={prefix} has no bin/asperity or no {MODULE}/asperity: cmake --install makes both")
    name = f"asperity-{_version()}"
    record = []
    wheel = folder / f"{name}-{_tag()}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        def add(path, content, mode=0o644):
            entry = zipfile.ZipInfo(path)
            entry.external_attr, entry.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{path},sha256={digest},{len(content)}\n")

        for file in _files(prefix):
            add(_place(file.relative_to(prefix), name), file.read_bytes(), file.stat().st_mode & 0o755)
        for file, text in _metadata().items():
            add(f"{name}.dist-info/{file}", text.encode())
        archive.writestr(f"{name}.dist-info/RECORD", "".join(record) + f"{name}.dist-info/RECORD,,\n")
    return wheel.name


def _files(prefix):
    """A wheel has no links: each is the file that it leads to, which is left out."""
    files = sorted(file for file in prefix.rglob("*") if file.is_file())
    targets = {file.resolve() for file in files if file.is_symlink()}
    return [file for file in files if file.is_symlink() or file.resolve() not in targets]


def _place(file, name):
    if file.is_relative_to(MODULE):
        return file.relative_to(MODULE).as_posix()
    if file.parts[0] == "bin":
        return f"{name}.data/scripts/{file.relative_to('bin').as_posix()}"
    return f"{name}.data/data/{file.as_posix()}"
