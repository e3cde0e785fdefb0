"""The command line: parse, call, print. No mathematics.

Commands import inside: ``--help`` and ``--version`` wait for no room.
"""
