"""Motions as films, and as animated 3D models."""
