"""Motions by Taylor series: recurrences, steps, events, and heyoka's for 34 digits."""
