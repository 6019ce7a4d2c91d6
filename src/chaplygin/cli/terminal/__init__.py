"""What commands share: options, output and where it goes, progress, stores."""
