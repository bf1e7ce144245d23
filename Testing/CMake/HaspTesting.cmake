# The test harness. Labels: kernel module render haptic device guest app extreme minimal bench.
if (HASP_BUILD_TESTING)
  enable_testing()
  include(GoogleTest)
endif ()

# hasp_add_kernel_test(Grid SOURCES Testing/TestGridView.cxx … [LIBRARIES targets…] [LABELS labels…])
#
# One program per kernel, one CTest test per GoogleTest case, labelled kernel. A second call with another
# NAME makes a second program, for cases with labels of their own.
function (hasp_add_kernel_test noun)
  if (NOT HASP_BUILD_TESTING)
    return()
  endif ()
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    set(arg_NAME TestKernel${noun})
  endif ()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE Hasp::Kernel${noun} ${arg_LIBRARIES} GTest::gtest_main)
  gtest_discover_tests(${arg_NAME} DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS "kernel;${arg_LABELS}" TIMEOUT 120)
endfunction ()

# hasp_add_module_test(IOMedical SOURCES Cxx/TestVolumeReader.cxx … [LIBRARIES targets…] [LABELS labels…])
#
# GoogleTest cases of a VTK module that draw nothing. Called from the module's Testing/CMakeLists.txt.
function (hasp_add_module_test module)
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    set(arg_NAME Test${module})
  endif ()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE Hasp::${module} ${arg_LIBRARIES} GTest::gtest_main)
  vtk_module_autoinit(TARGETS ${arg_NAME} MODULES Hasp::${module} ${arg_LIBRARIES})
  gtest_discover_tests(${arg_NAME} DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS "module;${arg_LABELS}" TIMEOUT 120)
endfunction ()
