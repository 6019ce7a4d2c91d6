"""Systems of more than three dimensions whose motion is known in closed form."""
