# hidapi over the kernel's hidraw: it reads without taking the device from others. Gives Hidapi_FOUND and
# Hidapi::Hidapi.
find_path(Hidapi_INCLUDE_DIR hidapi/hidapi.h)
find_library(Hidapi_LIBRARY hidapi-hidraw)
mark_as_advanced(Hidapi_INCLUDE_DIR Hidapi_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Hidapi REQUIRED_VARS Hidapi_LIBRARY Hidapi_INCLUDE_DIR)
if (Hidapi_FOUND AND NOT TARGET Hidapi::Hidapi)
  add_library(Hidapi::Hidapi UNKNOWN IMPORTED)
  set_target_properties(Hidapi::Hidapi PROPERTIES IMPORTED_LOCATION "${Hidapi_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Hidapi_INCLUDE_DIR}")
endif ()
