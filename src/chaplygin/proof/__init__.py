"""Laws stated, proved and searched for."""
