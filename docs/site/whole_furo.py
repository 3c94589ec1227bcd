"""Repairs Debian's Furo, which is built without upstream's webpack.

Its script imports a second script, which browsers refuse for file://: this joins the two. Its styles load
normalize.css from the root of a server: this copies the file. Its dark colours do not follow the system's setting:
this adds the rule.
"""

import pathlib
import re
import shutil

NORMALIZE = "/javascript/normalize.css/normalize.css"


def replaced(pattern, replacement, text):
    text, count = re.subn(pattern, replacement, text, count=1, flags=re.DOTALL)
    if count == 0:
        raise RuntimeError(f"Furo has changed: {pattern} is not there any more")
    return text


def make_whole(app, error):
    if error or app.builder.name != "html":
        return
    static = pathlib.Path(app.outdir) / "_static"
    script = static / "scripts/furo.js"
    other = (static / "scripts/gumshoe-patched.js").read_text()
    script.write_text(other + replaced(r"^import [^\n]*\n", "", script.read_text()))

    styles = static / "styles/furo.css"
    text = replaced(re.escape(f"url({NORMALIZE})"), "url(normalize.css)", styles.read_text())
    dark = re.search(r'@media not print \{(\s*body\[data-theme="dark"\].*?\} \})', text, re.DOTALL)[1]
    dark = dark.replace('body[data-theme="dark"]', 'body:not([data-theme="light"])')
    styles.write_text(f"{text}\n@media (prefers-color-scheme: dark) {{ @media not print {{{dark} }}\n")
    shutil.copy(f"/usr/share{NORMALIZE}", static / "styles/normalize.css")


def setup(app):
    app.connect("build-finished", make_whole)
    return {"parallel_read_safe": True}
