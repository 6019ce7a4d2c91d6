"""The Chaplygin ball on a plane, its forms, brackets and generalisations."""
