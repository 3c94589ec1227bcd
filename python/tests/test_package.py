"""The package as it is installed."""

from __future__ import annotations

import ast
import graphlib
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


# Types that know each other by nature: a map makes free spaces, which have a map; the same with indexes.
FOR_TYPES_ONLY = {("_map", "_space"), ("_space", "_index")}


def modules_named_in(statements: list[ast.stmt]) -> set[str]:
    """The package's modules that these statements import, also in functions."""
    names = set()
    for node in (node for statement in statements for node in ast.walk(statement)):
        if isinstance(node, ast.ImportFrom) and node.level:
            names |= {node.module} if node.module else {name.name for name in node.names}
        if isinstance(node, ast.Import) and any(name.name == "wend" for name in node.names):
            names.add("__init__")
    return names


def is_for_types(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.If) and ast.unparse(statement.test) == "TYPE_CHECKING"


def test_no_module_imports_itself_through_others() -> None:
    imported, for_types = {}, set()
    for file in pathlib.Path(wend.__file__).parent.glob("*.py"):
        statements = ast.parse(file.read_text(encoding="utf-8")).body
        types = [statement for statement in statements if is_for_types(statement)]
        for_types |= {(file.stem, name) for name in modules_named_in(types)}
        imported[file.stem] = modules_named_in([s for s in statements if not is_for_types(s)])
    assert imported["_space"] >= {"_core", "_map", "_plan", "_trace"}
    tuple(graphlib.TopologicalSorter(imported).static_order())  # raises CycleError
    assert for_types == FOR_TYPES_ONLY
