"""Flat-foldable: quadrilateral meshes that fold with one degree of freedom and close completely.

Not in the paper: the meshes are those of Feng, Dang, James and Plucinsky, J. Mech. Phys. Solids 142
(2020) 104018. Derived in docs/theory/flat-foldable.md.
"""

from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.pattern import FlatFoldablePattern, design_flat_foldable

__all__ = ["FlatFoldable", "FlatFoldablePattern", "design_flat_foldable"]
