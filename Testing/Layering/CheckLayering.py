"""Holds every #include under Modules and Applications against layers.txt.

    python3 -S CheckLayering.py ROOT      prints each include that is not allowed; exit code 1 if any
    python3 -S CheckLayering.py           the self-test: seeded violations must be found

Kernels, Devices and Studies stay free of VTK, OpenGL and Qt whatever layers.txt says. The slots of
shaders (//Hasp::Name) count as includes of the unit that has glsl/Name.glsl.
"""
import pathlib
import re
import sys
import tempfile

OUTSIDE = [  # first match wins
    ("gl", r"vtk_gl(ew|ad)\.h|GL/.*|GLES.*"),
    ("egl", r"EGL/.*"),
    ("x11", r"X11/.*"),
    ("vtk", r"vtk\w*\.(h|txx)|vtksys/.*"),
    ("qt", r"Q[A-Z].*|Qt[A-Z]\w*|QVTK.*"),
    ("posix", r"(unistd|fcntl|dirent|dlfcn|signal|pthread|sched|spawn|time|poll)\.h|(sys|linux|arpa|netinet)/.*"),
    ("glm", r"glm/.*"),
    ("tbb", r"(oneapi/)?tbb/.*"),
    ("embree", r"embree[34]/.*"),
    ("hwy", r"hwy/.*"),
    ("lib3mf", r"Model/COM/NMR_\w+\.h"),
    ("openvdb", r"openvdb/.*"),
    ("eigen", r"(Eigen|unsupported)/.*"),
    ("cgal", r"CGAL/.*"),
    ("itk", r"itk\w+\.h"),
    ("nlohmann", r"nlohmann/.*"),
    ("cli11", r"CLI/.*"),
    ("libarchive", r"archive(_entry)?\.h"),
    ("openssl", r"openssl/.*"),
    ("dcmtk", r"dcmtk/.*"),
    ("seccomp", r"seccomp\.h"),
    ("libusb", r"libusb.*"),
    ("hidapi", r"hidapi.*"),
    ("umockdev", r"umockdev\.h|gio/.*|glib.*"),
    ("beast", r"boost/(asio|beast).*"),
    ("gtest", r"g(test|mock)/.*"),
    ("benchmark", r"benchmark/.*"),
    ("std", r"[a-z0-9_]+|stdint\.h"),
]
FREE_OF_VTK = ("Kernels/", "Devices", "Studies")
NEVER_BELOW = {"vtk", "gl", "egl", "qt"}
TEST_FOLDERS = {"Testing", "Benchmark", "Fuzz"}
SOURCES = {".h", ".cxx", ".cpp", ".hxx", ".txx", ".glsl", ".cu"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
SLOT = re.compile(r"^//Hasp::(\w+)\s*$", re.MULTILINE)


def read_layers(text):
    """{unit: (our units, outside libraries)}"""
    layers = {}
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line:
            unit, rest = line.split(":")
            ours, outside = rest.split("|")
            layers[unit.strip()] = (set(ours.split()), set(outside.split()))
    return layers


class Tree:
    """The files of a checkout and which unit owns each."""

    def __init__(self, root, layers):
        self.root = root
        self.files = []  # (unit, path)
        self.unlisted = set()
        self.owners = {}  # file name -> units that have such a file
        for top in ("Modules", "Applications"):
            for path in sorted((root / top).rglob("*")):
                if path.is_file() and path.suffix in SOURCES:
                    self.add(path, layers)
        for path in (root / "Testing/ImageComparison").glob("*.h"):
            self.owners[path.name] = {"Testing/ImageComparison"}

    def add(self, path, layers):
        name = path.relative_to(self.root).as_posix().removeprefix("Modules/")
        unit = next((u for u in layers if name.startswith(u + "/")), None)
        if unit is None:
            self.unlisted.add(str(pathlib.PurePosixPath(name).parent))
            return
        self.files.append((unit, path))
        self.owners.setdefault(path.name, set()).add(unit)
        if path.suffix == ".glsl":  # what vtk_encode_string makes of it
            self.owners.setdefault(path.stem + ".h", set()).add(unit)

    def resolve(self, header, unit):
        """The unit a header belongs to, or None if it is not ours."""
        for start in ("Kernels/", ""):
            first = header.split("/")[0]
            if "/" in header and (self.root / "Modules" / start / header).is_file():
                return start + first
        owners = self.owners.get(header.split("/")[-1], set())
        if owners:
            return unit if unit in owners else min(owners)
        made = re.fullmatch(r"vtkHasp(\w+)Module\.h", header)  # by VTK, for each module
        if made:
            return next((u for u, _ in self.files if u.replace("/", "") == made[1]), None)
        return None


def may_include(layers, unit, parts):
    """(our units, outside libraries) for a file of the unit whose path has these parts."""
    ours, outside = layers[unit]
    extra = None
    if TEST_FOLDERS & set(parts):
        extra = layers["+kernels" if unit.startswith(FREE_OF_VTK) else "+modules"]
    elif "Examples" in parts:
        extra = layers["+examples"]
    if extra:
        ours, outside = ours | extra[0], outside | extra[1]
    return ours | {unit}, outside | {"std", "glm"}


def check(root, layers):
    """A sentence for each violation."""
    wrong = []
    for unit, (_, outside) in layers.items():
        for library in sorted(outside & NEVER_BELOW if unit.startswith(FREE_OF_VTK) else ()):
            wrong.append(f"layers.txt: {unit} must stay free of {library}")
    tree = Tree(root, layers)
    wrong += [f"{folder}: is not in layers.txt" for folder in sorted(tree.unlisted)]
    for unit, path in tree.files:
        name = path.relative_to(root).as_posix()
        ours, outside = may_include(layers, unit, path.relative_to(root).parts)
        text = path.read_text(encoding="utf-8")
        slots = [s + ".glsl" for s in SLOT.findall(text)] if path.suffix == ".glsl" else []
        for header in INCLUDE.findall(text) + [s for s in slots if s in tree.owners]:
            owner = tree.resolve(header, unit)
            if owner is not None:
                if owner not in ours and "*" not in ours:
                    wrong.append(f"{name}: includes {header} of {owner}, which {unit} may not use")
                continue
            library = next((n for n, p in OUTSIDE if re.fullmatch(p, header)), None)
            if library is None:
                wrong.append(f"{name}: includes {header}, which is known to nobody")
            elif library not in outside:
                wrong.append(f"{name}: includes {header} ({library}), which {unit} may not use")
    return wrong


def self_test(layers):
    """Each seeded violation is found, alone; the clean tree is clean."""
    clean = {
        "Modules/Kernels/Grid/GridView.h": '#include "Grid/Progress.h"\n#include <vector>',
        "Modules/Kernels/Grid/Progress.h": "#include <glm/vec3.hpp>",
        "Modules/Kernels/Haptics/Force.h": '#include "Grid/GridView.h"',
        "Modules/Kernels/Isosurface/glsl/RayRoot.glsl": "",
        "Modules/Kernels/Isosurface/Testing/TestRayRoot.cxx": "#include <gtest/gtest.h>",
        "Modules/Common/Volume/vtkHaspView.h":
            '#include "vtkHaspCommonVolumeModule.h"\n#include "Grid/GridView.h"',
        "Modules/Rendering/Stereo/vtkHaspEyes.cxx":
            '#include "vtkHaspView.h"\n#include "vtkRenderer.h"\n// #include "Haptics/Force.h"',
        "Modules/Rendering/Stereo/Testing/Cxx/TestEyes.cxx": '#include "HaspRenderTest.h"',
        "Modules/Rendering/Stereo/Examples/DrawEyes.cxx":
            '#include "vtkHaspView.h"\n#include "Haptics/Force.h"\n#include "vtkNew.h"',
        "Testing/ImageComparison/HaspRenderTest.h": "",
        "Applications/CommandLine/main.cxx": '#include "Haptics/Force.h"\n#include <CLI/CLI.hpp>',
    }
    seeded = [
        ("Modules/Kernels/Grid/A.cxx", '#include "vtkObject.h"', "(vtk), which Kernels/Grid"),
        ("Modules/Kernels/Grid/A.cxx", '#  include <vtk_glew.h>', "(gl), which Kernels/Grid"),
        ("Modules/Kernels/Grid/A.cxx", "#include <GL/gl.h>", "(gl), which Kernels/Grid"),
        ("Modules/Kernels/Haptics/A.h", "#include <QWidget>", "(qt), which Kernels/Haptics"),
        ("Modules/Kernels/Grid/Testing/T.cxx", '#include "vtkNew.h"', "(vtk), which Kernels/Grid"),
        ("Modules/Kernels/Grid/A.h", '#include "Haptics/Force.h"', "of Kernels/Haptics"),
        ("Modules/Kernels/Grid/A.h", '#include "vtkHaspView.h"', "of Common/Volume"),
        ("Modules/Common/Volume/A.cxx", '#include "Haptics/Force.h"', "of Kernels/Haptics"),
        ("Modules/Rendering/Stereo/A.cxx", '#include <QWidget>', "(qt), which Rendering/Stereo"),
        ("Modules/Rendering/Stereo/A.cxx", '#include "HaspRenderTest.h"', "of Testing/Image"),
        ("Modules/Common/Volume/Examples/A.cxx", "#include <GL/gl.h>", "(gl), which Common/Volume"),
        ("Modules/Rendering/Stereo/glsl/AVS.glsl", "//Hasp::RayRoot", "of Kernels/Isosurface"),
        ("Modules/Common/Volume/A.cxx", '#include "Nowhere/A.h"', "known to nobody"),
        ("Modules/Attic/A.cxx", "", "Attic: is not in layers.txt"),
    ]
    failures = []

    def violations(files, table):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text + "\n")
            return check(pathlib.Path(folder), table)

    if violations(clean, layers):
        failures.append(f"clean tree: {violations(clean, layers)}")
    for name, text, expected in seeded:
        found = violations({**clean, name: text}, layers)
        if len(found) != 1 or expected not in found[0]:
            failures.append(f"{name} with {text}: found {found}, expected {expected}")
    loose = {**layers, "Kernels/Grid": (set(), {"vtk"})}
    if not any("must stay free of vtk" in v for v in violations({}, loose)):
        failures.append("layers.txt may let VTK into a kernel")
    print(f"{len(seeded) + 2} cases, {len(failures)} failed")
    return failures


def main():
    layers = read_layers(pathlib.Path(__file__).with_name("layers.txt").read_text())
    wrong = check(pathlib.Path(sys.argv[1]).resolve(), layers) if sys.argv[1:] else self_test(layers)
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return 1 if wrong else 0


sys.exit(main())
