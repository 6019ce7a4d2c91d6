"""The laboratory in a page: models of pages, the page itself, its server."""
