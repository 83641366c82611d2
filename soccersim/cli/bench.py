"""`soccersim bench`."""

import json

import click


@click.command("bench", short_help="Measure this machine's speed.")
@click.option("--seconds", type=click.FloatRange(1, 600), default=60.0, help="Simulated time.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
def command(seconds: float, as_json: bool) -> None:
    """Time the `kickabout` scenario: ten robots with sensors, odometry and control, and a ball.

    \b
    soccersim bench
    soccersim bench --json

    The floor is bare pymunk (a step, one batch read and one batch write, from Python) over the
    same bodies in the same states, timed in the same process, in turns with the simulation.
    """
    from soccersim.bench import measure
    from soccersim.cli.progress import Bar
    from soccersim.cli.run import announce_compiling

    announce_compiling()
    with Bar("measuring") as bar:
        result = measure(seconds, bar)
    if as_json:
        click.echo(json.dumps(result))
        return
    from soccersim.cli.tables import Screen, new_table

    table = new_table("kickabout on this machine, one core", "")
    table.add_column("", justify="right")
    for key, (title, unit) in ROWS.items():
        table.add_row(title, f"{result[key]:.4g} {unit}".strip())
    Screen().print(table)


ROWS = {
    "robots": ("robots", ""),
    "contacts": ("contacts a tick", ""),
    "tick_us": ("a tick of the simulation", "us"),
    "floor_us": ("a tick of bare pymunk", "us"),
    "tick_over_floor": ("simulation over bare pymunk", ""),
    "realtime_factor": ("times real time, at 500 Hz", ""),
    "tick_us_22": ("a tick with 22 robots", "us"),
    "growth_10_to_22": ("22 robots over 10 robots", ""),
    "frames_per_second": ("frames drawn a second, unencoded", ""),
    "memory_mb": ("memory resident", "MB"),
}
