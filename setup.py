# SPDX-License-Identifier: GPL-3.0-or-later
# The compiled module by CMake, for pip; pyproject.toml has all else. ROOMATLAS_BUILD names a folder
# to build in, which is kept: a second run then compiles what changed.
import os
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        here = Path(__file__).resolve().parent
        into = Path(self.get_ext_fullpath(extension.name)).resolve()
        build = Path(os.environ.get("ROOMATLAS_BUILD", Path(self.build_temp) / "cmake")).resolve()
        subprocess.run(
            ["cmake", "-S", here, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DROOMATLAS_PYTHON=ON", "-DROOMATLAS_TESTS=OFF", "-DROOMATLAS_BENCH=OFF",
             "-DROOMATLAS_MPI=OFF", f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 2))
        subprocess.run(["cmake", "--build", build, "--target", "roomatlas_python", "-j", jobs],
                       check=True)
        built = list((build / "python" / "package" / "roomatlas").glob("_core*.so"))
        if len(built) != 1:
            sys.exit("CMake built no module: are pybind11-dev and python3-dev installed?")
        into.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built[0]), str(into))
        for plugin in (build / "lib" / "roomatlas").glob("*.so"):  # the module looks beside itself
            self.copy_file(str(plugin), str(into.parent))


setup(ext_modules=[Extension("roomatlas._core", [])], cmdclass={"build_ext": CMakeBuild})
