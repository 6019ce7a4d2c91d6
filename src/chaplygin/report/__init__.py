"""Experiment files, datasets, figures and reports."""
