"""The package as it is installed."""

from __future__ import annotations

import importlib.metadata
import pathlib

import wend


def test_the_version_is_that_of_the_library() -> None:
    assert importlib.metadata.version("wend") == wend.__version__


def test_types_are_installed() -> None:
    folder = pathlib.Path(wend.__file__).parent
    assert (folder / "py.typed").exists()
    assert "class Space" in (folder / "_core.pyi").read_text()


def test_everything_public_is_documented() -> None:
    for name in wend.__all__:
        public = getattr(wend, name)
        assert isinstance(public, str) or public.__doc__, name
        for member_name, member in vars(public).items() if isinstance(public, type) else ():
            if not member_name.startswith("_") and (callable(member) or isinstance(member, property)):
                assert member.__doc__, f"{name}.{member_name}"
