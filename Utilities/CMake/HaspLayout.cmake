# Where things are built and installed.
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR};$ORIGIN")
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

set(HASP_PACKAGE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/Hasp")
set(HASP_HEADER_DIR "${CMAKE_INSTALL_INCLUDEDIR}/Hasp")

# Our own code is held to these; dependencies' headers are not. -ffp-contract=off keeps CPU results the
# same with and without FMA, so that scalar, SIMD and recorded results can be compared bit for bit.
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Wall> $<$<COMPILE_LANGUAGE:CXX>:-Wextra>
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
option(HASP_WARNINGS_AS_ERRORS "Stop at the first warning" OFF)
if (HASP_WARNINGS_AS_ERRORS)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif ()
