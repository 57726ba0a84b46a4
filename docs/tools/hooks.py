"""What the site needs beyond Markdown: formulas as MathML, and files of the repository that pages link to.

A link out of docs/ works where the repository is read. In the site it leads to the same file: Markdown becomes a page,
any other text a page with its lines. So nothing is written twice.
"""

from __future__ import annotations

import html
import posixpath
import re
import sys
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files, InclusionLevel
from mkdocs.structure.pages import Page

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from screwgen.backends.latex.mathml import inline  # noqa: E402

LINK = re.compile(r"(\]\()([^)\s:#]+)(#[^)\s]*)?(\))")
FENCED = re.compile(r"(^```.*?^```$)", re.DOTALL | re.MULTILINE)
MATH = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)
LEXERS = {".py": "python", ".c": "c", ".h": "c", ".toml": "toml", ".ld": "text"}
BEHIND = "---\nsearch: {boost: 0.2}\n---\n"
"""Head of a page with a file's lines: a search finds the guides before it."""
SITEMAP = "sitemap.xml"
NAVIGATION = ("NOTATION.md", "DESIGN.md", "CONTRIBUTING.md", "firmware/README.md")
"""Pages of the repository that the navigation names."""


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """No sitemap: it needs an address, and its archive holds the time."""
    config.theme.static_templates.discard(SITEMAP)
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add every file of the repository that a page links to, and those that these link to."""
    waiting = [f"docs/{f.src_uri}" for f in files.documentation_pages()] + list(NAVIGATION)
    seen = set(waiting)
    if sitemap := files.get_file_from_path(SITEMAP):
        files.remove(sitemap)
    while waiting:
        path = waiting.pop()
        if not path.startswith("docs/"):
            files.append(brought(path, config))
        if path.endswith(".md"):
            found = set(targets((ROOT / path).read_text(encoding="utf-8"), path)) - seen
            seen |= found
            waiting += sorted(p for p in found if not p.startswith("docs/"))
    return files


def brought(path: str, config: MkDocsConfig) -> File:
    """A file of the repository in the site."""
    source = ROOT / path
    if not source.is_file():
        raise SystemExit(f"docs: a page links to {path}: it is no file of the repository")
    text = source.read_text(encoding="utf-8")
    if not path.endswith(".md"):
        text = f"{BEHIND}# {posixpath.basename(path)}\n\n```{LEXERS.get(source.suffix, 'text')}\n{text}```\n"
    level = InclusionLevel.INCLUDED if path in NAVIGATION else InclusionLevel.NOT_IN_NAV
    return File.generated(config, site_uri(path), content=text, inclusion=level)


def site_uri(path: str) -> str:
    """Where a path of the repository is in the site."""
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    return path if path.endswith(".md") else f"{path}.md"


def targets(text: str, path: str) -> list[str]:
    """The files of the repository that a page at `path` links to."""
    prose = "".join(FENCED.split(text)[::2])
    return [posixpath.normpath(posixpath.join(posixpath.dirname(path), m[2])) for m in LINK.finditer(prose)]


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Links as paths of the repository become links of the site."""
    uri = page.file.src_uri
    path = uri if page.file.generated_by else f"docs/{uri}"
    folder = posixpath.dirname(uri)

    def moved(match: re.Match) -> str:
        target = posixpath.normpath(posixpath.join(posixpath.dirname(path), match[2]))
        return f"{match[1]}{posixpath.relpath(site_uri(target), folder or '.')}{match[3] or ''}{match[4]}"

    parts = FENCED.split(markdown)
    return "".join(part if k % 2 else LINK.sub(moved, part) for k, part in enumerate(parts))


def on_page_content(content: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Formulas become MathML, which browsers set by themselves."""

    def formula(match: re.Match) -> str:
        tex = html.unescape(match[3]).strip()
        if match[2] == "(":
            return inline(tex)
        lines = (inline(line).replace("<math>", '<math displaystyle="true">', 1) for line in tex.splitlines())
        return "".join(f'<div class="formula">{line}</div>' for line in lines)

    return MATH.sub(formula, content)
