"""Flaps that fold flat at the target, and so lock a flat-foldable sheet there.

Derived in docs/theory/flat-foldable.md.
"""
