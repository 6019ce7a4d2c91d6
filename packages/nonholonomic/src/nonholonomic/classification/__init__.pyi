from .classification import Classification as Classification
from .classifier import classify as classify
