"""The systems that studies follow, each built from its kind of experiment."""
