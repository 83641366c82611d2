"""Who may come in: browsers that show our own page, and, off this computer, know the token.

A page from elsewhere that names this address (its Origin differs), or whose own name was made to
lead here (DNS rebinding: its Host differs), is refused.
"""

import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from ipaddress import ip_address
from urllib.parse import parse_qs, urlsplit

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")


@dataclass(frozen=True)
class Gate:
    """The address we listen at; `token` is empty where only this computer can reach it."""

    host: str
    port: int
    token: str = ""

    @property
    def url(self) -> str:
        """To be opened in a browser."""
        host = self.host if self.host not in ("0.0.0.0", "::") else own_name()
        shown = f"[{host}]" if ":" in host else host
        return f"http://{shown}:{self.port}/" + (f"?token={self.token}" if self.token else "")

    def refusal(self, target: str, headers: Mapping[str, str], origin: str | None) -> str:
        """Why a request may not come in; empty: it may. origin: None where none is told."""
        host = headers.get("Host", "").lower()
        if not self._is_ours(host):
            return f"this is {self.url.partition('?')[0]}; that name leads nowhere here"
        if origin is not None and origin.lower() != f"http://{host}":
            return "this page comes from elsewhere"
        if self.token and not secrets.compare_digest(given(target).encode(), self.token.encode()):
            return "open the address as it was printed, with its token"
        return ""

    def _is_ours(self, host: str) -> bool:
        """Whether a Host names us. With a token any name may: nobody else knows the token."""
        if self.token:
            return bool(host)
        names = {*LOOPBACK, f"[{self.host}]" if ":" in self.host else self.host}
        return host in {f"{name}:{self.port}" for name in names} | (
            names if self.port == 80 else set()
        )


def given(target: str) -> str:
    """The token in a request's target."""
    values = parse_qs(urlsplit(target).query, max_num_fields=8).get("token", [""])
    return values[0]


def is_loopback(host: str) -> bool:
    """Whether only this computer can reach the address."""
    if host == "localhost":
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


def new_token() -> str:
    """Nobody guesses it."""
    return secrets.token_urlsafe(24)


def own_name() -> str:
    """An address of this computer for others, where it listens at all it has; else its name."""
    import socket

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as way:
        try:
            way.connect(("192.0.2.1", 9))  # sends nothing: it asks which way the network lies
        except OSError:
            return socket.gethostname()
        return str(way.getsockname()[0])
