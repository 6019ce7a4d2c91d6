"""Devices that integrate many motions: CPUs and a GPU."""
