# A Falcon without one: as a model in this process, and behind the system's own libusb.
hasp_add_device_test(NAME TestFalcon
  SOURCES Testing/FalconBench.h Testing/TestFalconBoot.cxx Testing/TestFalconDriver.cxx Testing/TestFalconKinematics.cxx
    Testing/TestFalconPacket.cxx
  LIBRARIES HaspDriverTrials)
if (HASP_ENABLE_LIBUSB)
  hasp_add_umockdev_tests(FalconUsb
    SOURCES Testing/FalconBench.h Testing/FalconTestbed.cxx Testing/FalconTestbed.h Testing/TestFalconUsb.cxx Trials/FalconModel.cxx
      Trials/FalconModel.h
    DRIVER DeviceSearch.cxx SpaceMouse/SpaceMouseModels.cxx Falcon/FalconBoot.cxx Falcon/FalconDriver.cxx Falcon/FalconKinematics.cxx Falcon/FalconPacket.cxx Falcon/LibusbTransport.cxx
    LIBRARIES Libusb::Libusb)
endif ()
