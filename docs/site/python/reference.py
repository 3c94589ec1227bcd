#!/usr/bin/env python3
"""Writes the reference of the Python package as pages for Sphinx, from its signatures and docstrings.

usage: reference.py FOLDER    with a Python that has wend

Everything in wend.__all__ and wend.testing.__all__ must be in PAGES. What docstrings name in ``code`` becomes a link.
"""

import ast
import inspect
import pathlib
import re
import sys
import textwrap

import wend
import wend.testing

# file, title, and what is on it; names of wend, or of wend.testing.
PAGES = [
    ("search", "The common interface", ["search", "PlannerBase", "compare", "Comparison"]),
    ("testing", "Testing a planner of your own", ["testing.check_planner", "testing.PlannerFault"]),
    ("map", "Maps", ["Map"]),
    ("space", "Planning", ["FreeSpace", "rectangle", "Explanation", "Way", "DriveExplanation"]),
    ("plan", "Plans, smoothing, following", ["Plan", "LeadOut", "Quality", "Trajectory", "follow", "Drive"]),
    ("explore", "Robots that discover their map", ["explore", "Exploration"]),
    ("trace", "Traces of searches", ["Trace", "Event", "Animation"]),
    ("indexes", "Indexes", ["Index"]),
    ("registry", "What there is", ["planners", "PlannerInfo", "smoothers", "SmootherInfo", "controllers",
                                   "ControllerInfo", "OptionInfo"]),
    ("errors", "Errors", ["Error", "InvalidArgument", "NoPath", "Metrics"]),
]
INTRODUCTION = """
:doc:`../docs/python` is the guide. This reference is made from the docstrings, which ``help(wend.search)`` shows too;
their examples are tests.

Arrays are array[y, x], points are (x, y), and row 0 is y = 0. A ``Pose`` is (x, y) or (x, y, heading), as a tuple, a
list or an array: metres and radians in the frame of the map.

"""
# Names for types that are not public, as signatures show them.
TYPES = {
    "Index2": "Sequence[int]",
    "PathOrNone": "list[tuple[int, int]] | None",
    "Connectivity": "Literal[4, 8]",
    "CornerRule": "Literal['none', 'one', 'both']",
    "Layer": "Literal['search', 'g', 'h', 'f']",
}

CLASSES = {
    node.name: node
    for file in pathlib.Path(wend.__file__).parent.glob("*.py")
    for node in ast.parse(file.read_text()).body
    if isinstance(node, ast.ClassDef)
}


def public(name):
    found = wend
    for part in name.split("."):
        found = getattr(found, part)
    return found


def readable(types):
    types = re.sub(r"\b(npt|np|wend|typing)\.", "", types)
    return re.sub(r"\b\w+\b", lambda word: TYPES.get(word[0], word[0]), types)


def type_text(annotation):
    return readable(annotation if isinstance(annotation, str) else inspect.formatannotation(annotation))


def signature_of(function):
    """With the types as they are written in the source, without self or cls."""
    signature = inspect.signature(function)
    shown = []
    for parameter in signature.parameters.values():
        if parameter.name not in ("self", "cls"):
            types = parameter.annotation
            known = types is not parameter.empty
            shown.append(parameter.replace(annotation=Shown(type_text(types)) if known else parameter.empty))
    returned = signature.return_annotation
    text = str(signature.replace(parameters=shown, return_annotation=signature.empty))
    return text if returned in (signature.empty, "None") else f"{text} -> {type_text(returned)}"


class Shown:
    """A type that is written without quotes."""

    def __init__(self, text):
        self.text = text
        self.__module__ = "builtins"

    def __repr__(self):
        return self.text


def field_comments(cls):
    """The types of the fields of a class, and the strings below them, which Python does not keep."""
    body = CLASSES[cls.__name__].body
    comments = {}
    for field, after in zip(body, [*body[1:], None]):
        if isinstance(field, ast.AnnAssign) and not field.target.id.startswith("_"):
            commented = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
            text = inspect.cleandoc(after.value.value) if commented else ""
            comments[field.target.id] = (readable(ast.unparse(field.annotation)), text)
    for field in getattr(cls, "_fields", ()):  # those that the C++ side lists
        comments.setdefault(field, ("float", getattr(cls, field).__doc__))
    return comments


class Reference:
    def __init__(self):
        self.names = {}  # what ``code`` may refer to, by the words of docstrings
        for _, _, names in PAGES:
            for name in names:
                self.add_names(name)

    def add_names(self, name):
        self.names[name] = self.names[f"wend.{name}"] = f"wend.{name}"
        if inspect.isclass(public(name)):
            for member in vars(public(name)):
                if not member.startswith("_"):
                    self.names[f"{name}.{member}"] = self.names[f"wend.{name}.{member}"] = f"wend.{name}.{member}"

    def text_of(self, docstring, owner=""):
        """With links, and a heading before the example."""
        def linked(match):
            word = match[1]
            plain = word.removesuffix("()")
            target = self.names.get(f"{owner}.{plain}") or self.names.get(plain)
            return match[0] if target is None else f":py:obj:`{word} <{target}>`"

        text = re.sub(r"``([\w.]+(?:\(\))?)``", linked, inspect.cleandoc(docstring or ""))
        return re.sub(r"^>>>", ".. rubric:: Example\n\n>>>", text, count=1, flags=re.MULTILINE)

    def directive(self, kind, name, text, options=()):
        head = "\n".join([f".. py:{kind}:: {name}", *(f"   {option}" for option in options)])
        return head + "\n\n" + textwrap.indent(text, "   ") + "\n\n"

    def member(self, cls_name, name, member):
        if isinstance(member, property):
            types = f":type: {type_text(member.fget.__annotations__['return'])}"
            return self.directive("property", name, self.text_of(member.__doc__, cls_name), [types])
        function = inspect.unwrap(member.__func__ if isinstance(member, classmethod) else member)
        options = [":classmethod:"] if isinstance(member, classmethod) else []
        if getattr(function, "__isabstractmethod__", False):
            options.append(":abstractmethod:")
        head = name + signature_of(function)
        return self.directive("method", head, self.text_of(function.__doc__, cls_name), options)

    def cls(self, name, cls):
        kind = "exception" if issubclass(cls, Exception) else "class"
        made_by_users = ":param" in cls.__doc__
        text = self.text_of(cls.__doc__, name) + "\n\n"
        if issubclass(cls, Exception):
            bases = [base.__name__ for base in cls.__bases__]
            text = "Bases: " + ", ".join(f":py:obj:`{base}`" for base in bases) + "\n\n" + text
        fields = field_comments(cls)
        for field, (types, comment) in fields.items():
            text += self.directive("attribute", field, self.text_of(comment, name), [f":type: {types}"])
        for member_name, member in vars(cls).items():
            described = isinstance(member, (property, classmethod)) or inspect.isfunction(member)
            if described and not member_name.startswith("_") and member_name not in fields:
                text += self.member(name, member_name, member)
        return self.directive(kind, name + (signature_of(cls.__init__) if made_by_users else ""), text)

    def entry(self, name):
        found = public(name)
        if inspect.isclass(found):
            return self.cls(name, found)
        return self.directive("function", name + signature_of(found), self.text_of(found.__doc__))

    def page(self, title, names):
        text = f"{title}\n{'=' * len(title)}\n\n.. py:currentmodule:: wend\n\n.. highlight:: python\n\n"
        return text + "".join(self.entry(name) for name in names)

    def index(self):
        title = "Python reference"
        text = f"{title}\n{'=' * len(title)}\n\n.. py:module:: wend\n\n{INTRODUCTION}"
        for file, page_title, names in PAGES:
            text += f":doc:`{file}`\n"
            for name in names:
                summary = re.match(r".*?[.?!](?=\s|$)", inspect.cleandoc(public(name).__doc__), re.DOTALL)[0]
                summary = self.text_of(" ".join(summary.split()))
                text += f"   :py:obj:`{name} <wend.{name}>`: {summary}\n\n"
        files = "".join(f"   {file}\n" for file, _, _ in PAGES)
        return f"{text}.. toctree::\n   :hidden:\n\n{files}"


def check_complete():
    expected = {name for name in wend.__all__ if name != "__version__"}
    expected |= {f"testing.{name}" for name in wend.testing.__all__}
    described = {name for _, _, names in PAGES for name in names}
    if expected != described:
        sys.exit(f"PAGES of {__file__} must have {sorted(expected ^ described)}, or must not")


def write(path, text):
    """Does not touch a file with the same text: Sphinx reads only files that changed."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    check_complete()
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    reference = Reference()
    write(folder / "index.rst", reference.index())
    for file, title, names in PAGES:
        write(folder / f"{file}.rst", reference.page(title, names))
    for path in folder.iterdir():
        if path.stem not in ["index", *(file for file, _, _ in PAGES)]:
            path.unlink()


if __name__ == "__main__":
    main()
