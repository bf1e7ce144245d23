# The drivers and a real kernel: in a machine that QEMU emulates, on devices that the kernel believes in.
if (NOT HASP_BUILD_TESTING OR NOT HASP_ENABLE_LIBUSB OR NOT HASP_ENABLE_HIDAPI OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux"
    OR NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" OR CMAKE_CROSSCOMPILING
    OR CMAKE_CXX_FLAGS MATCHES "-fsanitize") # an emulated processor is slow enough without
  return()
endif ()
find_program(HASP_PYTHON3 NAMES python3 REQUIRED)

set(guest Testing/Guest)
# The first process: of no library of ours.
add_executable(GuestInit ${guest}/GuestInit.cxx)
add_executable(TestGuestDevices ${guest}/GadgetFalcon.cxx ${guest}/GadgetFalcon.h ${guest}/GuestFalconBench.h
  ${guest}/TestGuestFalcon.cxx ${guest}/TestGuestSerial.cxx ${guest}/TestGuestSpaceMouse.cxx
  ${guest}/UhidSpaceMouse.cxx ${guest}/UhidSpaceMouse.h ${guest}/Waiting.h)
target_link_libraries(TestGuestDevices PRIVATE HaspDriverTrials Libusb::Libusb GTest::gtest_main ${CMAKE_DL_LIBS})
# A model outside of the guest.
add_executable(ServeFalcon ${guest}/ServeFalcon.cxx)
target_link_libraries(ServeFalcon PRIVATE HaspDriverTrials)
set_target_properties(GuestInit TestGuestDevices ServeFalcon PROPERTIES UNITY_BUILD OFF)

add_test(NAME GuestDevices COMMAND "${HASP_PYTHON3}" -S "${CMAKE_CURRENT_SOURCE_DIR}/${guest}/RunGuest.py"
  --kernel "${PROJECT_SOURCE_DIR}/.cache/guest" --init $<TARGET_FILE:GuestInit> --tests $<TARGET_FILE:TestGuestDevices>
  --falcon $<TARGET_FILE:ServeFalcon> --work "${CMAKE_CURRENT_BINARY_DIR}/Guest")
# Two processors are emulated, and time is the real one.
set_tests_properties(GuestDevices PROPERTIES LABELS "device;guest" TIMEOUT 600 SKIP_RETURN_CODE 77 PROCESSORS 2 COST 50)
