"""Integration by Taylor series: recurrences, steps, events; with 34 digits through heyoka."""
