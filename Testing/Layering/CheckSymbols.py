"""No symbol of ours is defined in two shared libraries: where both are loaded, one would run in place of the other.

    CheckSymbols.py <nm> <folder of libraries>
"""
import collections
import pathlib
import subprocess
import sys

OWN = ("hasp", "vtkHasp")  # namespace and classes, as they stand in demangled names


def defined(nm, library):
    """Strong symbols that others see. Weak ones, of templates and inline functions, are meant to be found twice."""
    said = subprocess.run([nm, "-D", "-C", "--defined-only", str(library)], check=True, capture_output=True, text=True)
    for line in said.stdout.splitlines():
        _, kind, name = line.split(" ", 2)
        if kind in "TDBR" and name.startswith(OWN):
            yield name


def main():
    nm, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    libraries = sorted({path.resolve() for path in folder.glob("lib*[hH]asp*.so")})
    if not libraries:
        sys.exit(f"no shared libraries of ours in {folder.name}")
    homes = collections.defaultdict(list)
    for library in libraries:
        for name in set(defined(nm, library)):
            homes[name].append(library.name)
    if not homes:
        sys.exit("no symbol of ours in any library: nm was not understood")
    twice = sorted((name, places) for name, places in homes.items() if len(places) > 1)
    for name, places in twice:
        print(f"{name}: in {' and '.join(places)}; give it another name, or hide it")
    print(f"{len(homes)} symbols in {len(libraries)} libraries, {len(twice)} in more than one")
    sys.exit(1 if twice else 0)


main()
