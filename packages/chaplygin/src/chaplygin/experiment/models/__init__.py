"""Experiment files by kind of subject: which tables each has and what they mean together."""
