"""The installed program, and `python -m soccersim`."""

import os
import sys

INTERRUPTED = 130


def main() -> None:
    """Load and start the command line; a Ctrl-C before it is loaded is no traceback either."""
    try:
        from soccersim.cli.main import main as start

        start()
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    except SystemExit as stop:
        if stop.code == INTERRUPTED:
            # all is said and written; Python's own exit would wait for the threads of a pool
            # whose processes were ended, and some versions wait for ever
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(INTERRUPTED)
        raise


if __name__ == "__main__":
    main()
