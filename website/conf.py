"""Settings of the site, which Sphinx reads; `make site` builds it."""

from __future__ import annotations

import sys
from pathlib import Path

from chaplygin._version import __version__

HOME = Path(__file__).parent
BUILD = HOME.parent / "build"
sys.path.insert(0, str(HOME))

from program import program_digest  # noqa: E402

project = "chaplygin"
author = "The chaplygin authors"
copyright = f"{author}. MIT licence"
version = release = __version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "numpydoc",
    "sphinx_design",
    "sphinx_copybutton",
    "sphinxcontrib.bibtex",
    "fences",
    "formulas",
    "names",
]
exclude_patterns = [
    "packages/*/src",
    "packages/*/tests",
    "tests",
    "scripts",
    "examples",
    "**/examples",
]
nitpicky = True
suppress_warnings = ["myst.header", "bibtex.missing_field"]

# --- pages --------------------------------------------------------------------------------------

myst_enable_extensions = ["attrs_block", "attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4
bibtex_bibfiles = ["references.bib"]
bibtex_default_style = "unsrt"
copybutton_exclude = ".linenos, .gp, .go"

# --- cells --------------------------------------------------------------------------------------

# What a page computed is kept for as long as the program is the same.
nb_execution_mode = "cache"
nb_execution_cache_path = str(BUILD / "site-cache" / program_digest()[:16])
nb_execution_timeout = 900
nb_execution_show_tb = True
nb_merge_streams = True
nb_ipywidgets_js = {}
nb_mime_priority_overrides = [("html", "text/html", 0)]

# --- reference ----------------------------------------------------------------------------------

# the docstrings name the types, in words
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_xref_param_type = False

# --- look ---------------------------------------------------------------------------------------

html_theme = "pydata_sphinx_theme"
html_title = "chaplygin"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = [("filter.js", {"defer": "defer"})]
html_extra_path = [str(BUILD / "site-files")]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "logo": {"text": "chaplygin"},
    "header_links_before_dropdown": 9,
    "navbar_align": "left",
    "show_prev_next": True,
    "show_toc_level": 2,
    "footer_start": ["copyright"],
    "footer_end": [],
    "pygments_light_style": "a11y-high-contrast-light",
    "pygments_dark_style": "a11y-high-contrast-dark",
}
html_sidebars = {"index": []}
html_context = {"default_mode": "auto"}
