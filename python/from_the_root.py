"""What pip calls in the root of the checkout: the project in this folder."""
import os
import pathlib

# They are called in the root.
os.chdir(pathlib.Path(__file__).resolve().parent)

from setuptools.build_meta import (  # noqa: E402,F401
    build_wheel, get_requires_for_build_wheel, prepare_metadata_for_build_wheel)
