from .server.notebook import widget as widget
