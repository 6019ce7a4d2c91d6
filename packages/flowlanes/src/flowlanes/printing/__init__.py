"""Text forms of systems and laws: Unicode, LaTeX, HTML, source code."""
