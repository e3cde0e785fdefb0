"""The families of rigid-foldable patterns: each gives a mechanism, none depends on another."""
