# A SpaceMouse and spacenavd without either: fakes in this process.
hasp_add_device_test(NAME TestSpaceMouse
  SOURCES ../../Kernels/Grid/Testing/CountNew.cxx Testing/FakeHid.h Testing/FakeSpacenavd.h Testing/SpaceMouseBench.h Testing/TestHidReportDescriptor.cxx
    Testing/TestSpaceMouseDriver.cxx Testing/TestSpaceMouseFaults.cxx Testing/TestSpaceMouseModels.cxx Testing/TestSpaceMouseReport.cxx
    Testing/TestSpacenavSocket.cxx
  LIBRARIES Hasp::DeviceDrivers)

# And behind the system's own hidapi, on hidraw nodes of umockdev.
if (NOT HASP_BUILD_TESTING OR NOT HASP_ENABLE_HIDAPI)
  return()
endif ()
find_package(PkgConfig QUIET)
if (PKG_CONFIG_FOUND)
  pkg_check_modules(UMOCKDEV QUIET IMPORTED_TARGET umockdev-1.0)
endif ()
if (NOT UMOCKDEV_FOUND OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread") # two preloads, each to be the first
  message(STATUS "Hasp: no tests of a SpaceMouse behind hidapi; they take umockdev, and not the thread sanitizer")
  return()
endif ()

set(space_mouse_hid Testing/FakeHid.h Testing/FakeHidraw.cxx Testing/FakeHidraw.h Testing/TestSpaceMouseHid.cxx)
add_executable(TestSpaceMouseHid ${space_mouse_hid})
target_link_libraries(TestSpaceMouseHid PRIVATE Hasp::DeviceDrivers GTest::gtest PkgConfig::UMOCKDEV)
set_target_properties(TestSpaceMouseHid PROPERTIES UNITY_BUILD OFF)

# Not one CTest test a case: without umockdev's library to preload there are no cases to find, and that must fail.
add_test(NAME SpaceMouseHid COMMAND TestSpaceMouseHid)
add_test(NAME SpaceMouseHid.AsNobody COMMAND TestSpaceMouseHid --as-nobody)
set(space_mouse_tests SpaceMouseHid SpaceMouseHid.AsNobody)

# As umockdev-wrapper does it. A sanitizer's library has to come before umockdev's: in a sanitized build it is
# preloaded, too; else the sanitized variant has it, and the driver, inside.
set(space_mouse_preload libumockdev-preload.so.0)
if (CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*address")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
    OUTPUT_VARIABLE asan OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(PREPEND space_mouse_preload "${asan}:")
elseif (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_executable(TestSpaceMouseHidSanitized ${space_mouse_hid} SpaceMouse/HidReportDescriptor.cxx SpaceMouse/HidapiTransport.cxx
    SpaceMouse/SpaceMouseDriver.cxx SpaceMouse/SpaceMouseHid.cxx SpaceMouse/SpaceMouseModels.cxx SpaceMouse/SpaceMouseReport.cxx)
  target_link_libraries(TestSpaceMouseHidSanitized PRIVATE Hasp::Devices Hidapi::Hidapi GTest::gtest PkgConfig::UMOCKDEV)
  target_compile_options(TestSpaceMouseHidSanitized PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  target_link_options(TestSpaceMouseHidSanitized PRIVATE -fsanitize=address,undefined -static-libasan -static-libubsan)
  set_target_properties(TestSpaceMouseHidSanitized PROPERTIES UNITY_BUILD OFF)
  add_test(NAME SpaceMouseHid.Sanitized COMMAND TestSpaceMouseHidSanitized)
  list(APPEND space_mouse_tests SpaceMouseHid.Sanitized)
endif ()
set_tests_properties(${space_mouse_tests} PROPERTIES LABELS "kernel;device" TIMEOUT 300 ENVIRONMENT "LD_PRELOAD=${space_mouse_preload}")
