"""A kit: parts, steps and words of the booklet, line drawings, and the card model."""
