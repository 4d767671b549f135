"""Builds the Python module pointline by CMake, for the Python that runs this."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = Path(__file__).resolve().parent


def version():
    return re.search(r"project\(\S+ VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text())[1]


def pybind11():
    """Where the pybind11 of this Python is; CMake finds that of the system by itself."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


class Build(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        packages = Path(self.get_ext_fullpath(extension.name)).resolve().parent.parent
        options = [
            f"-DPython3_EXECUTABLE={sys.executable}",
            "-DCMAKE_BUILD_TYPE=Release",
            "-DPLC_NO_PYTHON_MODULE=FATAL_ERROR",
            "-DPLC_PYTHON_DIR=.",
            "-DPLC_TESTS=OFF",
            "-DPLC_UNITE=ON",
            *shlex.split(os.environ.get("CMAKE_ARGS", "")),
        ]
        parallel = ["--parallel"]
        if "CMAKE_BUILD_PARALLEL_LEVEL" not in os.environ:
            parallel.append(str(os.cpu_count()))
        for arguments in [
            ["-S", root, "-B", build, *options, *pybind11()],
            ["--build", build, "--target", "pointline_python", *parallel],
            ["--install", build, "--component", "python", "--prefix", packages],
        ]:
            subprocess.run(["cmake", *map(str, arguments)], check=True)


setup(
    version=version(),
    packages=["pointline"],
    package_dir={"": "python"},
    package_data={"pointline": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("pointline._pointline", sources=[])],
    cmdclass={"build_ext": Build},
)
