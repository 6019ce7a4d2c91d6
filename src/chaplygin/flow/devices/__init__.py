"""Where many motions are computed: on the processors of a machine, or on a graphics processor."""
