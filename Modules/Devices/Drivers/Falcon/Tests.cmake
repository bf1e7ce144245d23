# A Falcon without one: as a model in this process, and behind the system's own libusb.
hasp_add_device_test(NAME TestFalcon
  SOURCES Testing/FalconBench.h Testing/FalconModel.cxx Testing/FalconModel.h Testing/TestFalconBoot.cxx
    Testing/TestFalconDriver.cxx Testing/TestFalconKinematics.cxx Testing/TestFalconPacket.cxx
  LIBRARIES Hasp::DeviceDrivers)

if (NOT HASP_BUILD_TESTING OR NOT HASP_ENABLE_LIBUSB)
  return()
endif ()
find_package(PkgConfig QUIET)
pkg_check_modules(UMOCKDEV QUIET IMPORTED_TARGET umockdev-1.0)
if (NOT UMOCKDEV_FOUND OR CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread") # two preloads, each to be the first
  message(STATUS "Hasp: no tests of a Falcon behind libusb; they take umockdev, and not the thread sanitizer")
  return()
endif ()

set(falcon_usb Testing/FalconBench.h Testing/FalconModel.cxx Testing/FalconModel.h Testing/FalconTestbed.cxx
  Testing/FalconTestbed.h Testing/TestFalconUsb.cxx)
add_executable(TestFalconUsb ${falcon_usb})
target_link_libraries(TestFalconUsb PRIVATE Hasp::DeviceDrivers GTest::gtest PkgConfig::UMOCKDEV)

# hasp_add_umockdev_test(FalconUsb COMMAND TestFalconUsb arguments…): as umockdev-wrapper runs it. A sanitizer's
# library has to come before umockdev's.
function (hasp_add_umockdev_test name)
  cmake_parse_arguments(arg "" "" "COMMAND" ${ARGN})
  set(preload libumockdev-preload.so.0)
  if (CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*address")
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
      OUTPUT_VARIABLE asan OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(preload "${asan}:${preload}")
  endif ()
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS device TIMEOUT 600 ENVIRONMENT "LD_PRELOAD=${preload}")
endfunction ()
hasp_add_umockdev_test(FalconUsb COMMAND TestFalconUsb)
hasp_add_umockdev_test(FalconUsb.AsNobody COMMAND TestFalconUsb --as-nobody)

# Once more with the sanitizers in it, all in one program: their library must not come after umockdev's.
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_executable(TestFalconUsbSanitized ${falcon_usb} Falcon/FalconBoot.cxx Falcon/FalconDriver.cxx
    Falcon/FalconKinematics.cxx Falcon/FalconPacket.cxx Falcon/LibusbTransport.cxx ../HapticDevice.cxx
    ../SettingsCheck.cxx)
  target_include_directories(TestFalconUsbSanitized PRIVATE "${PROJECT_SOURCE_DIR}/Modules"
    "${PROJECT_SOURCE_DIR}/Modules/Kernels")
  target_link_libraries(TestFalconUsbSanitized PRIVATE Libusb::Libusb glm::glm GTest::gtest PkgConfig::UMOCKDEV)
  target_compile_options(TestFalconUsbSanitized PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  target_link_options(TestFalconUsbSanitized PRIVATE -fsanitize=address,undefined -static-libasan -static-libubsan)
  hasp_add_umockdev_test(FalconUsb.Sanitized COMMAND TestFalconUsbSanitized)
endif ()
