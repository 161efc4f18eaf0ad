"""Builds the wheel (PEP 517): CMake makes the module, and this packs it. Without --config-setting build-dir=FOLDER, which
names a build folder to be used, one is made in build/wheel."""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = Path(__file__).resolve().parent / "plumbline"


def _version():
    return re.search(r"project\(plumbline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def _metadata():
    return (f"Metadata-Version: 2.1\nName: plumbline\nVersion: {_version()}\n"
            "Summary: Straightens NC programs for hexapod machine tools\n"
            "Requires-Python: >=3.9\nRequires-Dist: numpy\n")


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def _module(build):
    """Made by CMake for the interpreter that runs this."""
    settings = [] if build.exists() else ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                                          "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0", "-DPLUMBLINE_TESTS=OFF",
                                          "-DPLUMBLINE_BENCHMARKS=OFF", "-DPLUMBLINE_PYTHON=ON",
                                          f"-DPLUMBLINE_PYTHON_PROGRAM={sys.executable}"]
    if settings:
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *settings], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "plumbline_python", "--parallel",
                    os.environ.get("PLUMBLINE_JOBS", "2")], check=True)
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    module = build / "python/plumbline" / f"_core{suffix}"
    if not module.exists():
        raise SystemExit(f"{build} builds the module for another Python than {sys.executable}, whose ends in {suffix}")
    return module


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = Path((config_settings or {}).get("build-dir", ROOT / "build/wheel"))
    info = f"plumbline-{_version()}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: plumbline\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    files = {f"plumbline/{path.name}": path.read_bytes() for path in sorted(PACKAGE.iterdir()) if path.is_file()}
    module = _module(build)
    files[f"plumbline/{module.name}"] = module.read_bytes()
    files |= {f"{info}/METADATA": _metadata().encode(), f"{info}/WHEEL": wheel.encode(),
              f"{info}/LICENSE": (ROOT / "LICENSE").read_bytes()}
    record = "".join(f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in files.items())
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    name = f"plumbline-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            archive.writestr(zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
    return name


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_sdist(sdist_directory, config_settings=None):
    raise SystemExit("there is no source package for Python: take plumbline's sources, and build the wheel there")
