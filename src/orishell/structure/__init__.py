"""Does it stand: a shell of flat facets, its hinges, supports and loads."""
