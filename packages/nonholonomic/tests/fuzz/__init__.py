"""Laws whose truth is known because of how they were made, planted for the prover to judge.

Nothing here asks the prover, and nothing is decided by numbers: a law is true because it was put
together from what vanishes on every part of its level, or false because there is a part of the
level (mostly with a point at hand) on which it does not vanish.

A law holds if it does so at every real point of its level, with admissible parameters and inside
the guards, where its formulas are defined; and the level, with each of its real parts, must be
invariant.  Unspecified functions may be any; a law with one holds if it does so for all of them.
"""
