from . import (
    proof as proof,
    search as search,
)
from ._version import __version__ as __version__
from .proof.prover import (
    prove as prove,
    prove_all as prove_all,
)
from .proof.verdict import Verdict as Verdict
from .search.finder import find_laws as find_laws
from .search.result import SearchResult as SearchResult
