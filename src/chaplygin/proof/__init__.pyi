from .certificates.certificate import certified as certified
from .prover import prove as prove
from .verdict import Verdict as Verdict
