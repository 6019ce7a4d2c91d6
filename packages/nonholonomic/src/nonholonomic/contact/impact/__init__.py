"""Impacts with friction, and the response of a contact to impulses."""
