"""Builds the package's modules by CMake, for pip. pyproject.toml says the rest."""

import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version():
    header = (ROOT / "plugin/include/polhode/version.h").read_text(encoding="utf-8")
    return ".".join(
        re.search(rf"POLHODE_VERSION_{part} (\d+)", header).group(1) for part in ("MAJOR", "MINOR", "PATCH")
    )


def pybind11_of_pip():
    """Where pybind11's package has its files for CMake. Debian's are found without."""
    try:
        import pybind11
    except ImportError:
        return {}
    return {"pybind11_DIR": pybind11.get_cmake_dir()}


def cmake(*arguments):
    subprocess.run(["cmake", *arguments], check=True)


class BuildByCMake(build_ext):
    def run(self):
        build = pathlib.Path(self.build_temp).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "BUILD_SHARED_LIBS": "OFF",
            "POLHODE_BUILD_PYTHON": "ON",
            "POLHODE_BUILD_DEMOS": "OFF",
            "POLHODE_BUILD_TESTS": "OFF",
            "POLHODE_PYTHON_INSTALL_DIR": "polhode",
            "Python3_EXECUTABLE": sys.executable,
            **pybind11_of_pip(),
        }
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        package_parent = pathlib.Path(self.build_lib).resolve()
        cmake("-S", ROOT, "-B", build, "-G", "Ninja", *definitions)
        cmake("--build", build, "--target", "polhode_python")
        cmake("--install", build, "--component", "python", "--prefix", package_parent, "--strip")


# The extension is named so that the wheel is one of this platform.
setup(version=version(), ext_modules=[Extension("polhode._core", [])], cmdclass={"build_ext": BuildByCMake})
