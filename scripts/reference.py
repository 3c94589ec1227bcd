#!/usr/bin/env python3
"""Writes the output of `wend reference`, the program's help as JSON, as pages.

usage: reference.py man|markdown PROGRAM FOLDER

man: FOLDER/wend.1, FOLDER/wend-plan.1, ... markdown: FOLDER/index.md, FOLDER/wend-plan.md, ... for the site.
A subcommand's own subcommands are sections of its page.
"""

import json
import pathlib
import re
import subprocess
import sys

EXIT_CODES = "Exit codes: "


def write(path, text):
    """Does not touch a file with the same text: Sphinx reads only files that changed."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def short_name(command):
    return command["name"].split()[-1]


def page_name(command):
    return command["name"].replace(" ", "-")


def groups(command):
    """Options by their headings in help, in order."""
    found = {}
    for option in command["options"]:
        found.setdefault(option["group"], []).append(option)
    return found


def value_text(argument):
    value = argument["value"] or ""
    if argument["value_optional"]:
        return f"[={value[1:-1]}]"  # "[ALPHA,BETA]"
    return f" {value}" if value else ""


def help_text(argument):
    """The help, and the remarks that --help shows beside the name."""
    text = argument["help"]
    if argument["repeatable"] and "several times" not in text:
        text += "; may be given several times"
    return text + " (required)" if argument["required"] else text


def notes_and_exit_codes(command):
    notes, codes = [], ""
    for note in command["notes"]:
        before, found, after = note.partition(EXIT_CODES)
        if before:
            notes.append(before.strip())
        if found:
            codes = after
    return notes, codes


# ---- Markdown ----


def escaped(text):
    """Plain text as Markdown; `code` stays code, and flags become code."""
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        words = re.split(r"((?<![\w-])(?:-o -(?= )|--?[a-z][\w-]*))", parts[i])
        for j, word in enumerate(words):
            words[j] = f"`{word}`" if j % 2 else re.sub(r"([\\*_\[\]<>{}$|#~^])", r"\\\1", word)
        parts[i] = "".join(words)
    return "".join(parts)


def markdown_help(argument):
    lines = [escaped(line) for line in help_text(argument).split("\n")]
    return lines[0] if len(lines) == 1 else "\n".join(f"- {line}" for line in lines)


def markdown_option(option):
    signature = ", ".join(option["names"]) + value_text(option)
    return f"````{{option}} {signature}\n{markdown_help(option)}\n````\n\n"


def markdown_positional(argument):
    value = argument["value"] if argument["value"] != argument["name"] else ""
    name = argument["name"] + (f" ({value})" if value else "")
    return f"````{{option}} {name}\n{markdown_help(argument)}\n````\n\n"


def markdown_body(command, level):
    """What a page, or a section of one, says about a command below its heading."""
    heading = "#" * level
    text = f"{escaped(command['summary'])}.\n\n```text\n{command['usage']}\n```\n\n"
    text += f"```{{program}} {command['name']}\n```\n\n"
    if command["examples"]:
        text += f"{heading} Examples\n\n```sh\n" + "\n".join(command["examples"]) + "\n```\n\n"
    notes, codes = notes_and_exit_codes(command)
    text += "".join(escaped(note) + "\n\n" for note in notes)
    if command["positionals"]:
        text += f"{heading} Arguments\n\n" + "".join(map(markdown_positional, command["positionals"]))
    for group, options in groups(command).items():
        text += f"{heading} {group}\n\n" + "".join(map(markdown_option, options))
    if codes:
        text += f"{heading} Exit codes\n\n{escaped(codes)}\n\n"
    for each in command["subcommands"]:
        text += f"{'#' * (level - 1)}# {each['name']}\n\n" + markdown_body(each, level + 1)
    return text


def markdown_index(program):
    names = [page_name(each) for each in program["subcommands"]]
    rows = [f"| [wend {short_name(each)}]({page_name(each)}.md) | {escaped(each['summary'])} |"
            for each in program["subcommands"]]
    options = "".join(map(markdown_option, program["options"]))
    return (f"# Commands\n\nEvery subcommand with its arguments and options, as version "
            f"{program['version']} of the program describes them: `wend SUBCOMMAND --help` says the "
            f"same. [The command line](../docs/command_line.md) is the guide.\n\n"
            f"```text\n{program['usage']}\n```\n\n| command | what it does |\n|---|---|\n"
            + "\n".join(rows) + "\n\n```{program} wend\n```\n\n## Options\n\n" + options
            + "## Examples\n\n```sh\n" + "\n".join(program["examples"]) + "\n```\n\n"
            + "```{toctree}\n:hidden:\n\n" + "\n".join(names) + "\n```\n")


def write_markdown(program, folder):
    write(folder / "index.md", markdown_index(program))
    for each in program["subcommands"]:
        write(folder / f"{page_name(each)}.md", f"# {each['name']}\n\n" + markdown_body(each, 2))


# ---- man ----


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("`", "")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.MULTILINE)


def bold(text):
    return f"\\fB{roff(text)}\\fR"


def roff_argument(names, argument):
    text = "\n.br\n".join(map(roff, help_text(argument).split("\n")))
    return f".TP\n{', '.join(map(bold, names))}{roff(value_text(argument))}\n{text}\n"


def roff_heading(kind, title):
    return f'.{kind} "{roff(title.upper() if kind == "SH" else title)}"\n'


def roff_body(command, kind):
    """What a page says about a command, in sections; of a subcommand's subcommand in subsections."""
    text = ""
    if command["positionals"]:
        text += roff_heading(kind, "Arguments")
        text += "".join(roff_argument([each["name"]], {**each, "value": None})
                        for each in command["positionals"])
    for group, options in groups(command).items():
        text += roff_heading(kind, group)
        text += "".join(roff_argument(option["names"], option) for option in options)
    if command["examples"]:
        text += roff_heading(kind, "Examples") + ".nf\n" + "\n".join(map(roff, command["examples"])) + "\n.fi\n"
    return text


def roff_notes(command, kind):
    """Paragraphs, and the section that says what the exit codes mean."""
    notes, codes = notes_and_exit_codes(command)
    paragraphs = "".join(f".PP\n{roff(note)}\n" for note in notes)
    return paragraphs, roff_heading(kind, "Exit status") + roff(codes) + "\n" if codes else ""


def roff_subcommand(command):
    """A subcommand of a subcommand: a section of its page."""
    notes, codes = roff_notes(command, "SS")
    return (roff_heading("SH", command["name"]) + f"{roff(command['summary'])}.\n.PP\n{roff(command['usage'])}\n"
            + notes + roff_body(command, "SS") + codes)


def man_page(command, version, sections, see_also):
    """`sections` come below the description."""
    notes, codes = roff_notes(command, "SH")
    summary = command["summary"].rstrip(".")
    return (f'.TH "{page_name(command).upper()}" 1 "" "wend {version}" "wend"\n'
            f".SH NAME\n{roff(page_name(command))} \\- {roff(summary.removeprefix('wend '))}\n"
            f".SH SYNOPSIS\n{roff(command['usage'])}\n.SH DESCRIPTION\n{roff(summary)}.\n"
            f"{notes}{sections}{codes}.SH SEE ALSO\n{see_also}\n")


def write_man(program, folder):
    listing, see_also = "", []
    for each in program["subcommands"]:
        sections = roff_body(each, "SH") + "".join(map(roff_subcommand, each["subcommands"]))
        page = man_page(each, program["version"], sections, ".BR wend (1)")
        write(folder / f"{page_name(each)}.1", page)
        listing += f".TP\n{bold(short_name(each))}\n{roff(each['summary'])}\n"
        see_also.append(f".BR {roff(page_name(each))} (1)")
    sections = f".SH SUBCOMMANDS\nEach has a page of its own, as wend\\-plan(1).\n{listing}" + roff_body(program, "SH")
    write(folder / "wend.1", man_page(program, program["version"], sections, ",\n".join(see_also)))


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in ("man", "markdown"):
        sys.exit(__doc__)
    program = json.loads(subprocess.run([sys.argv[2], "reference"], check=True, capture_output=True).stdout)
    folder = pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    (write_man if sys.argv[1] == "man" else write_markdown)(program, folder)


if __name__ == "__main__":
    main()
