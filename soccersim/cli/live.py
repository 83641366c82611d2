"""`soccersim live`."""

import click

from soccersim.problems import InputError, Problem


@click.command("live", short_help="The base station: watch and steer in a browser.")
@click.argument("scenario", default="training")
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen at.")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8765,
    show_default=True,
    help="0: any free one.",
)
@click.option("--seed", type=click.IntRange(min=0), help="Instead of the scenario's own.")
@click.option("--set", "settings", multiple=True, metavar="KEY.PATH=VALUE", help="Change a value.")
@click.option("--home", help="Strategy of the home team, in a match.")
@click.option("--away", help="Strategy of the away team.")
@click.option("--window", is_flag=True, help="A window instead: drive a robot by keys or gamepad.")
@click.option("--browser", is_flag=True, help="Open it in a browser at once.")
def command(
    scenario: str,
    host: str,
    port: int,
    seed: int | None,
    settings: tuple[str, ...],
    home: str | None,
    away: str | None,
    window: bool,
    browser: bool,
) -> None:
    """Serve a page that shows SCENARIO live and lets you steer it, until Ctrl-C.

    \b
    soccersim live                       four robots and a ball
    soccersim live defender              a paper's run; then send the robot where you like
    soccersim live friendly-match        a match, with a referee's buttons
    soccersim live friendly-match --home human --away chaser --window

    Only this computer can open the page. With another --host others can too, if they know the
    address that is printed, which holds a token. docs/live.md shows what the page can do.
    """
    from soccersim.cli.run import announce_compiling
    from soccersim.live.catalogue import Catalogue

    catalogue = Catalogue(scenario, settings, seed, home, away)
    if window:
        from soccersim.live.window import show_window

        show_window(catalogue, announce_compiling)
        return
    try:
        from soccersim.live.station import bound, serve_station
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] != "websockets":
            raise
        wrong = "the base station needs the package websockets: pip install soccersim[live]"
        raise InputError(Problem(wrong)) from None
    with bound(host, port) as listener:
        announce_compiling()

        def tell(url: str) -> None:
            click.echo(f"soccersim live: open {url} (Ctrl-C ends it)")
            if browser:
                click.launch(url)

        serve_station(catalogue, catalogue.first(), listener, host, tell)
    click.echo("ended", err=True)
