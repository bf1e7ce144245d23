# Every optional dependency is one HASP_ENABLE_ switch, ON where the library is found.
# What is switched OFF is neither searched for nor linked. Switching ON what is missing is an error.

# hasp_optional(NAME "what it gives" find_package-arguments...)
macro(hasp_optional name gives)
  if (NOT DEFINED HASP_ENABLE_${name})
    find_package(${ARGN} QUIET)
    option(HASP_ENABLE_${name} "${gives}" ${${ARGV2}_FOUND})
  elseif (HASP_ENABLE_${name})
    find_package(${ARGN} REQUIRED)
  endif ()
  list(APPEND HASP_OPTIONS ${name})
endmacro ()

find_package(glm CONFIG REQUIRED)

set(HASP_OPTIONS)
hasp_optional(TBB "Kernels use all cores (oneTBB)" TBB CONFIG)
hasp_optional(LIBARCHIVE "Read InVesalius projects, .inv3" LibArchive)
hasp_optional(OPENSSL "Hash volumes, SHA-256" OpenSSL COMPONENTS Crypto)
hasp_optional(DCMTK "Read DICOM, in a child process" DCMTK)
hasp_optional(SECCOMP "Filter the system calls of the DICOM child process (libseccomp)" Seccomp)
hasp_optional(CGAL "Check meshes: closed, manifold, no self-intersection (GPL)" CGAL CONFIG)
hasp_optional(OPENVDB "Narrow bands and meshes as level sets (OpenVDB)" OpenVDB 10)
hasp_optional(LIB3MF "Parts as .3mf (lib3mf 1.8)" Lib3MF)
hasp_optional(ITK "Print ITK's distance transform beside ours (benchmarks alone)" ITKCommon 5.2)
hasp_optional(EMBREE "Trace rays against clustered cells (Embree 3)" embree 3 CONFIG)
hasp_optional(HIGHWAY "Rays of a picture, voxels at a surface: side by side (Highway)" hwy CONFIG)
hasp_optional(EIGEN "Calibrate head trackers (Eigen)" Eigen3 CONFIG)
hasp_optional(EGL "Render without a display" OpenGL COMPONENTS EGL)
hasp_optional(X11 "Windows on a display: hasp view" X11)
hasp_optional(JSON "Passport, reports and --json output" nlohmann_json CONFIG)
hasp_optional(CLI11 "The hasp command line" CLI11 CONFIG)
hasp_optional(LIBUSB "Drive a Novint Falcon (libusb)" Libusb 1.0.23)
hasp_optional(HIDAPI "Read 3Dconnexion SpaceMouse (hidapi)" Hidapi)
hasp_optional(BEAST "Drive a Haply Inverse3 through its service (Boost.Beast)" Boost 1.74)
hasp_optional(QT "The planner's window: hasp-planner (Qt 5)" Qt5 COMPONENTS Widgets Test)
set(qt_modules)
if (HASP_ENABLE_QT)
  set(qt_modules GUISupportQt RenderingAnnotation)
endif ()
# VTK's wrappers are of the system's Python, not of whichever python3 comes first in PATH (a pyenv shim).
if (EXISTS "/usr/bin/python3")
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python that VTK was wrapped for")
endif ()
hasp_optional(PYTHON "import hasp" VTK 9.1 COMPONENTS Python WrappingPythonCore)
hasp_optional(OPENXR "Head-mounted displays through OpenXR" VTK 9.1 COMPONENTS RenderingOpenXR)
if (NOT HASP_ENABLE_OPENXR)
  message(STATUS "Hasp: no OpenXR output; it takes a VTK >= 9.2 with its module RenderingOpenXR")
endif ()

# Modules not named by VTK_MODULE_ENABLE_Hasp_<Module>=YES are built only when this is ON.
option(HASP_BUILD_ALL_MODULES "Build every VTK module whose dependencies are there" ON)
option(HASP_BUILD_TESTING "Build the tests (needs GoogleTest)" ON)
if (HASP_BUILD_TESTING)
  find_package(GTest REQUIRED)
endif ()

# VTK with only what is used: without COMPONENTS every find module VTK knows would run.
# glew + opengl: VTK < 9.4, glad: VTK >= 9.4. The last line is what the application, its rivals in
# `hasp report` and the tests use; a build of single modules does without.
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  RenderingCore RenderingOpenGL2
  OPTIONAL_COMPONENTS glew opengl glad
  IOImage IOGeometry IOPLY IOXML IOXMLParser FiltersCore FiltersSources FiltersGeneral FiltersModeling FiltersPoints ImagingCore ImagingGeneral
  RenderingVolume RenderingVolumeOpenGL2 InteractionStyle InteractionWidgets RenderingFreeType RenderingUI
  TestingRendering ${qt_modules})

# After VTK: its configuration would search for all of VTK's modules by itself.
hasp_optional(VTKDICOM "Write DICOM series (vtk-dicom)" dicom CONFIG)
