"""The design tool in the browser: a server on this machine, and what its pages ask for."""

__all__: tuple[str, ...] = ()
