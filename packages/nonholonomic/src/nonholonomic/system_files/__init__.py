"""Systems in files: the tables that describe one, read to a System or Mechanism, and written."""
