#!/usr/bin/python3
"""make.py OUT: makes the documentation site in the folder OUT, from every Markdown file that git knows, and the
reference of the public headers in OUT/reference. It needs mkdocs, mkdocs-material and doxygen, and no network; the
site can be read and searched from file://.

make.py --check: only checks that every page is in the navigation and that every link has a target; builds nothing.

The pages keep their places in the tree. Links to sources lead to copies that end in .txt, so that browsers show
them; links to public headers lead to the reference; a folder without a README is no link.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
ICON = "share/icons/org.feltline.Feltline.svg"
LEFT_OUT = re.compile(r"\.github/")
SHOWN = {".png", ".svg", ".pdf", ".jpg"}  # what browsers show as it is
# Sections of the navigation: the title, and what its paths begin with. A page is in the first section that fits.
SECTIONS = [
    ("Guide", "docs/guide/"), ("Tools", "src/felt/tools/"), ("Formats", "docs/formats/"),
    ("Devices", "docs/devices/"), ("Design", "docs/design/"), ("Decisions", "docs/decisions/"), ("Reports", "docs/"),
    ("Layers", "src/"), ("Packages", ("apps/", "python/", "web/", "samples/", "packaging/")), ("Project", ""),
]
LINK = re.compile(r"(!?\[(?:[^\]\[]|\[[^\]]*\])*\])\(([^)\s]+)((?:\s+\"[^\"]*\")?)\)")
HEADING = re.compile(r"^(#+)\s+(.*?)\s*#*$")


def files_of_git():
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout
    return sorted(path for path in listed.split("\0") if path and (ROOT / path).is_file())


def slug(text, separator="-"):
    """Returns the anchor of a heading, as GitHub makes it, because the links of the documents are checked there."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", separator)


def outside_code(text):
    """Yields the lines of a Markdown text, and whether each is outside of a block of code."""
    fence = None
    for line in text.split("\n"):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark and fence is None:
            fence = mark[1]
            yield line, False
        elif mark and line.strip() == fence:
            fence = None
            yield line, False
        else:
            yield line, fence is None


def title_of(text, path):
    for line, is_text in outside_code(text):
        heading = HEADING.match(line)
        if is_text and heading:
            return re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading[2])
    return path


def anchors_of(text):
    return {slug(match[2]) for line, is_text in outside_code(text) if is_text and (match := HEADING.match(line))}


def with_lists_of_markdown(text):
    """GitHub lets a list follow a paragraph directly, and indents by the width of the bullet; Python-Markdown needs
    an empty line, and four columns for each level."""
    out, levels, is_after_text = [], [], False
    for line, is_text in outside_code(text):
        indent = len(line) - len(line.lstrip())
        bullet = re.match(r"\s*([*+-]|\d+[.)])\s+", line) if is_text else None
        if line.strip():
            while levels and indent < levels[-1]:
                levels.pop()
        if bullet and (levels or indent < 4):
            if is_after_text and not levels:
                out.append("")
            out.append(" " * 4 * len(levels) + line.strip())
            levels.append(len(bullet[0]))
        elif levels and line.strip():
            out.append(" " * (4 * len(levels) + indent - levels[-1]) + line.strip())
        else:
            out.append(line)
        is_after_text = bool(line.strip()) and is_text and not bullet and not levels
    return "\n".join(out)


class Site:
    def __init__(self):
        self.files = set(files_of_git())
        self.folders = {str(parent) for path in self.files for parent in pathlib.PurePath(path).parents}
        self.pages = {path: (ROOT / path).read_text() for path in sorted(self.files)
                      if path.endswith(".md") and not LEFT_OUT.match(path)}
        self.reference = {}  # public header -> page of the reference
        self.copied = {ICON}
        self.problems = []

    def target(self, page, link):
        """Returns what the link of the page leads to on the site, or None if it is no link there."""
        path, _, anchor = link.partition("#")
        goal = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if goal in self.folders:
            goal = os.path.join(goal, "README.md") if goal != "." else "README.md"
            if goal not in self.pages:
                return None
        if goal in self.pages:
            if anchor and anchor not in anchors_of(self.pages[goal]):
                self.problems.append(f"{page}: there is no heading for {link}")
        elif goal in self.reference:
            goal = "reference/" + self.reference[goal]
        elif goal in self.files:
            self.copied.add(goal)
            if pathlib.PurePath(goal).suffix not in SHOWN:
                goal += ".txt"
        else:
            self.problems.append(f"{page}: {link} leads nowhere")
            return None
        return os.path.relpath(goal, os.path.dirname(page) or ".") + (f"#{anchor}" if anchor else "")

    def rewritten(self, page):
        def change(match):
            words, link, title = match.groups()
            if re.match(r"[a-z]+:", link):
                return match[0]
            goal = self.target(page, link)
            return f"{words}({goal}{title})" if goal else words[1:-1]

        # Links can span lines, so blocks of code are put aside.
        blocks = []

        def put_aside(match):
            blocks.append(match[0])
            return f"\0{len(blocks) - 1}\0"

        text = re.sub(r"^ *(```+|~~~+).*?^ *\1 *$|`[^`\n]+`", put_aside, self.pages[page], flags=re.S | re.M)
        text = LINK.sub(change, text)
        text = re.sub(r"\0(\d+)\0", lambda match: blocks[int(match[1])], text)
        return with_lists_of_markdown(text)

    def navigation(self):
        """Returns the navigation of mkdocs."""
        sections = {title: [] for title, _ in SECTIONS}
        # A README comes first in its folder.
        for _, _, page in sorted((os.path.dirname(path), not path.endswith("README.md"), path) for path in self.pages):
            if page == "README.md":
                continue
            section = next(title for title, start in SECTIONS if page.startswith(start))
            sections[section].append({title_of(self.pages[page], page): page})
        return [{"Feltline": "README.md"}, *({title: pages} for title, pages in sections.items() if pages),
                {"Reference": "reference/index.html"}]

    def stage(self, folder):
        for page in self.pages:
            path = folder / page
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(self.rewritten(page))
        for source in self.copied:
            end = "" if pathlib.PurePath(source).suffix in SHOWN else ".txt"
            (folder / source).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / source, folder / (source + end))


def make_reference(out):
    """Makes the reference with doxygen. Returns the pages of the headers."""
    headers = re.findall(r"^\* \[([^\]]+\.h)\]", (ROOT / "src/felt/API.md").read_text(), re.M)
    settings = (HERE / "Doxyfile").read_text() + "\n".join([
        "INPUT = " + " ".join(f"src/felt/{header}" for header in headers), f"OUTPUT_DIRECTORY = {out}",
        f"STRIP_FROM_PATH = {ROOT}/src", f"STRIP_FROM_INC_PATH = {ROOT}/src", f"GENERATE_TAGFILE = {out}/tags.xml"])
    subprocess.run(["doxygen", "-"], cwd=ROOT, input=settings, text=True, check=True, capture_output=True)
    pages = {}
    for one in xml.etree.ElementTree.parse(out / "tags.xml").iterfind("compound[@kind='file']"):
        path = os.path.normpath(os.path.join("src", one.findtext("path") or "", one.findtext("name")))
        page = one.findtext("filename")
        pages[path] = page if page.endswith(".html") else page + ".html"
    return pages


def build(out):
    work = out.parent / (out.name + ".work")
    for folder in (out, work):
        shutil.rmtree(folder, ignore_errors=True)
    (work / "reference").mkdir(parents=True)
    site = Site()
    site.reference = make_reference(work / "reference")
    site.stage(work / "pages")
    shutil.copytree(work / "reference/html", work / "pages/reference")
    settings = {"docs_dir": str(work / "pages"), "site_dir": str(out), "nav": site.navigation(),
                "hooks": [str(HERE / "make.py")]}
    shutil.copytree(HERE / "theme", work / "theme")
    text = "".join(f"{key}: {json.dumps(value)}\n" for key, value in settings.items())
    (work / "mkdocs.yml").write_text((HERE / "mkdocs.yml").read_text() + text)
    subprocess.run(["mkdocs", "build", "--quiet", "--strict", "-f", work / "mkdocs.yml"], check=True)
    # The search index as a script, because pages from file:// cannot read other files.
    index = out / "search/search_index.json"
    (out / "search/search_index.js").write_text(f"var __search = {{index: Promise.resolve({index.read_text()})}};\n")
    index.unlink()
    for useless in ("sitemap.xml", "sitemap.xml.gz", "404.html"):
        (out / useless).unlink(missing_ok=True)
    shutil.rmtree(work)
    return site.problems


def check():
    site = Site()
    for page in site.pages:
        site.rewritten(page)
    listed = [page for section in site.navigation() for pages in section.values()
              for page in ([pages] if isinstance(pages, str) else [path for row in pages for path in row.values()])]
    for page in site.pages:
        if listed.count(page) != 1:
            site.problems.append(f"{page}: {listed.count(page)} times in the navigation")
    print(f"{len(site.pages)} pages")
    return site.problems


def on_config(config, **_):
    """Called by mkdocs, whose settings name this file as a hook."""
    config["mdx_configs"]["toc"] = {"slugify": slug, "permalink": True}
    return config


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    problems = check() if sys.argv[1] == "--check" else build(pathlib.Path(sys.argv[1]).absolute())
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
