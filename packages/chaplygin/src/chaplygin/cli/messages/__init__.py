"""Sentences of commands: on the results of a run, and on mistakes in a command line."""
