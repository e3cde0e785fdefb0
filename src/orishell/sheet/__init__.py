"""The flat sheet: its grid of vertices, quads in any order, and panels by their corners."""
