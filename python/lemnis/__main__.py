"""The command `lemnis`: the program that lies in this package."""

import os
import subprocess
import sys

from lemnis import program


def main() -> None:
    """Becomes the program; on Windows, where nothing can become another program, waits for it."""
    arguments = [str(program.path()), *sys.argv[1:]]
    if os.name == "nt":
        sys.exit(subprocess.call(arguments))
    os.execv(arguments[0], arguments)


if __name__ == "__main__":
    main()
