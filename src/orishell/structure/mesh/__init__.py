"""Panels as triangles and creases as hinges: stiffness, forces and stresses."""
