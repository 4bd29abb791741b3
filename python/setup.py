"""What pip runs: the Python files, and the module by the project's CMake; see docs/python.md."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import setuptools
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[1]
RELEASE, OWN = SOURCE / "build/release", SOURCE / "build/pip"
scratch = tempfile.TemporaryDirectory()


def is_here(module):
    """Whether a build of this source has the module for this Python."""
    cache = module.parents[2] / "CMakeCache.txt"
    if not module.exists() or not cache.exists():
        return False
    home = re.search("^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)", cache.read_text(), re.M)
    return home is not None and pathlib.Path(home[1]).resolve() == SOURCE


def configure():
    # Of a virtual environment the interpreter that it stands on, whose headers are found.
    python = pathlib.Path(sys.base_prefix) / f"bin/python{sys.version_info[0]}.{sys.version_info[1]}"
    subprocess.run(["cmake", "-G", "Ninja", "-S", SOURCE, "-B", OWN, "-DCMAKE_BUILD_TYPE=Release", "-DFOURPOST_TESTS=OFF",
                    "-DFOURPOST_WERROR=OFF", "-DFOURPOST_PYTHON_MODULE=ON", f"-DPython_EXECUTABLE={python}"], check=True)


def module_of(name):
    """The compiled file: that of FOURPOST_BUILD as it is, else brought up to date in build/release, else in build/pip."""
    inside = f"python/fourpost/{name}"
    if given := os.environ.get("FOURPOST_BUILD"):
        if not (module := SOURCE / given / inside).exists():
            sys.exit(f"FOURPOST_BUILD: there is no {module}: build the target fourpost_python with this Python")
        return module
    folder = RELEASE if is_here(RELEASE / inside) else OWN
    if folder == OWN:
        configure()
    subprocess.run(["cmake", "--build", folder, "--target", "fourpost_python"], check=True)
    return folder / inside


class TakesModule(build_ext):
    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).absolute()
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(module_of(target.name), target)


version = re.search(r"project\(fourpost VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
# Nothing is written beside the source, where files of an earlier version would be taken again.
setuptools.setup(version=version, ext_modules=[setuptools.Extension("fourpost._core", [])],
                 cmdclass={"build_ext": TakesModule},
                 options={"build": {"build_base": scratch.name}, "egg_info": {"egg_base": scratch.name}})
