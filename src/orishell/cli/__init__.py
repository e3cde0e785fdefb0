"""The command line: parse, call, print.

Commands import inside: ``--help`` and ``--version`` wait for no package.
"""
