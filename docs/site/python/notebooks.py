#!/usr/bin/env python3
"""Runs the notebooks of python/examples and writes them as pages, with what they show.

usage: notebooks.py FOLDER    with a Python that has wend, nbclient and matplotlib

Outputs of cells with the tag "times" are left out, because they depend on the machine.
"""

import asyncio
import base64
import json
import pathlib
import re
import sys

import nbclient
import nbformat

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "python/examples"
# Pictures with two pixels for one of the page; no warning that others on this machine could listen.
KERNEL_ARGUMENTS = ["--InlineBackend.figure_formats={'retina'}", "--IPKernelApp.log_level=ERROR"]
LEFT_OUT = "*Times depend on the machine: run the notebook to see yours.*"


class Page:
    """A notebook as Markdown for Sphinx, and the pictures in it."""

    def __init__(self, name):
        self.name = name
        self.title = name
        self.heading = ""
        self.blocks = []
        self.pictures = {}  # bytes by file name

    def add_text(self, source):
        for heading in re.findall(r"^#+ (.*)$", source, re.MULTILINE):
            self.heading = heading.replace("\\", "")
        self.blocks.append(source)

    def add_code(self, source):
        self.blocks.append(f"````python\n{source}\n````")

    def add_output(self, text):
        self.blocks.append(f":::::{{container}} output\n{text}\n:::::")

    def add_picture(self, data, suffix, width=None):
        file = f"{self.name}_{len(self.pictures) + 1}.{suffix}"
        self.pictures[file] = data
        wide = f"\n:width: {width}px" if width else ""
        words = json.dumps(f"Picture {len(self.pictures)}: {self.heading}")  # quoted, as YAML is
        self.add_output(f"```{{image}} {file}\n:alt: {words}{wide}\n```")

    def add(self, output):
        """What Jupyter shows of an output: the best of its formats."""
        if output.output_type == "stream":
            return self.add_output(f"````text\n{output.text.rstrip()}\n````")
        if output.output_type == "error":
            sys.exit(f"{self.name}: {output.ename}: {output.evalue}")
        data = output.data
        if "text/html" in data:
            return self.add_output(f"````{{raw}} html\n{data['text/html']}\n````")
        if "text/markdown" in data:
            return self.add_output(data["text/markdown"])
        if "image/svg+xml" in data:
            return self.add_picture(data["image/svg+xml"].encode(), "svg")
        if "image/png" in data:
            size = output.metadata.get("image/png", {})
            return self.add_picture(base64.b64decode(data["image/png"]), "png", size.get("width"))
        return self.add_output(f"````text\n{data['text/plain']}\n````")

    def add_cell(self, cell):
        if cell.cell_type == "markdown":
            return self.add_text(cell.source)
        self.add_code(cell.source)
        if "times" in cell.metadata.get("tags", []):
            return self.add_output(LEFT_OUT)
        for output in cell.outputs:
            self.add(output)

    def text(self):
        title, *rest = self.blocks
        note = f"{{download}}`{self.name}.ipynb`; see [Python](../docs/python.md#notebooks)."
        return "\n\n".join([title, *rest, "---", f"This page is a notebook: {note}"]) + "\n"


async def executed(file):
    notebook = nbformat.read(file, as_version=4)
    client = nbclient.NotebookClient(
        notebook,
        timeout=120,
        extra_arguments=KERNEL_ARGUMENTS,
        resources={"metadata": {"path": str(EXAMPLES)}},
    )
    await client.async_execute()
    return notebook


def page_of(file, notebook):
    page = Page(file.stem)
    for cell in notebook.cells:
        page.add_cell(cell)
    return page


def write(path, data):
    """Does not touch a file with the same content: Sphinx reads only files that changed."""
    if not path.exists() or path.read_bytes() != data:
        path.write_bytes(data)


async def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    files = sorted(EXAMPLES.glob("*.ipynb"))
    notebooks = await asyncio.gather(*map(executed, files))
    kept = set()
    for file, notebook in zip(files, notebooks):
        page = page_of(file, notebook)
        written = {f"{file.stem}.md": page.text().encode(), file.name: file.read_bytes(), **page.pictures}
        for name, data in written.items():
            write(folder / name, data)
        kept.update(written)
    for path in folder.iterdir():
        if path.name not in kept:
            path.unlink()


if __name__ == "__main__":
    asyncio.run(main())
