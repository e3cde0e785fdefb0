"""The page, the picture and the tables on a shell as a structure."""
