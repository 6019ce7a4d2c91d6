"""Messages of commands: results of a run, and mistakes on the command line."""
