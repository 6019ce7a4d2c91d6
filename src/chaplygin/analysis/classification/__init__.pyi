from .classifier import classify as classify
from .facts import ProofBudget as ProofBudget
from .place import Classification as Classification
