"""Bodies, surfaces and mechanisms drawn in space and in plan view."""
