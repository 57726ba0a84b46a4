"""A small document: headings, paragraphs, tables and figures, written as Markdown and as HTML."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

STYLE = """
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #1a202c }
body { max-width: 62em; margin: 2em auto; padding: 0 1em }
h1, h2 { line-height: 1.2 } h2 { margin-top: 2em; border-bottom: 1px solid #e2e8f0; padding-bottom: .2em }
table { border-collapse: collapse; font-size: .85em; margin: 1em 0 }
th, td { border-bottom: 1px solid #e2e8f0; padding: .35em .7em; text-align: left; vertical-align: top }
th { border-bottom: 2px solid #a0aec0 } td.n, th.n { text-align: right; white-space: nowrap }
figure { margin: 1.5em 0 } figure img { max-width: 100% } figcaption { font-size: .85em; color: #4a5568 }
code { background: #edf2f7; padding: 0 .2em }
"""
NUMBER = re.compile(r"[-+−]?[\d.]+([·×e][\d^+−-]+)?( (%|s|ms|mm|Hz|/s|µs))?|–|none|")
MARK = re.compile(r"(`|(?<!\w)\*{1,2})(?=\S)(.+?)(?<=\S)\1(?!\*)")
TAGS = {"`": "code", "**": "b", "*": "i"}


@dataclass
class Document:
    """What is written, in order."""

    title: str
    blocks: list[tuple] = field(default_factory=list)

    def heading(self, text: str) -> None:
        self.blocks.append(("heading", text))

    def text(self, *sentences: str) -> None:
        """A paragraph; **bold**, *emphasis* and `code` may mark words."""
        self.blocks.append(("text", " ".join(sentences)))

    def table(self, header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        self.blocks.append(("table", header, rows))

    def figure(self, file: str, caption: str) -> None:
        self.blocks.append(("figure", file, caption))

    def markdown(self) -> str:
        return f"# {self.title}\n\n" + "\n".join(MARKDOWN[kind](*rest) for kind, *rest in self.blocks)

    def html(self) -> str:
        body = "\n".join(HTML[kind](*rest) for kind, *rest in self.blocks)
        head = f'<meta charset="utf-8"><title>{html.escape(self.title)}</title><style>{STYLE}</style>'
        title = f"<h1>{html.escape(self.title)}</h1>"
        return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n{title}\n{body}\n</body></html>\n'


def markdown_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    marks = ["---:" if right else "---" for right in alignments(rows)]
    lines = [header, marks, *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def html_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    right = alignments(rows)
    line = lambda cells, tag: "".join(  # noqa: E731
        f"<{tag}{' class=n' if r else ''}>{marked(c)}</{tag}>" for c, r in zip(cells, right, strict=True)
    )
    body = "\n".join(f"<tr>{line(row, 'td')}</tr>" for row in rows)
    return f"<table>\n<tr>{line(header, 'th')}</tr>\n{body}\n</table>"


def alignments(rows: Sequence[Sequence[str]]) -> list[bool]:
    """Per column whether it holds numbers, which stand right."""
    return [all(NUMBER.fullmatch(cell) for cell in column) for column in zip(*rows, strict=True)]


def marked(text: str) -> str:
    """Text with **bold**, *emphasis* and `code` as HTML."""
    return MARK.sub(_tagged, html.escape(text, quote=False))


def _tagged(match: re.Match) -> str:
    tag = TAGS[match[1]]
    inner = match[2] if tag == "code" else MARK.sub(_tagged, match[2])
    return f"<{tag}>{inner}</{tag}>"


def html_figure(file: str, caption: str) -> str:
    return f'<figure><img src="{file}" alt="{html.escape(caption)}"><figcaption>{marked(caption)}</figcaption></figure>'


MARKDOWN = {
    "heading": lambda text: f"## {text}\n",
    "text": lambda text: f"{text}\n",
    "table": markdown_table,
    "figure": lambda file, caption: f"![{caption}]({file})\n\n*{caption}*\n",
}
HTML = {
    "heading": lambda text: f"<h2>{marked(text)}</h2>",
    "text": lambda text: f"<p>{marked(text)}</p>",
    "table": html_table,
    "figure": html_figure,
}
