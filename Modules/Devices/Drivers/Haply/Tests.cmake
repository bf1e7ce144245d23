if (HASP_ENABLE_BEAST AND HASP_ENABLE_JSON)
  hasp_add_device_test(NAME TestHaply
    SOURCES Testing/HaplyBench.h Testing/HaplyServiceUnderTest.cxx Testing/HaplyServiceUnderTest.h Testing/TestHaplyDriver.cxx
      Testing/TestHaplyFaults.cxx Testing/TestHaplyMessages.cxx Testing/TestWebSocketClient.cxx
    LIBRARIES Hasp::DeviceDrivers Boost::headers nlohmann_json::nlohmann_json)
endif ()
