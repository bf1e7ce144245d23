hasp_add_device_test(NAME TestDevicePlugins
  SOURCES Testing/TestPluginDriver.cxx Testing/TestPluginSpringBox.cxx
  LIBRARIES Hasp::DeviceDrivers)
if (HASP_BUILD_TESTING)
  set(plugins "${CMAKE_CURRENT_BINARY_DIR}/Plugins")
  target_compile_definitions(TestDevicePlugins PRIVATE HASP_TEST_PLUGINS="${plugins}")
  # The sample, and a plugin under test: a good one, and one for each fault that loading must see.
  add_library(DevicePluginSpringBox MODULE Plugin/Sample/SpringBox.c)
  set(modules DevicePluginSpringBox)
  foreach (fault RANGE 8)
    add_library(DevicePlugin${fault} MODULE Testing/DevicePluginUnderTest.c)
    target_compile_definitions(DevicePlugin${fault} PRIVATE HASP_FAULT=${fault})
    list(APPEND modules DevicePlugin${fault})
  endforeach ()
  foreach (module IN LISTS modules)
    target_include_directories(${module} PRIVATE "${CMAKE_CURRENT_LIST_DIR}")
    target_link_libraries(${module} PRIVATE m)
    set_target_properties(${module} PROPERTIES PREFIX "" C_VISIBILITY_PRESET hidden LIBRARY_OUTPUT_DIRECTORY "${plugins}")
    add_dependencies(TestDevicePlugins ${module})
  endforeach ()
  # What its README promises: the one header and a C compiler, and nothing to be warned of.
  add_test(NAME SampleDevicePluginBuildsByItself
    COMMAND ${CMAKE_C_COMPILER} -std=c99 -pedantic -Wall -Wextra -Werror -O2 -shared -fPIC -I..
      SpringBox.c -o "${plugins}/AsReadmeSays.so" -lm
    WORKING_DIRECTORY "${CMAKE_CURRENT_LIST_DIR}/Sample")
  set_tests_properties(SampleDevicePluginBuildsByItself PROPERTIES LABELS "kernel;device")
endif ()
