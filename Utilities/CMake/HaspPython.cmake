# hasp_wrap_python(Hasp::IOMedical …)
#
# The Python package hasp, with every VTK class of these modules. In the build tree and installed alike:
#   PYTHONPATH=<tree>/lib/python3/dist-packages /usr/bin/python3 -c "import hasp"
set(HASP_PYTHON_DIR "lib/python3/dist-packages" CACHE STRING "Where the package hasp goes, below the prefix")

function (hasp_wrap_python)
  vtk_module_wrap_python(
    MODULES ${ARGN}
    WRAPPED_MODULES wrapped
    TARGET Hasp::PythonPackage
    PYTHON_PACKAGE hasp
    MODULE_DESTINATION "${HASP_PYTHON_DIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION "${HASP_PACKAGE_DIR}"
    BUILD_STATIC OFF)
  set(imports)
  foreach (module IN LISTS wrapped)
    string(REPLACE "Hasp::" "vtkHasp" library "${module}")
    string(APPEND imports "from .${library} import *\n")
    target_compile_options(${library}Python PRIVATE -w -O1) # generated, and never the hot spot
  endforeach ()
  set(package "${CMAKE_BINARY_DIR}/${HASP_PYTHON_DIR}/hasp")
  configure_file("${PROJECT_SOURCE_DIR}/Utilities/Python/__init__.py.in" "${package}/__init__.py" @ONLY)
  install(FILES "${package}/__init__.py" DESTINATION "${HASP_PYTHON_DIR}/hasp" COMPONENT python)
endfunction ()
