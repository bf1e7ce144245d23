# Vendors' SDKs behind a table of C functions, loaded at run time: nothing of theirs is needed to build this.
list(APPEND sources Plugin/PluginDriver.cxx)
list(APPEND headers Plugin/HapticDevicePlugin.h Plugin/PluginDriver.h)
