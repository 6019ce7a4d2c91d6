"""Impacts with friction, and what the motion of a contact answers to impulses."""
