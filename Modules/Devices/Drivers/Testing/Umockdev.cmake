# Tests that ask the system's own libraries for devices of umockdev, which are not there.
#
# hasp_add_umockdev_tests(FalconUsb SOURCES Testing/TestFalconUsb.cxx … DRIVER Falcon/FalconDriver.cxx … LIBRARIES Libusb::Libusb)
#
# TestFalconUsb as it is, as a user without rights, and once more with the address and undefined-behaviour sanitizers
# and the driver in it. Not one CTest test a case: without umockdev's library to preload there are no cases to find,
# and that must fail. Where umockdev was not found there are none, and it is said.
find_package(PkgConfig QUIET)
if (PKG_CONFIG_FOUND)
  pkg_check_modules(UMOCKDEV QUIET IMPORTED_TARGET GLOBAL umockdev-1.0)
endif ()

function (hasp_add_umockdev_tests name)
  cmake_parse_arguments(arg "" "" "SOURCES;DRIVER;LIBRARIES" ${ARGN})
  if (NOT HASP_BUILD_TESTING)
    return()
  elseif (NOT UMOCKDEV_FOUND OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread") # two preloads, each to be the first
    message(STATUS "Hasp: no ${name} tests; they take umockdev (libumockdev-dev), and not the thread sanitizer")
    return()
  endif ()
  add_executable(Test${name} ${arg_SOURCES})
  target_link_libraries(Test${name} PRIVATE Hasp::DeviceDrivers GTest::gtest PkgConfig::UMOCKDEV)
  add_test(NAME ${name} COMMAND Test${name})
  add_test(NAME ${name}.AsNobody COMMAND Test${name} --as-nobody)
  set(tests ${name} ${name}.AsNobody)
  set(programs Test${name})
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    add_executable(Test${name}Sanitized ${arg_SOURCES} ${arg_DRIVER})
    target_link_libraries(Test${name}Sanitized PRIVATE Hasp::Devices ${arg_LIBRARIES} GTest::gtest PkgConfig::UMOCKDEV)
    target_compile_definitions(Test${name}Sanitized PRIVATE HASP_WITH_HIDAPI=$<BOOL:${HASP_ENABLE_HIDAPI}>
      HASP_WITH_LIBUSB=$<BOOL:${HASP_ENABLE_LIBUSB}>)
    target_compile_options(Test${name}Sanitized PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
    target_link_options(Test${name}Sanitized PRIVATE -fsanitize=address,undefined -static-libasan -static-libubsan)
    add_test(NAME ${name}.Sanitized COMMAND Test${name}Sanitized)
    list(APPEND tests ${name}.Sanitized)
    list(APPEND programs Test${name}Sanitized)
  endif ()
  foreach (program IN LISTS programs)
    target_include_directories(${program} PRIVATE Trials)
  endforeach ()
  set_target_properties(${programs} PROPERTIES UNITY_BUILD OFF)
  hasp_preload_umockdev("kernel;device" ${tests})
endfunction ()

# hasp_preload_umockdev("labels" tests…): as umockdev-wrapper does it. A sanitizer's library has to come before
# umockdev's: in a sanitized build it is preloaded, too; else a sanitized variant has it inside.
function (hasp_preload_umockdev labels)
  set(preload libumockdev-preload.so.0)
  if (CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*address")
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
      OUTPUT_VARIABLE asan OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(PREPEND preload "${asan}:")
  endif ()
  set_tests_properties(${ARGN} PROPERTIES LABELS "${labels}" TIMEOUT 600 ENVIRONMENT "LD_PRELOAD=${preload}")
endfunction ()
