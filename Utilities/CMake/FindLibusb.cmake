# libusb 1.0. Gives Libusb_FOUND, Libusb_VERSION and Libusb::Libusb.
find_package(PkgConfig QUIET)
pkg_check_modules(PC_Libusb QUIET libusb-1.0)
find_path(Libusb_INCLUDE_DIR libusb.h HINTS ${PC_Libusb_INCLUDE_DIRS} PATH_SUFFIXES libusb-1.0)
find_library(Libusb_LIBRARY usb-1.0 HINTS ${PC_Libusb_LIBRARY_DIRS})
set(Libusb_VERSION "${PC_Libusb_VERSION}")
mark_as_advanced(Libusb_INCLUDE_DIR Libusb_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Libusb REQUIRED_VARS Libusb_LIBRARY Libusb_INCLUDE_DIR VERSION_VAR Libusb_VERSION)
if (Libusb_FOUND AND NOT TARGET Libusb::Libusb)
  add_library(Libusb::Libusb UNKNOWN IMPORTED)
  set_target_properties(Libusb::Libusb PROPERTIES IMPORTED_LOCATION "${Libusb_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Libusb_INCLUDE_DIR}")
endif ()
