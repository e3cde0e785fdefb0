"""Equation (4): sector angles of one column, those of the next, and which solution is taken."""
