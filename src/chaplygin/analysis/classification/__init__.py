"""The place of a system in the hierarchy of dynamics, from laws that are proven."""
