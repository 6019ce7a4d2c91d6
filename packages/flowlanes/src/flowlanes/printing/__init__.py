"""Systems and laws as a reader meets them: Unicode, LaTeX, HTML, source code."""
