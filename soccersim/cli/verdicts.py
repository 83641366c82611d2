"""What `soccersim regress` and `merge` give out: the tables or JSON, the files, the exit code."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.campaigns import check_file, file_option

if TYPE_CHECKING:
    from soccersim.regress.account import Account

HTML, XML = (".html", ".htm"), (".xml",)
Command = Callable[..., Any]


def report_options(function: Command) -> Command:
    """--report, --junit, --strict, --json."""
    for option in (
        click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout."),
        click.option("--strict", is_flag=True, help="INCONCLUSIVE ends with exit code 1."),
        file_option("--junit", "Write JUnit XML, for CI."),
        file_option("--report", "Write an HTML page with all the evidence."),
    ):
        function = option(function)
    return function


def check_outputs(report: Path | None, junit: Path | None) -> None:
    """InputError where one of them could not be written."""
    check_file(report, "--report", HTML)
    check_file(junit, "--junit", XML)


def tell(
    account: "Account", report: Path | None, junit: Path | None, strict: bool, as_json: bool
) -> None:
    """Print what it came to, and write the files that were asked for."""
    import json

    from soccersim.cli.results import Results
    from soccersim.cli.verdict_tables import show

    if as_json:
        click.echo(json.dumps(document_of(account), allow_nan=False))
    else:
        show(account)
    if report:
        from soccersim.regress.report import write_report

        page, *replays = write_report(account, report)
        beside = f", and {len(replays)} replays beside it" if replays else ""
        click.echo(f"wrote {page}{beside}", err=True)
    if junit:
        from soccersim.regress.report import junit as junit_of

        files = Results(junit.parent, (junit.name,), force=True)
        with files.new(junit.name) as path:
            path.write_text(junit_of(account, strict), encoding="utf-8")
        click.echo(f"wrote {junit}", err=True)


def document_of(account: "Account") -> dict[str, Any]:
    """The document of --json."""
    from soccersim.cli.verdict_tables import fault_list

    document = account.standing.document()
    counts = document.pop("faults")
    document |= {"faults": fault_list(account), "fault_counts": counts}
    document["results"] = str(account.store)
    document["base"], document["candidate"] = account.base, account.candidate
    document["against"] = list(account.against)
    document["scenario"] = account.scenario
    document["matches"] = {"played": account.played, "found": account.found}
    return document


def exit_code_of(account: "Account", strict: bool) -> int:
    """The verdict for CI."""
    from soccersim.regress.standing import exit_code

    return exit_code(account.standing.verdict, strict) if account.standing.verdict else 0
