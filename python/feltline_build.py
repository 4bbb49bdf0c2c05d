"""Builds the wheel and the sdist of the package `feltline` (PEP 517).

A wheel is compiled with CMake, which needs what the library needs (docs/guide/python.md). An sdist
has the sources of the library and of the package. The same sources give the same sdist, byte for
byte, and the same module gives the same wheel.

Settings (`python3 -m build -C NAME=VALUE`):
  build-dir  folder for the files of the build, which is kept, so that the next build is fast
  package    folder with a package that is already built, such as build/release/python/feltline
"""

import base64
import gzip
import hashlib
import io
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# What the sdist contains: enough to build the wheel and to run the tests of the package.
SDIST = ["CMakeLists.txt", "LICENSE", "README.md", "cmake", "pyproject.toml", "python", "src/felt",
         "share/materials", "share/samples/cat.ndjson", "share/studies/analysis.R",
         "share/studies/analysis.py", "tests/checks/layers/rules.txt"]
LEFT_OUT = re.compile(r"_(test|bench)\.cc$|/testing/|/cmake/new/|__pycache__|\.pyc$")
NO_TIME = (1980, 1, 1, 0, 0, 0)  # the earliest time that a zip file can have


def _version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(feltline VERSION ([0-9.]+)", text).group(1)


def _metadata():
    """Returns the metadata of pyproject.toml in the form of packages."""
    readme = (ROOT / "python/README.md").read_text(encoding="utf-8")
    return "\n".join([
        "Metadata-Version: 2.1",
        "Name: feltline",
        f"Version: {_version()}",
        "Summary: Pen samples to strokes of variable width, and files with drawings",
        "License: Apache-2.0",
        "Requires-Python: >=3.9",
        "Requires-Dist: numpy",
        "Provides-Extra: pandas",
        "Requires-Dist: pandas; extra == 'pandas'",
        "Description-Content-Type: text/markdown",
        "", readme])


def _tag():
    """Returns the tag of a wheel for this interpreter on this system."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[^A-Za-z0-9]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def _compile(build_dir):
    """Builds the module in release mode and returns the folder of the package."""
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DFELT_TESTS=OFF", "-DFELT_BENCHMARKS=OFF",
               "-DFELT_PROGRAMS=OFF", "-DFELT_SOLIDS=OFF", "-DFELT_PYTHON=ON", "-DFELT_UNITY_SOURCES=24",
               f"-DPython3_EXECUTABLE={sys.executable}"]
    subprocess.run(["cmake", "-S", ROOT, "-B", build_dir, "-G", "Ninja", *options], check=True)
    jobs = os.environ.get("JOBS", str(os.cpu_count() or 1))
    subprocess.run(["cmake", "--build", build_dir, "--parallel", jobs, "--target",
                    "feltline_python"], check=True)
    subprocess.run(["strip", "--strip-unneeded",
                    *Path(build_dir, "python/feltline").glob("_feltline*.so")], check=True)
    return Path(build_dir, "python/feltline")


class _Wheel:
    """A wheel in progress. Files have no times, so that equal contents give equal bytes."""

    def __init__(self, path):
        self.zip = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED)
        self.record = []

    def add(self, name, data, mode=0o644):
        info = zipfile.ZipInfo(name, NO_TIME)
        info.external_attr = (0o100000 | mode) << 16
        info.compress_type = zipfile.ZIP_DEFLATED
        self.zip.writestr(info, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={digest},{len(data)}")

    def finish(self, name):
        self.record.append(f"{name},,")
        record = ("\n".join(self.record) + "\n").encode()
        self.zip.writestr(zipfile.ZipInfo(name, NO_TIME), record)
        self.zip.close()


def _write_wheel(path, package):
    info = f"feltline-{_version()}.dist-info"
    wheel = _Wheel(path)
    for file in sorted(package.iterdir()):
        if file.suffix in (".py", ".pyi", ".so") or file.name == "py.typed":
            wheel.add(f"feltline/{file.name}", file.read_bytes(),
                      0o755 if file.suffix == ".so" else 0o644)
    wheel.add(f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())
    wheel.add(f"{info}/METADATA", _metadata().encode())
    wheel.add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: feltline_build\n"
              f"Root-Is-Purelib: false\nTag: {_tag()}\n".encode())
    wheel.finish(f"{info}/RECORD")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    name = f"feltline-{_version()}-{_tag()}.whl"
    path = os.path.join(wheel_directory, name)
    if "package" in settings:
        _write_wheel(path, Path(settings["package"]))
    elif "build-dir" in settings:
        _write_wheel(path, _compile(settings["build-dir"]))
    else:
        with tempfile.TemporaryDirectory() as folder:
            _write_wheel(path, _compile(folder))
    return name


def _sdist_files():
    for entry in SDIST:
        path = ROOT / entry
        for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
            relative = file.relative_to(ROOT).as_posix()
            if file.is_file() and not LEFT_OUT.search("/" + relative):
                yield file, relative


def build_sdist(sdist_directory, config_settings=None):
    base = f"feltline-{_version()}"
    memory = io.BytesIO()
    with tarfile.open(fileobj=memory, mode="w", format=tarfile.PAX_FORMAT) as tar:
        def add(name, data, mode):
            info = tarfile.TarInfo(f"{base}/{name}")
            info.size, info.mode = len(data), mode
            tar.addfile(info, io.BytesIO(data))

        add("PKG-INFO", _metadata().encode(), 0o644)
        for file, relative in _sdist_files():
            add(relative, file.read_bytes(), 0o755 if os.access(file, os.X_OK) else 0o644)
    name = f"{base}.tar.gz"
    with open(os.path.join(sdist_directory, name), "wb") as out:
        with gzip.GzipFile("", "wb", fileobj=out, mtime=0) as packed:
            packed.write(memory.getvalue())
    return name
