"""Holds the planner's language packs, Languages/*.ts, against its sources.

    python3 -S CheckLanguages.py PLANNER [LUPDATE]      prints what is wrong; exit code 1 if anything is
    python3 -S CheckLanguages.py --self-test [LUPDATE]  seeded faults must be found

Of each translation: it is finished, and has the places (%1, %n), the mnemonics (&) and the spaces at both ends
of its source. With LUPDATE, Qt's: what the sources say now is what hasp-planner_*.ts translates, no more and no
less; and lupdate understands all sources, for it loses what it does not understand (a digit separator beside
tr(), tr() of another object).
"""
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

OTHER_FOLDERS = {"Desktop", "Languages", "Testing"}  # what users see is not written there
PLACE = re.compile(r"%L?\d+|%[np]")
NEVER_MORE = ("vanished", "obsolete")

Message = collections.namedtuple("Message", "context source comment state forms")


def messages_of(pack):
    """All that are in use."""
    for context in xml.etree.ElementTree.parse(pack).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            forms = [form.text or "" for form in translation.findall("numerusform")]
            state = translation.get("type", "finished")
            if state not in NEVER_MORE:
                yield Message(context.findtext("name"), message.findtext("source"), message.findtext("comment") or "",
                              state, forms or [translation.text or ""])


def marks_of(text):
    """What a translation must have in common with its source."""
    return {
        "places": sorted(PLACE.findall(text)),
        "mnemonics": text.count("&"),
        "spaces at the ends": (text[:1].isspace(), text[-1:].isspace()),
    }


def check_message(message):
    if message.state != "finished" or not all(message.forms):
        yield "is not translated"
        return
    wanted = marks_of(message.source)
    for form in message.forms:
        for mark, value in marks_of(form).items():
            if value != wanted[mark]:
                yield f"«{form}» has other {mark}"


def update(planner, pack, lupdate):
    """What lupdate makes of the pack, and what it complains of."""
    shutil.copy(planner / "Languages" / pack.name, pack)
    folders = sorted(f.name for f in planner.iterdir() if f.is_dir() and f.name not in OTHER_FOLDERS)
    run = subprocess.run([lupdate, "-silent", "-no-obsolete", "-I", ".", "-extensions", "cxx,h", *folders, "-ts", pack],
                         cwd=planner, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if run.returncode:
        yield f"lupdate ended with {run.returncode}"
    yield from (f"lupdate: {line}" for line in run.stdout.splitlines())


def check_sources(planner, pack, lupdate):
    """A sentence for each text that the sources have and the pack has not, or the other way round."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = pathlib.Path(folder, pack.name)
        yield from update(planner, fresh, lupdate)
        known, now = ({message[:3] for message in messages_of(of)} for of in (pack, fresh))
    yield from (f"{pack.name}: {context}: «{source}» is new" for context, source, _ in sorted(now - known))
    yield from (f"{pack.name}: {context}: «{source}» is said no more" for context, source, _ in sorted(known - now))


def check(planner, lupdate):
    """A sentence for each fault."""
    packs = sorted((planner / "Languages").glob("*.ts"))
    if not packs:
        yield "there is no language pack to check"
    for pack in packs:
        for message in messages_of(pack):
            yield from (f"{pack.name}: {message.context}: «{message.source}» {fault}" for fault in check_message(message))
        if lupdate and pack.name.startswith("hasp-planner_"):
            yield from check_sources(planner, pack, lupdate)


def self_test(lupdate):
    """Each seeded fault is found, alone; the clean folder is clean."""
    source = 'class Box { Q_OBJECT QString Text() { return tr("&Move %1 of %2"); } };'
    other = 'QString Other(Box& box) { return box.tr("&Move %1 of %2"); }'
    clean = "<translation>&amp;Flytta %1 av %2</translation>"
    seeded = [
        ("<translation type='unfinished'>&amp;Flytta %1 av %2</translation>", source, "is not translated"),
        ("<translation></translation>", source, "is not translated"),
        ("<translation>&amp;Flytta %1 av %1</translation>", source, "other places"),
        ("<translation>Flytta %1 av %2</translation>", source, "other mnemonics"),
        ("<translation>&amp;Flytta %1 av %2 </translation>", source, "other spaces"),
    ]
    if lupdate:
        seeded += [
            (clean, "", "is said no more"),
            (clean, source + ' class Far { Q_OBJECT QString Text() { return tr("Far"); } };', "«Far» is new"),
            (clean, source + other, "lupdate: "),
            (clean, source + " constexpr int Many = 10'000;", "lupdate: "),
        ]
    failures = []

    def faults(translation, text):
        with tempfile.TemporaryDirectory() as folder:
            planner = pathlib.Path(folder)
            for name, content in {
                "Window/Box.h": text,
                "Languages/hasp-planner_sv.ts":
                    "<!DOCTYPE TS><TS version='2.1' language='sv' sourcelanguage='en'><context><name>Box</name>"
                    f"<message><source>&amp;Move %1 of %2</source>{translation}</message></context></TS>",
            }.items():
                (planner / name).parent.mkdir()
                (planner / name).write_text(content, encoding="utf-8")
            return list(check(planner, lupdate))

    if faults(clean, source):
        failures.append(f"clean folder: {faults(clean, source)}")
    for translation, text, expected in seeded:
        found = faults(translation, text)
        if not found or expected not in found[0]:
            failures.append(f"{translation} {text}: found {found}, expected {expected}")
    print(f"{len(seeded) + 1} cases, {len(failures)} failed")
    return failures


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    lupdate = sys.argv[2] if len(sys.argv) > 2 else None
    wrong = self_test(lupdate) if sys.argv[1] == "--self-test" else list(check(pathlib.Path(sys.argv[1]).resolve(), lupdate))
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return 1 if wrong else 0


sys.exit(main())
