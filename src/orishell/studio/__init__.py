"""The design tool in the browser: a server on this machine, and what its pages ask for."""
