"""The fields in which laws are proved, and what is known of signs in them."""
