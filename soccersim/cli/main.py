"""The entry: finds the verb, and tells what went wrong in one line instead of a traceback."""

import os
import signal
import sys
from _thread import interrupt_main
from importlib import import_module
from threading import Timer
from typing import TYPE_CHECKING, Any

import click

from soccersim import __version__
from soccersim.problems import InputError, MachineError, RunError, Stopped, one_line

if TYPE_CHECKING:
    from types import FrameType

VERBS = {  # verb: what it does; its command stands in cli/verb.py
    "list": "What comes with soccersim: scenarios, strategies, robots, fields.",
    "run": "Run a scenario: table, report, plot, frames, video.",
    "reproduce": "Every table of the papers beside ours.",
    "match": "Play a match of two strategies.",
    "regress": "Is the candidate better than the base?",
    "tournament": "Every team against every other: table and ratings.",
    "worker": "Play one shard of a regression, on a machine of its own.",
    "merge": "Put the shards of a regression together.",
    "tune": "Ziegler-Nichols gains from a simulated experiment.",
    "live": "The base station: watch and steer a simulation in a browser.",
    "replay": "Look at a recording again, check it, or hand it on to other tools.",
    "plot": "Plot recordings over time: position, error, wheels, PWM.",
    "bench": "Measure this machine's speed, beside the floor.",
    "new": "Write a strategy to start from, with its test.",
    "schema": "Print the JSON Schema of scenario files, for editors.",
}
BAD_INPUT, MACHINE, INVALID, INTERRUPTED = 2, 3, 4, 130
SOON = 0.05  # s


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

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The verb that comes first; UsageError names the nearest one."""
        if args and args[0] not in VERBS and not args[0].startswith("-"):
            from difflib import get_close_matches

            near = get_close_matches(args[0], VERBS, n=1)
            hint = f"did you mean `{near[0]}`?" if near else f"there are {', '.join(VERBS)}"
            raise click.UsageError(f"no command `{one_line(args[0])}`: {hint}", ctx)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the verb; click would add an empty line to a Ctrl-C."""
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt as error:
            raise Stopped("stopped; nothing was kept: run it again") from error

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the verbs without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(VERBS.items()))


@click.group(
    cls=Verbs,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, prog_name="soccersim")
@click.pass_context
def soccersim(ctx: click.Context) -> None:
    """A 2D robot-soccer simulator that tells the truth about wheels and odometry.

    \b
    soccersim list                     what there is to run
    soccersim run defender             Utama's defender path, beside the paper
    soccersim run defender --help      what else it can do

    With --debug anywhere, an error shows its traceback.
    """
    if ctx.invoked_subcommand is None:
        click.echo(ctx.get_help())


def main() -> None:
    """Run the command line and exit: 0 done, 2 bad input, 3 the machine, 4 an invalid run."""
    arguments = sys.argv[1:]
    debug = "--debug" in arguments
    open_streams()
    listener = Listener()
    try:
        words = [a for a in arguments if a != "--debug"]
        code = soccersim.main(words, "soccersim", standalone_mode=False)
        sys.stdout.flush()
    except BrokenPipeError:  # as `soccersim list | head` leaves it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(0)
    except SystemExit:  # the same, met by click
        sys.exit(0)
    except (Exception, KeyboardInterrupt) as error:
        listener.close()
        if debug:
            raise
        ours = isinstance(error, Stopped | InputError | MachineError | RunError)
        sys.exit(tell(KeyboardInterrupt() if listener.heard and not ours else error))
    sys.exit(code if isinstance(code, int) else 0)


def open_streams() -> None:
    """Let prints work where an output is closed, or its letters lack some of our signs."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        elif hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


class Listener:
    """Hears each Ctrl-C, for libraries in C may swallow it, or make another error of it.

    Where a callback swallows it, as the compiler's do, it is sent again, soon: at once it would be
    swallowed as well.
    """

    def __init__(self) -> None:
        self.heard = False
        self.again: list[Timer] = []
        sys.unraisablehook = self.lost
        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, self.stop)

    def stop(self, number: int, frame: "FrameType | None") -> None:
        """It comes from the terminal."""
        self.heard = True
        signal.default_int_handler(number, frame)

    def lost(self, lost: "sys.UnraisableHookArgs") -> None:
        """An exception that a callback could not raise."""
        if not isinstance(lost.exc_value, KeyboardInterrupt):
            sys.__unraisablehook__(lost)
            return
        self.heard = True
        self.again.append(Timer(SOON, interrupt_main))
        self.again[-1].daemon = True
        self.again[-1].start()

    def close(self) -> None:
        """From now on another Ctrl-C ends it at once."""
        for timer in self.again:
            timer.cancel()
        if signal.getsignal(signal.SIGINT) == self.stop:
            signal.signal(signal.SIGINT, signal.SIG_DFL)


def tell(error: BaseException) -> int:
    """Say what is wrong on standard error; returns the exit code."""
    if isinstance(error, click.ClickException):
        context = getattr(error, "ctx", None)
        path = context.command_path if context else "soccersim"
        click.echo(f"{path}: {error.format_message().rstrip('.')}; see {path} --help", err=True)
        return BAD_INPUT
    if isinstance(error, KeyboardInterrupt | click.Abort):
        click.echo("stopped; nothing was kept: run it again", err=True)
        return INTERRUPTED
    if isinstance(error, MemoryError):
        click.echo("the memory is full: a shorter run or fewer --jobs need less", err=True)
        return MACHINE
    if isinstance(error, OSError):
        place, wrong = error.filename or "the output", error.strerror or error
        click.echo(f"{place} cannot be used: {wrong}", err=True)
        return MACHINE
    click.echo(str(error) or type(error).__name__, err=True)
    if isinstance(error, Stopped):
        return INTERRUPTED
    if isinstance(error, InputError):
        return BAD_INPUT
    if isinstance(error, MachineError):
        return MACHINE
    if not isinstance(error, RunError):
        kind = type(error).__name__
        click.echo(f"{kind}: a fault of soccersim itself; --debug shows where", err=True)
    return INVALID
