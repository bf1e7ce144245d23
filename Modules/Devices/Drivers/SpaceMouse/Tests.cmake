# A SpaceMouse and spacenavd without either: fakes in this process, and behind the system's own hidapi.
hasp_add_device_test(NAME TestSpaceMouse
  SOURCES ../../Kernels/Grid/Testing/CountNew.cxx Testing/FakeHid.h Testing/FakeSpacenavd.h Testing/SpaceMouseBench.h Testing/TestHidReportDescriptor.cxx
    Testing/TestSpaceMouseDriver.cxx Testing/TestSpaceMouseFaults.cxx Testing/TestSpaceMouseModels.cxx Testing/TestSpaceMouseReport.cxx
    Testing/TestSpacenavSocket.cxx
  LIBRARIES Hasp::DeviceDrivers)
if (HASP_ENABLE_HIDAPI)
  hasp_add_umockdev_tests(SpaceMouseHid
    SOURCES Testing/FakeHid.h Testing/FakeHidraw.cxx Testing/FakeHidraw.h Testing/TestSpaceMouseHid.cxx
    DRIVER DeviceSearch.cxx SpaceMouse/HidReportDescriptor.cxx SpaceMouse/HidapiTransport.cxx SpaceMouse/SpaceMouseDriver.cxx SpaceMouse/SpaceMouseHid.cxx
      SpaceMouse/SpaceMouseModels.cxx SpaceMouse/SpaceMouseReport.cxx
    LIBRARIES Hidapi::Hidapi)
endif ()
