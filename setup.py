"""Builds tencer/_core with CMake, or takes it from the build folder that TENCER_BUILD names."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parent
OPTIONS = {
    "Python_EXECUTABLE": sys.executable,
    "CMAKE_BUILD_TYPE": "Release",
    "CMAKE_CXX_FLAGS_RELEASE": "-O2 -DNDEBUG",
    "CMAKE_UNITY_BUILD": "ON",
    "TENCER_PYTHON": "ON",
    "TENCER_TESTS": "OFF",
    "TENCER_BENCH": "OFF",
    "TENCER_INSTALL": "OFF",
}


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        build = os.environ.get("TENCER_BUILD")
        if not build:
            build = self.build_temp
            options = [f"-D{name}={value}" for name, value in OPTIONS.items()]
            subprocess.run(["cmake", "-S", SOURCE, "-B", build, "-G", "Ninja", *options], check=True)
            subprocess.run(["cmake", "--build", build, "--target", "tencer_python"], check=True)
        made = list(Path(build, "python", "tencer").glob("_core*.so"))
        if not made:
            raise SystemExit(f"TENCER_BUILD: {build} has no module; build the target tencer_python")
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(made[0]), str(target))


(SOURCE / "build").mkdir(exist_ok=True)  # for what setuptools notes of the package
version = re.search(r"project\(tencer VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())
setup(
    version=version.group(1),
    ext_modules=[Extension("tencer._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
