from .claim import Case as Case, Claim as Claim, Finding as Finding, Remark as Remark
from .collection import claims as claims, remarks as remarks
