"""Holds what the .md files name against the tree: links, paths, functions and tests.

    python3 -S CheckDocs.py ROOT      prints each thing named that is not there; exit code 1 if any
    python3 -S CheckDocs.py           the self-test: seeded faults must be found

Checked: relative links with their #headings, and between backticks (outside fenced code)
    `Modules/Kernels/Grid/ParallelFor.h`    a path from the root, from the page, or as it is included;
                                            <Noun>, … and * stand for anything, and must match a file
    `Grid/ParallelFor.h:ParallelThreads`    that word must be in that file
    `ParallelFor.NothingToDoAndFaults`      that test must be in a .cxx or CMakeLists.txt
"""
import os
import pathlib
import re
import sys
import tempfile

TOPS = ("Modules", "Applications", "Testing", "Data", "Utilities", ".ci")
SKIPPED = re.compile(r"\.(?!ci$).*|build.*|demo")  # folders that are no sources
INCLUDED_FROM = (".", "Modules", "Modules/Kernels", "Applications", "Applications/CommandLine")
SUFFIXES = r"h|cxx|glsl|md|txt|py|cmake|in|json|module|png"
FENCE = re.compile(r"^ *(```|~~~).*?^ *\1 *$", re.MULTILINE | re.DOTALL)
INDENTED = re.compile(r"(?<=\n\n)(?: {4,}.*\n+)+")
SPAN = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"!?\[[^\]]*\]\(<?([^)>\s]+)>?(?: +\"[^\"]*\")?\)|^\[[^\]]+\]: *(\S+)", re.MULTILINE)
PATH = re.compile(r"([\w.<>…*+-]+(?:/[\w.<>…*+-]+)*/?)(?::~?([\w:~]+))?")
TEST = re.compile(r"[A-Z]\w+\.[A-Z]\w+")
DEFINED = re.compile(r"\b(?:TYPED_)?TEST\w*\(\s*(\w+)\s*,\s*(\w+)\s*\)|\bNAME\s+(\w+\.\w+)")


def pages_of(root):
    """All .md files of the tree."""
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders if not SKIPPED.fullmatch(f))
        yield from (pathlib.Path(folder, f) for f in sorted(files) if f.endswith(".md"))


def tests_of(root):
    """Names of tests in the sources: Suite.Case, and what add_test is given."""
    names = set()
    for top in TOPS:
        for path in (root / top).rglob("*"):
            if path.suffix == ".cxx" or path.name == "CMakeLists.txt":
                for suite, case, name in DEFINED.findall(path.read_text(encoding="utf-8")):
                    names.add(name or f"{suite}.{case}")
    return names


def slug(heading):
    """The anchor a heading gets: lower case, no punctuation, hyphens for spaces."""
    plain = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r" ", "-", re.sub(r"[^\w\- ]", "", plain))


def anchors_of(text):
    return {slug(line.lstrip("#")) for line in FENCE.sub("", text).splitlines() if re.match("#+ ", line)}


def check_link(root, page, target):
    """Why the link is dead, or nothing."""
    name, _, anchor = target.partition("#")
    file = (page.parent / name).resolve() if name else page.resolve()
    if not file.is_relative_to(root):
        return "leads out of the repository"
    if not file.exists():
        return "is not there"
    if anchor and (file.suffix != ".md" or anchor not in anchors_of(file.read_text(encoding="utf-8"))):
        return "has no such heading"
    return None


def find(root, page, name):
    """Files a path in backticks may mean. Placeholders match anything."""
    pattern = re.sub(r"<[^>]*>|…|\.\.\.", "*", name).rstrip("/")
    folders = [page.parent] + [root / f for f in INCLUDED_FROM]
    return [hit for folder in folders if folder.is_dir() for hit in folder.glob(pattern)]


def looks_like_ours(name):
    top, _, rest = name.partition("/")
    return bool(rest) and (top in TOPS or re.search(rf"\.({SUFFIXES})$", name) is not None)


def check_span(root, page, span, tests):
    """Why what stands between backticks is not there, or nothing."""
    if TEST.fullmatch(span):
        return None if span in tests else "is no test"
    named = PATH.fullmatch(span)
    if not named or not (looks_like_ours(named[1]) or (named[2] and "." in named[1])):
        return None
    hits = find(root, page, named[1])
    if not hits:
        return "is not there"
    words = [w for w in (named[2] or "").split(":") if w]
    for word in words:
        if not any(re.search(rf"\b{re.escape(word)}\b", h.read_text(encoding="utf-8")) for h in hits if h.is_file()):
            return f"has no {word}"
    return None


def check(root):
    """A sentence for each thing named that is not there."""
    wrong = []
    tests = tests_of(root)
    for page in pages_of(root):
        name = page.relative_to(root).as_posix()
        text = INDENTED.sub("", FENCE.sub("", page.read_text(encoding="utf-8")))
        for inline, reference in LINK.findall(SPAN.sub("", text)):
            target = inline or reference
            fault = None if re.match(r"[a-z]+:", target) else check_link(root, page, target)
            if fault:
                wrong.append(f"{name}: the link {target} {fault}")
        for span in SPAN.findall(text):
            fault = check_span(root, page, span, tests)
            if fault:
                wrong.append(f"{name}: `{span}` {fault}")
    return wrong


def self_test():
    """Each seeded fault is found, alone; the clean tree is clean."""
    clean = {
        "Modules/README.md": "# The house\n\n[here](#the-house) [there](../Testing/README.md#labels) "
        "[far](https://example.org/none)\n`Grid/Sum.h` `Grid/Sum.h:Sum` `Modules/Kernels/<Noun>/` "
        "`Kernels/…/Sum.*` `Sum.IsExact` `Sums.OfAnyType` `a/b` `std::sort` `x/none.zip`\n"
        "```\n[none](none.md) `Testing/None.md`\n```\n\n    `Testing/None.md`\n",
        "Testing/README.md": "## Labels\n",
        "Modules/Kernels/Grid/Sum.h": "int Sum(int);",
        "Modules/Kernels/Grid/Testing/TestSum.cxx": "TEST(Sum, IsExact)\nTYPED_TEST(Sums, OfAnyType)",
        "Testing/CMakeLists.txt": "add_test(NAME Docs.AreTrue COMMAND x)",
        "build-x/README.md": "[dead](none.md)",
    }
    seeded = [
        ("[a](none.md)", "none.md is not there"),
        ("![a](none.png)", "none.png is not there"),
        ("[a]: none.md", "none.md is not there"),
        ("[a](README.md#none)", "no such heading"),
        ("[a](../../none.md)", "out of the repository"),
        ("`Modules/Kernels/Grid/None.h`", "is not there"),
        ("`Testing/Labels`", "is not there"),
        ("`Grid/None.h`", "is not there"),
        ("`Modules/<Storey>/None.h`", "is not there"),
        ("`Grid/Sum.h:Difference`", "has no Difference"),
        ("`Sum.IsNot`", "is no test"),
        ("`Docs.AreFalse`", "is no test"),
    ]
    failures = []

    def faults(more):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**clean, "Testing/Seeded.md": more}.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text + "\n", encoding="utf-8")
            return check(pathlib.Path(folder).resolve())

    if faults("`Docs.AreTrue`"):
        failures.append(f"clean tree: {faults('`Docs.AreTrue`')}")
    for text, expected in seeded:
        found = faults(text)
        if len(found) != 1 or expected not in found[0]:
            failures.append(f"{text}: found {found}, expected {expected}")
    print(f"{len(seeded) + 1} cases, {len(failures)} failed")
    return failures


def main():
    wrong = check(pathlib.Path(sys.argv[1]).resolve()) if sys.argv[1:] else self_test()
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return 1 if wrong else 0


sys.exit(main())
