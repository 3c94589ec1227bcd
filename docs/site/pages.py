#!/usr/bin/env python3
"""Collects the repository's pages for Sphinx.

usage: pages.py FOLDER

Copies README.md and the other pages, docs/ and its pictures into FOLDER, with the paths of the repository. It
changes these links: to a source file (now to a page that shows the file), to a notebook (now to the page of it), to
the folder of the Python package (now to its reference), to another folder (now to the API reference), and links whose
text is the name of a page (now the page's title).
"""

import os
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANGUAGES = {".hpp": "cpp", ".cpp": "cpp", ".h": "c", ".c": "c", ".def": "cpp", ".cff": "yaml", ".py": "python", ".json": "json"}
LINK = re.compile(r"\[([^\[\]]*)\]\(([^)\s#:]+)(#[^)\s]*)?\)")


class Pages:
    def __init__(self, folder):
        self.folder = folder
        self.written = set()

    def write(self, name, text):
        """Does not touch a file with the same text: Sphinx reads only files that changed."""
        path = self.folder / name
        self.written.add(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text() != text:
            path.write_text(text)

    def copy(self, source, name):
        path = self.folder / name
        self.written.add(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, path)

    def add_page(self, source):
        name = source.relative_to(ROOT)

        def linked(match):
            text, place = match[1], match[3] or ""
            target = (source.parent / match[2]).resolve()
            if not target.is_relative_to(ROOT) or not target.exists():
                return match[0]  # Sphinx complains
            if target == ROOT / "python/wend":
                page = "python_reference/index.rst"
            elif target.is_dir():
                page = "api.md"
            elif target.suffix == ".ipynb":
                page = f"notebooks/{target.stem}.md"
            elif target.suffix == ".md":
                page = target.relative_to(ROOT)
                text = "" if text == match[2] else text  # Sphinx puts the page's title there
            elif target.is_relative_to(ROOT / "docs/images"):
                return match[0]
            else:
                page = self.add_source(target)
            return f"[{text}]({os.path.relpath(page, name.parent)}{place})"

        text = source.read_text()
        if str(name) == "README.md":
            text = text.replace("# wend\n", "# Overview\n", 1)
        self.write(name, LINK.sub(linked, text))

    def add_source(self, source):
        """A page that shows a file."""
        name = source.relative_to(ROOT)
        page = f"source/{name}.md"
        language = LANGUAGES.get(source.suffix, "text")
        self.write(page, f"---\norphan: true\n---\n\n# {name}\n\n````{language}\n{source.read_text()}````\n")
        return page

    def copy_folder(self, source, name):
        for path in source.rglob("*"):
            if path.is_file():
                self.copy(path, pathlib.Path(name) / path.relative_to(source))

    def remove_others(self, kept):
        """Removes pages of earlier runs that no longer exist, but not from the folders `kept`: others write those."""
        for path in self.folder.rglob("*"):
            if path.is_file() and path not in self.written and path.relative_to(self.folder).parts[0] not in kept:
                path.unlink()


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    pages = Pages(pathlib.Path(sys.argv[1]).resolve())
    for source in [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]:
        pages.add_page(source)
    for source in (ROOT / "docs/site").glob("*.md"):
        pages.copy(source, source.name)
    pages.copy_folder(ROOT / "docs/images", "docs/images")
    pages.copy_folder(ROOT / "docs/site/static", "static")
    pages.remove_others(("reference", "pictures", "python_reference", "notebooks"))


if __name__ == "__main__":
    main()
