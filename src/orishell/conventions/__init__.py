"""What the whole program shares: errors, units, colours, records, tables, texts of numbers."""

__all__: list[str] = []
