"""Experiment files by kind of subject: the tables of each kind, and their consistency."""
