"""Answers of ``show`` and ``prove``: computed, kept, and shipped for the catalogue."""
