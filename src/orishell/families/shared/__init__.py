"""What several families use: nothing here is for callers of the package."""

__all__: list[str] = []
