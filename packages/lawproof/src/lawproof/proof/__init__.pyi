from .certificates.certificate import prove_with_certificate as prove_with_certificate
from .prover import prove as prove, prove_all as prove_all
from .verdict import Verdict as Verdict
