"""Flat-foldable: quadrilateral meshes that fold with one degree of freedom and close completely.

Derived in docs/theory/flat-foldable.md.
"""
