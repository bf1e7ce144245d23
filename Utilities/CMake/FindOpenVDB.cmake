# OpenVDB, as Debian has it: gives OpenVDB_FOUND, OpenVDB_VERSION and OpenVDB::openvdb. The module that comes with OpenVDB stops
# the configuration where Boost's is not there, and sets BUILD_SHARED_LIBS.
find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
find_path(OpenVDB_BOOST_INCLUDE_DIR boost/any.hpp)
find_library(OpenVDB_LIBRARY openvdb)
find_library(OpenVDB_IMATH_LIBRARY NAMES Imath Imath-3_1)
find_library(OpenVDB_TBB_LIBRARY tbb)
mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_BOOST_INCLUDE_DIR OpenVDB_LIBRARY OpenVDB_IMATH_LIBRARY OpenVDB_TBB_LIBRARY)

if (OpenVDB_INCLUDE_DIR)
  set(OpenVDB_VERSION)
  foreach (part MAJOR MINOR PATCH)
    file(STRINGS "${OpenVDB_INCLUDE_DIR}/openvdb/version.h" line
      REGEX "^#define OPENVDB_LIBRARY_${part}_VERSION_NUMBER [0-9]+$")
    string(REGEX REPLACE ".* " "" number "${line}")
    list(APPEND OpenVDB_VERSION ${number})
  endforeach ()
  list(JOIN OpenVDB_VERSION "." OpenVDB_VERSION)
endif ()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVDB
  REQUIRED_VARS OpenVDB_LIBRARY OpenVDB_INCLUDE_DIR OpenVDB_BOOST_INCLUDE_DIR OpenVDB_IMATH_LIBRARY OpenVDB_TBB_LIBRARY
  VERSION_VAR OpenVDB_VERSION)
if (OpenVDB_FOUND AND NOT TARGET OpenVDB::openvdb)
  add_library(OpenVDB::openvdb UNKNOWN IMPORTED)
  set_target_properties(OpenVDB::openvdb PROPERTIES IMPORTED_LOCATION "${OpenVDB_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenVDB_INCLUDE_DIR};${OpenVDB_BOOST_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${OpenVDB_IMATH_LIBRARY};${OpenVDB_TBB_LIBRARY}")
endif ()
