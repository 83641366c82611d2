"""`soccersim schema`."""

import json
from typing import Any

import click


@click.command("schema", short_help="JSON Schema of scenario files.")
def command() -> None:
    """Print the JSON Schema of scenario files, so that an editor completes and checks them.

    \b
    soccersim schema > scenario.schema.json

    Then write as the first line of a scenario (for the YAML language server):

    \b
    # yaml-language-server: $schema=scenario.schema.json
    """
    click.echo(json.dumps(schema(), indent=2))


def schema() -> dict[str, Any]:
    """The schema, in which robots, fields, senses and rules may also be named."""
    from soccersim import bundled
    from soccersim.spec.scenario import Scenario

    document = Scenario.model_json_schema()
    document["title"] = "soccersim scenario"
    document["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    for holder, key, kind in (
        (document["properties"], "field", "field"),
        (document["properties"], "senses", "senses"),
        (document["$defs"]["Match"]["properties"], "rules", "rules"),
        (document["$defs"]["Player"]["properties"], "model", "robot"),
    ):
        described = holder[key].pop("description", "")
        named = {"type": "string", "examples": bundled.names(kind)}
        holder[key] = {"description": described, "anyOf": [named, holder[key]]}
    return document
