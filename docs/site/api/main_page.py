#!/usr/bin/env python3
"""Writes the main page of the API reference: index.md with a table of headers for each module.

usage: main_page.py PAGE HEADER...

A line `@headers MODULE` of index.md becomes the table of the module's headers, each with the first sentence of the
comment below its `#pragma once`. Fails if a module with public headers has no such line, or a line has no headers.
"""

import pathlib
import re
import sys

TEMPLATE = pathlib.Path(__file__).with_name("index.md")


def summary(header):
    comment = re.search(r"#pragma once\n+((?://(?!/).*\n)+)", header.read_text())
    if not comment:
        sys.exit(f"{header}: no comment below #pragma once says what the header is for")
    text = " ".join(line[2:].strip() for line in comment[1].split("\n//\n")[0].splitlines())
    sentence = re.match(r".*?[.?](?= |$)|.*", text)[0]
    return sentence.replace("|", "\\|").replace("<", "\\<")


def table(headers):
    rows = "".join(f"| {header} | {summary(header)} |\n" for header in headers)
    return "| header | content |\n|---|---|\n" + rows


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    modules = {}
    for name in sys.argv[2:]:
        parts = pathlib.Path(name).parts
        modules.setdefault(parts[1] if len(parts) > 2 else "wend", []).append(pathlib.Path(name))
    page = re.sub(r"^@headers (\w+)\n", lambda match: table(modules.pop(match[1])), TEMPLATE.read_text(),
                  flags=re.MULTILINE)
    if modules:
        sys.exit(f"{TEMPLATE.name} has no line for the headers of " + ", ".join(modules))
    pathlib.Path(sys.argv[1]).write_text(page)


if __name__ == "__main__":
    main()
