"""Devices on which many motions are computed: processors, and a graphics processor."""
