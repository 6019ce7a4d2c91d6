"""Systems of more than three dimensions with motions in closed form."""
