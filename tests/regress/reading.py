"""Reads a page of HTML as tests ask for it."""

from html.parser import HTMLParser


class Page(HTMLParser):
    """A page as a reader sees it: elements that are closed in order, their text and attributes."""

    def __init__(self, text):
        super().__init__()
        self.open, self.elements = [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        assert len(dict(attributes)) == len(attributes)
        element = {"tag": tag, "text": "", "in": [e["tag"] for e in self.open], **dict(attributes)}
        self.elements.append(element)
        if tag not in ("meta", "br"):
            self.open.append(element)

    def handle_endtag(self, tag):
        assert self.open.pop()["tag"] == tag

    def handle_data(self, data):
        for element in self.open:
            element["text"] += data

    def all(self, tag, **wanted):
        """The elements of this kind with these attributes."""
        each = (e for e in self.elements if e["tag"] == tag)
        return [e for e in each if all(e.get(k.rstrip("_")) == v for k, v in wanted.items())]

    def rows(self, heading):
        """The rows, as texts of cells, of the table in the section with this heading."""
        at = next(i for i, e in enumerate(self.elements) if e["text"] == heading)
        rows = []
        for element in self.elements[at + 1 :]:
            if element["tag"] == "h2":
                break
            if element["tag"] == "tr":
                rows.append([])
            elif element["tag"] in ("td", "th") and rows:
                rows[-1].append(element["text"])
        return rows

    def box(self, name):
        """What a box of numbers says: the number, and the line under it."""
        at = next(i for i, e in enumerate(self.elements) if e["tag"] == "dt" and e["text"] == name)
        dds = [e["text"] for e in self.elements[at:] if e["tag"] == "dd"]
        return dds[0], dds[1]
