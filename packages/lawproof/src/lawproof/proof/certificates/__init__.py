"""Certificates of verdicts, for a checker that shares no code with the prover."""
