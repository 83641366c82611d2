"""The entry: finds the verb, and tells what went wrong in one line instead of a traceback."""

import os
import sys
from importlib import import_module

import click

from soccersim import __version__
from soccersim.problems import InputError, MachineError, RunError

VERBS = {  # verb: what it does; its command stands in cli/verb.py
    "list": "What comes with soccersim: scenarios, strategies, robots, fields.",
    "run": "Run a scenario: table, report, plot, frames, video.",
    "bench": "Measure this machine's speed, beside the floor.",
    "schema": "Print the JSON Schema of scenario files, for editors.",
}
BAD_INPUT, MACHINE, INVALID, INTERRUPTED = 2, 3, 4, 130


class Verbs(click.Group):
    """Imports a verb's module only when it is used, so that --help answers at once."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """All verbs, in the order of use."""
        return list(VERBS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of a verb."""
        if cmd_name not in VERBS:
            return None
        command: click.Command = import_module(f"soccersim.cli.{cmd_name}").command
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the verbs without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(VERBS.items()))


@click.group(cls=Verbs, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="soccersim")
def soccersim() -> None:
    """A 2D robot-soccer simulator that tells the truth about wheels and odometry.

    \b
    soccersim list                     what there is to run
    soccersim run defender             Utama's defender path, beside the paper
    soccersim run defender --help      what else it can do

    With --debug anywhere, an error shows its traceback.
    """


def main() -> None:
    """Run the command line and exit: 0 done, 2 bad input, 3 the machine, 4 an invalid run."""
    arguments = sys.argv[1:]
    debug = "--debug" in arguments
    try:
        soccersim.main([a for a in arguments if a != "--debug"], "soccersim", standalone_mode=False)
    except click.exceptions.Exit as stop:
        sys.exit(stop.exit_code)
    except click.ClickException as error:
        error.show()
        sys.exit(BAD_INPUT)
    except (KeyboardInterrupt, click.Abort):
        click.echo("stopped", err=True)
        sys.exit(INTERRUPTED)
    except BrokenPipeError:  # as `soccersim list | head` leaves it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(0)
    except Exception as error:
        if debug:
            raise
        sys.exit(tell(error))


def tell(error: Exception) -> int:
    """Say what is wrong on standard error; returns the exit code."""
    click.echo(str(error) or type(error).__name__, err=True)
    if isinstance(error, InputError):
        return BAD_INPUT
    if isinstance(error, MachineError | MemoryError | OSError):
        return MACHINE
    if not isinstance(error, RunError):
        kind = type(error).__name__
        click.echo(f"{kind}: a fault of soccersim itself; --debug shows where", err=True)
    return INVALID
