"""The links of a page out of its folder: to pages of the repository, to files, to other hosts.

Pages of the repository that lie outside of ``docs`` are brought into the site.  A link to any other
file of the repository becomes its name, for no address of the repository is known here.  Addresses
of other hosts are listed on a page of their own.
"""

from __future__ import annotations

import posixpath
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

ROOT = Path(__file__).parents[1]
OUTSIDE = "repository/"
LINK = re.compile(r"\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
ADDRESS = re.compile(r"https?://[^\s)>\]`'\"|]+")
FENCED = re.compile(r"^(```.*?^```$)", re.MULTILINE | re.DOTALL)
FOLDERS = ("benchmarks", "corpus", "examples", "papers", "proofs")
"""Where pages lie beside ``docs``."""


def outside() -> list[str]:
    """The pages outside of ``docs``, in the order of the navigation, and the figures of papers."""
    found = [page for folder in FOLDERS for page in (ROOT / folder).rglob("*.md")]
    found += (ROOT / "papers").rglob("*.svg")
    return ["README.md", "CHANGELOG.md", *sorted(p.relative_to(ROOT).as_posix() for p in found)]


def place(target: str) -> str | None:
    """Where a page of the repository stands in the site; None for what is no page of it."""
    if target.startswith("docs/decisions/"):
        return None
    if target.startswith("docs/"):
        if not (ROOT / target).exists():
            return None
        return target.removeprefix("docs/") if target.endswith((".md", ".svg", ".png")) else None
    return f"{OUTSIDE}{target}" if target in outside() else None


def source(page: str) -> str:
    """Where in the repository a page of the site comes from."""
    return page.removeprefix(OUTSIDE) if page.startswith(OUTSIDE) else f"docs/{page}"


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """The pages of the site, with those of the repository and the list of links."""
    for page in outside():
        text = (ROOT / page).read_text(encoding="utf-8")
        files.append(File.generated(config, f"{OUTSIDE}{page}", content=text))
    files.append(File.generated(config, "reference/links.md", content=listed(files)))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """The page with links that lead to pages of the site; what leads elsewhere is a name."""
    parts = FENCED.split(markdown)
    for i in range(0, len(parts), 2):
        parts[i] = LINK.sub(lambda found: _link(found, page.file.src_uri), parts[i])
    return "".join(parts)


def _link(found: re.Match[str], page: str) -> str:
    label, address = found.groups()
    path, hash_, anchor = address.partition("#")
    if not path or ":" in path:
        return found[0]
    target = posixpath.normpath(posixpath.join(posixpath.dirname(source(page)), path))
    for form in (target, f"{target}/README.md"):
        if there := place(form):
            way = posixpath.relpath(there, posixpath.dirname(page) or ".")
            return f"[{label}]({way}{hash_}{anchor})"
    if (ROOT / target).exists() and not target.startswith(".."):
        return (
            label if "`" in label or label == target else f"{label} (`{target}` in the repository)"
        )
    return found[0]  # mkdocs says that it leads nowhere


def listed(files: Files) -> str:
    """The page of all addresses of other hosts that pages refer to."""
    found: dict[str, set[str]] = {}
    for file in files.documentation_pages():
        for address in ADDRESS.findall(file.content_string):
            found.setdefault(address.rstrip(".,;:"), set()).add(file.src_uri)
    text = (
        "# Links out of this site\n\nThe pages load nothing from other hosts. These are all "
        "addresses that they name; they are not looked up when the site is built.\n\n"
        "| address | named in |\n|---|---|\n"
    )
    for address, pages in sorted(found.items()):
        named = ", ".join(f"[{page}](../{page})" for page in sorted(pages))
        text += f"| <{address}> | {named} |\n"
    return text
