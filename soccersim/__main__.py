"""The installed program, and `python -m soccersim`."""

import sys


def main() -> None:
    """Load and start the command line; a Ctrl-C before it is loaded is no traceback either."""
    try:
        from soccersim.cli.main import main as start
    except KeyboardInterrupt:
        sys.exit(130)
    start()


if __name__ == "__main__":
    main()
