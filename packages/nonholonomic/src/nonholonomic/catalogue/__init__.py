"""The catalogue: one file per system of Borisov and Mamaev (2008), each described once.

A file ``NAME.toml`` has the equations, or names the module whose ``ENTRIES`` bring them;
:data:`~nonholonomic.CATALOGUE` collects them by name.

Examples
--------
>>> import nonholonomic
>>> [name for name, entry in nonholonomic.CATALOGUE.items() if entry.source.startswith("§5")]
['rubber-body-of-revolution', 'rubber-disk', 'rubber-routh-sphere']
>>> nonholonomic.CATALOGUE["veselova"].title
'Veselova system'
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
