"""Flat-foldable sheets fitted to a piece of surface."""
