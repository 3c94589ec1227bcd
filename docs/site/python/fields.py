"""Writes a dash between a parameter and its description, where Sphinx puts two hyphens for its smart quotes."""

from docutils import nodes


def write_dashes(app, doctree):
    for field in doctree.findall(nodes.field_body):
        for text in list(field.findall(nodes.Text)):
            if text == " -- ":
                text.parent.replace(text, nodes.Text(" \u2013 "))


def setup(app):
    app.connect("doctree-read", write_dashes)
    return {"parallel_read_safe": True}
