"""`soccersim list`."""

import json

import click


@click.command("list", short_help="What comes with soccersim.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
def command(as_json: bool) -> None:
    """List the bundled scenarios, strategies, robots, fields, rules and senses, with what they are.

    \b
    soccersim list
    soccersim run NAME           run one of the scenarios
    """
    from soccersim import bundled

    kinds = {kind: bundled.names(kind) for kind in bundled.PLACES}
    about = {kind: {name: first_line(kind, name) for name in kinds[kind]} for kind in kinds}
    if as_json:
        click.echo(json.dumps(about, indent=2))
        return
    from rich.markup import escape
    from rich.table import Table

    from soccersim.cli.tables import Screen

    for kind, entries in about.items():
        title = kind if kind.endswith("s") else f"{kind}s".replace("ys", "ies")
        table = Table(title=title, title_justify="left", box=None)
        table.add_column("name", style="bold cyan", no_wrap=True)
        table.add_column("about")
        for name, text in entries.items():
            table.add_row(escape(name), escape(text))
        if entries:
            Screen().print(table, "")


def first_line(kind: str, name: str) -> str:
    """The first sentence a bundled file says about itself."""
    from soccersim import bundled
    from soccersim.spec.yaml12 import read

    path = bundled.find(kind, name)
    if path.suffix == ".py":
        return path.read_text(encoding="utf-8").split('"""')[1].strip().split("\n")[0].rstrip(".")
    tree = read(path)
    about = tree.value.get("about", "") if isinstance(tree.value, dict) else ""
    return str(about).split(". ")[0].rstrip(".")
