"""An experiment: read from its file, made ready as a study, run, kept in files."""
