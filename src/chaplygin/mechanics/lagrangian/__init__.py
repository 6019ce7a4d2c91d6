"""Mechanisms: equations of motion from a Lagrangian in quasi-velocities."""
