#!/usr/bin/env python3
"""Copies headers for Doxygen and turns the comments of this repository into those that Doxygen reads.

usage: comments.py FOLDER HEADER...

- The comment below `#pragma once` describes the file. If it begins with "Name: ", it also describes the class of that
  name, unless the class has a comment of its own.
- A comment behind a member, an enumerator or a constant describes it.
- Lines that are indented by three blanks are code.
- Declarations that are alike in many classes get the same comment: ALIKE.

Line numbers stay the same, so that warnings name the lines of the header. Doxygen 1.9.4 does not warn of enumerators
without a comment: this does, and exits with code 1.
"""

import pathlib
import re
import sys

# A declaration that matches and has no comment gets this one.
ALIKE = [
    (r"bool operator==\(.*\) (const )?= default;", "Compares all members."),
    (r"auto operator<=>\(.*\) = default;", "Compares the members in their order."),
    (r"\bchoice_names\(\w+\) {", "The values and their names, as options and reports spell them."),
    (r"template <class Self, class Field>",
     "Lists the fields that are options, with their names, help and ranges (options.hpp)."),
    (r"\b(\w+)\(const \1&\) = delete;", "Cannot be copied."),
    (r"\w+& operator=\(const \w+&\) = delete;", "Cannot be copied."),
    (r"virtual ~\w+\(\) = default;", "Destroys an object of a derived class."),
]

STRING = re.compile(r'"(?:\\.|[^"\\])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\])+\'')
DECLARES = re.compile(r'\s*(?:(?:typedef )?(?:namespace|class|struct|(enum)|union)\b[^(=]*|extern _ )$')


def split(line):
    """The code and the comment behind it."""
    at = STRING.sub(lambda match: "_" * len(match[0]), line).find("//")
    return (line, "") if at < 0 else (line[:at], line[at:])


class Scopes:
    """The brackets that are open after the code read so far."""

    def __init__(self):
        self.open = []  # "enum"; "members" for a class or namespace; "" for a function and everything else
        self.statement = ""

    def read(self, code):
        if code.startswith("#") or re.match(r" (public|protected|private):", code):
            return
        for letter in STRING.sub("_", code):
            if letter in "{(":
                head = re.sub(r"^\s*template\s*<.*>\s*(?=class|struct)", "", self.statement)
                declares = letter == "{" and DECLARES.match(head)
                self.open.append(("enum" if declares[1] else "members") if declares else "")
            elif letter in "})":
                self.open.pop()
            self.statement = "" if letter in "{};" else self.statement + letter

    def declare(self):
        return all(self.open)

    def in_enum(self):
        return self.open[-1:] == ["enum"]


def file_comment(lines):
    """Where the comment below `#pragma once` begins and ends."""
    begin = lines.index("#pragma once") + 1
    while begin < len(lines) and not lines[begin]:
        begin += 1
    end = begin
    while end < len(lines) and re.match(r"//(?!/)", lines[end]):
        end += 1
    return begin, end


def class_comment(lines, comment):
    """The comment of the class that the file's comment describes."""
    match = comment and re.match(r"/// (\w+)(?:<\w+>)?: (\w)", comment[0])
    if not match:
        return []
    declared = re.compile(rf"(class|struct) (WEND_API )?{match[1]}\b[^;]*$")
    at = next((i for i, line in enumerate(lines) if declared.match(line)), None)
    if at is None:
        return []
    while lines[at - 1].startswith(("template", "  requires")):
        at -= 1
    if lines[at - 1].startswith("///"):
        return []
    first = "/// " + match[2].upper() + comment[0][match.end():]
    return [f"/// @class wend::{match[1]}", first, *comment[1:]]


class Header:
    def __init__(self, path):
        self.path = path
        self.undocumented = []
        self.lines = path.read_text().splitlines()
        begin, end = file_comment(self.lines)
        comment = ["/" + line for line in self.lines[begin:end]]
        of_class = class_comment(self.lines, comment)
        self.lines[begin - 1:end] = ["/// @file", *comment]
        self.lines = [*self.described(), *of_class]

    def described(self):
        """The lines with Doxygen's comments of members and of what is alike."""
        scopes = Scopes()
        column = None  # of the comment behind the line before
        previous = ""
        own_macros = {line.split()[1] for line in self.lines if line.startswith("#undef ")}
        for number, line in enumerate(self.lines, 1):
            code, comment = split(line)
            in_enum = scopes.in_enum()
            declares = scopes.declare()
            scopes.read(code)
            declares = declares and scopes.declare()
            describes = False
            if declares and comment and not comment.startswith(("///", "// NOLINT")):
                goes_on = not code.strip() and column == len(code)
                describes = goes_on or bool(code.strip(" }")) and not code.rstrip().endswith(("{", ":"))
            column = len(code) if describes else None
            has_comment = describes or previous.lstrip().startswith("///")
            if describes:
                line = f"{code}///<{comment[2:]}"
            elif not comment and not previous.lstrip().startswith(("///", "template")):
                alike = next((text for pattern, text in ALIKE if re.search(pattern, code)), None)
                line = f"/** {alike} */ {line}" if alike else line
            if re.match(r"#define (\w+)", line) and re.match(r"#define (\w+)", line)[1] in own_macros:
                line = ""
            self.look_for_enumerators(number, code, in_enum, has_comment)
            previous = line
            yield line

    def look_for_enumerators(self, number, code, in_enum, has_comment):
        inner = re.search(r"\benum\b[^{]*{(.*)}", code)
        if inner or (in_enum and not has_comment and re.match(r"\s*\w", code)):
            name = inner[1] if inner else code
            self.undocumented.append(f"{self.path}:{number}: without a comment: {name.strip(' ,')}")

    def text(self):
        return "".join(re.sub(r"^(\s*///)   ", r"\1       ", line) + "\n" for line in self.lines)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    undocumented = []
    for name in sys.argv[2:]:
        header = Header(pathlib.Path(name))
        undocumented += header.undocumented
        copy = pathlib.Path(sys.argv[1]) / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(header.text())
    sys.exit("\n".join(undocumented) or None)


if __name__ == "__main__":
    main()
