list(APPEND sources SpaceMouse/HidReportDescriptor.cxx SpaceMouse/SpaceMouseDriver.cxx SpaceMouse/SpaceMouseHid.cxx
  SpaceMouse/SpaceMouseModels.cxx SpaceMouse/SpaceMouseReport.cxx SpaceMouse/SpacenavSocket.cxx)
list(APPEND headers SpaceMouse/HidReportDescriptor.h SpaceMouse/HidTransport.h SpaceMouse/SixDofAxes.h SpaceMouse/SixDofSource.h
  SpaceMouse/SpaceMouseDriver.h SpaceMouse/SpaceMouseHid.h SpaceMouse/SpaceMouseModels.h SpaceMouse/SpaceMouseReport.h
  SpaceMouse/SpacenavSocket.h)
if (HASP_ENABLE_HIDAPI)
  list(APPEND sources SpaceMouse/HidapiTransport.cxx)
  list(APPEND headers SpaceMouse/HidapiTransport.h)
  list(APPEND private Hidapi::Hidapi)
endif ()
