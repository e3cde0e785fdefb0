"""Equilibrium, with what holds in one direction only, and modes about it."""
