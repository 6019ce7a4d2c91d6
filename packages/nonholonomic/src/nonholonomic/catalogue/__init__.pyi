from .catalogue_entry import Entry as Entry, Start as Start
from .systems import (
    CATALOGUE as CATALOGUE,
    entry as entry,
    from_catalogue as from_catalogue,
    known_laws_of as known_laws_of,
)
