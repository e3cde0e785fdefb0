"""The families of rigid-foldable patterns: each knows the waist, none knows another."""
