from .certificates.certificate import prove_with_certificate as prove_with_certificate
from .prover import prove as prove
from .verdict import Verdict as Verdict
