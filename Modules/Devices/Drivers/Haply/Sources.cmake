# Haply Inverse3: its maker's service is spoken to; nothing of it is needed to build this. Header-only Beast and JSON,
# in the sources alone: the settings are there in every build.
list(APPEND headers Haply/HaplyDriver.h Haply/HaplyMessages.h Haply/WebSocketClient.h)
if (HASP_ENABLE_BEAST AND HASP_ENABLE_JSON)
  list(APPEND sources Haply/HaplyDriver.cxx Haply/HaplyMessages.cxx Haply/WebSocketClient.cxx)
  list(APPEND private Boost::headers nlohmann_json::nlohmann_json)
endif ()
