from .notebook import widget as widget
