# cmake -DSOURCE=<checkout> -P MissingBaseline.cmake: must stop, and name the command that records.
set(HASP_BUILD_TESTING OFF)
include("${SOURCE}/Testing/CMake/HaspTesting.cmake")
hasp_add_render_test(RenderingHeadless SOURCES Cxx/TestThatHasNoPicture.cxx)
message("configured without a baseline")
