"""Does it stand: a shell of flat triangles, its hinges, supports and loads.

Derived in docs/theory/structure.md.
"""
