# What Falcon adds: list(APPEND sources …), headers, private.
list(APPEND sources Falcon/FalconBoot.cxx Falcon/FalconDriver.cxx Falcon/FalconKinematics.cxx Falcon/FalconPacket.cxx Falcon/FtdiLine.h)
list(APPEND headers Falcon/FalconBoot.h Falcon/FalconDriver.h Falcon/FalconKinematics.h Falcon/FalconPacket.h Falcon/UsbTransport.h)
if (HASP_ENABLE_LIBUSB)
  list(APPEND sources Falcon/LibusbTransport.cxx)
  list(APPEND private Libusb::Libusb)
  list(APPEND headers Falcon/LibusbTransport.h)
endif ()
