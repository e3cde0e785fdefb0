"""What the whole program shares: units, colours, how numbers are written, how a run is stopped."""

__all__: list[str] = []
