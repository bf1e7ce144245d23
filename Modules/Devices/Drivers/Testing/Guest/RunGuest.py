"""Runs the tests of drivers in a machine of their own: QEMU emulates it, and a real Linux kernel believes in the
devices that the tests make.

    RunGuest.py --kernel <folder of Utilities/Scripts/guest> --init GuestInit --tests TestGuestDevices
                --falcon ServeFalcon --work <folder for what is made>

Passes if every case that the program of the tests lists is said on the guest's console to be OK, they ended with 0,
and the kernel did not complain. Else prints why, and the end of the console. Ends with 77 where it cannot run.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import time

QEMU = "qemu-system-x86_64"
SKIPPED = 77
DEADLINE_S = 300  # of the whole machine: 30 s as a rule, 200 s where six others want its two processors
PARAMETERS = {"dummy_hcd": "is_high_speed=0"}  # a Falcon is a device of full speed
COMPLAINTS = re.compile(r"Kernel panic|BUG:|Oops|general protection fault")
COMMAND_LINE = " ".join((
    "console=ttyS0",
    "loglevel=2",  # worse than errors only; the first process prints the others at the end
    "panic=-1",  # ends the machine at once, too
    "nowatchdog", "rcupdate.rcu_cpu_stall_suppress=1"))  # for where this machine leaves the guest alone for seconds


def libraries(program):
    """All shared libraries of a program, and what loads them."""
    said = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    missing = re.findall(r"(\S+) => not found", said)
    if missing:
        sys.exit(f"{program} does not find {' '.join(missing)}")
    return {pathlib.Path(path) for path in re.findall(r"(?:=> |^\s+)(/.+) \(0x", said, re.MULTILINE)}


class Archive:
    """An initramfs: cpio of the kind that the kernel knows, "newc"."""

    def __init__(self):
        self.bytes = bytearray()
        self.count = 0

    def add(self, name, mode, content=b"", device=(0, 0)):
        self.count += 1
        text = name.encode() + b"\0"
        numbers = (self.count, mode, 0, 0, 1, 0, len(content), 0, 0, *device, len(text), 0)
        self.bytes += b"070701" + b"".join(b"%08X" % n for n in numbers)
        for part in (text, content):
            self.bytes += part
            self.bytes += bytes(-len(self.bytes) % 4)

    def folder(self, name):
        self.add(name, 0o040755)

    def program(self, name, file):
        self.add(name, 0o100755, pathlib.Path(file).read_bytes())


def make_image(args, file):
    image = Archive()
    for name in ("dev", "lib", "lib64", "modules"):
        image.folder(name)
    image.add("dev/console", 0o020600, device=(5, 1))  # the kernel opens it for the first process
    image.program("init", args.init)
    image.program("tests", args.tests)
    for library in libraries(args.init) | libraries(args.tests):
        # Where the loader looks that is written in programs; the others are found in /lib by their names.
        image.program(("lib64/" if library.name.startswith("ld-linux") else "lib/") + library.name, library)
    modules = []
    for module in sorted((args.kernel / "modules").iterdir()):
        image.program(f"modules/{module.name}", module)
        modules.append(f"/modules/{module.name} {PARAMETERS.get(module.stem.split('-', 1)[1], '')}\n")
    image.add("modules/list", 0o100644, "".join(modules).encode())
    image.add("TRAILER!!!", 0)
    file.write_bytes(image.bytes)


def run_guest(args, image, console, line):
    """How long it ran, or None if it did not end in time."""
    began = time.monotonic()
    machine = [
        QEMU, "-accel", "tcg,thread=multi", "-cpu", "max", "-smp", "2", "-m", "512", "-nodefaults", "-display", "none",
        "-no-reboot", "-kernel", args.kernel / "vmlinuz", "-initrd", image,
        "-append", COMMAND_LINE,
        "-serial", f"file:{console}",
        "-device", "qemu-xhci", "-chardev", f"serial,id=falcon,path={line}",
        "-device", "usb-serial,chardev=falcon,always-plugged=on",
    ]
    with subprocess.Popen(machine, stdin=subprocess.DEVNULL) as qemu:
        try:
            code = qemu.wait(DEADLINE_S)
        except subprocess.TimeoutExpired:
            qemu.kill()
            return None
    if code != 0:
        sys.exit(f"{QEMU} ended with {code}")
    return time.monotonic() - began


def cases(program):
    listed = subprocess.run([program, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    suite = ""
    for text in listed.splitlines():
        if text.endswith("."):
            suite = text
        elif text.startswith("  "):
            yield suite + text.split()[0]


def faults(lines, wanted, seconds):
    if seconds is None:
        yield f"it did not end within {DEADLINE_S} s"
    yield from (f"the kernel says: {text}" for text in lines if COMPLAINTS.search(text))
    passed = {text.split()[3] for text in lines if text.startswith("[       OK ] ")}
    yield from (f"{case} did not pass" for case in wanted if case not in passed)
    if "guest: the tests ended with 0" not in lines:
        yield "the tests did not end with 0"


def main():
    parser = argparse.ArgumentParser()
    for name in ("kernel", "init", "tests", "falcon", "work"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    args = parser.parse_args()
    for what, there in ((QEMU, shutil.which(QEMU)), ("the guest's kernel", (args.kernel / "vmlinuz").is_file())):
        if not there:
            print(f"skipped: {what} is not there; Utilities/Scripts/guest gets it")
            sys.exit(SKIPPED)

    args.work.mkdir(parents=True, exist_ok=True)
    image, console = args.work / "image.cpio", args.work / "console.txt"
    console.unlink(missing_ok=True)
    wanted = list(cases(args.tests))
    if not wanted:
        sys.exit("there are no tests for the guest")
    make_image(args, image)
    with subprocess.Popen([args.falcon], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as falcon:
        try:
            seconds = run_guest(args, image, console, falcon.stdout.readline().strip())
        finally:
            falcon.stdin.close()  # it ends then
    lines = console.read_text(errors="replace").replace("\r", "").splitlines() if console.exists() else []
    found = list(faults(lines, wanted, seconds))
    if found:
        print("The last lines of the console:", *lines[-50:], "", "Failed:", *found, sep="\n")
        sys.exit(1)
    print(*(text for text in lines if text.startswith(("guest: ", "[       OK ] "))), sep="\n")
    print(f"{len(wanted)} cases passed; the machine ran for {seconds:.0f} s")


main()
