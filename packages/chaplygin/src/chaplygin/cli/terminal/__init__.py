"""Parts shared by all commands: options, output, progress, stores."""
