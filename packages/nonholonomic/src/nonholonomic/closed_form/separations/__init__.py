"""Separations of variables, one system a module."""
