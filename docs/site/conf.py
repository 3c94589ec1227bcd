"""Sphinx settings of the site. Its sources are the pages that pages.py collects."""

import pathlib
import sys

project = "wend"
author = "The wend developers"
project_copyright = author

here = pathlib.Path(__file__).parent
sys.path[:0] = [str(here), str(here / "python")]
extensions = ["myst_parser", "whole_furo", "fields"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
root_doc = "index"

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
highlight_language = "none"
default_role = "literal"  # of docstrings
add_module_names = False
smartquotes = False  # or "--start" reads as a dash

html_theme = "furo"
html_title = "wend"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_favicon = "static/wend.svg"
html_logo = "static/wend.svg"
html_copy_source = False
html_show_sphinx = False
html_use_index = False
html_show_search_summary = False  # which would read pages by XMLHttpRequest: refused for file://
option_emphasise_placeholders = False
pygments_style = "friendly"
pygments_dark_style = "native"
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#0b5cad",
        "color-brand-content": "#0b5cad",
        "color-api-name": "#0b5cad",
        "color-api-pre-name": "#0b5cad",
    },
    "dark_css_variables": {
        "color-brand-primary": "#6cb6ff",
        "color-brand-content": "#6cb6ff",
        "color-api-name": "#6cb6ff",
        "color-api-pre-name": "#6cb6ff",
    },
}
