"""A body in unilateral contact: friction, loss of contact, impact."""
