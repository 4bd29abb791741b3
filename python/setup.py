"""Builds the module by the project's CMake; see docs/python.md. `pip install --no-build-isolation ./python`."""
import pathlib
import re
import shutil
import subprocess
import sys

import setuptools
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[1]
BUILD = SOURCE / "build/release"


class CMakeBuild(build_ext):
    """The release preset, whose build directory is that of `./dev build`."""

    def build_extension(self, extension):
        # Of a virtual environment the interpreter that it stands on, whose headers are found.
        python = pathlib.Path(sys.base_prefix) / f"bin/python{sys.version_info[0]}.{sys.version_info[1]}"
        subprocess.run(["cmake", "--preset", "release", "-D", "FOURPOST_PYTHON_MODULE=ON", "-D",
                        f"Python_EXECUTABLE={python}"], cwd=SOURCE, check=True)
        subprocess.run(["cmake", "--build", "--preset", "release", "--target", "fourpost_python"], cwd=SOURCE,
                       check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(BUILD / "python/fourpost" / target.name, target)


version = re.search(r"project\(fourpost VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
setuptools.setup(version=version, ext_modules=[setuptools.Extension("fourpost._core", [])],
                 cmdclass={"build_ext": CMakeBuild})
