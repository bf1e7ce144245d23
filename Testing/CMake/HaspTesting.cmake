# The test harness. Labels: kernel module render haptic device guest app extreme minimal bench long.
if (HASP_BUILD_TESTING)
  enable_testing()
  include(GoogleTest)
endif ()

option(HASP_RECORD_BASELINES "Render tests write pictures and compare none: for update-baseline" OFF)

# The real CT: installed by Utilities/Scripts/cranium, never committed. Tests that read it are there only with it.
if (HASP_BUILD_TESTING)
  find_file(HASP_CRANIUM Cranium.inv3 NO_DEFAULT_PATH
    PATHS /usr/share/doc/invesalius-examples/examples "${PROJECT_SOURCE_DIR}/.cache"
    DOC "A real CT: Cranium.inv3 of Debian's invesalius-examples")
  # DICOM of many makers, sound and not, read where it is installed: Debian's python3-pydicom.
  find_path(HASP_PYDICOM_FILES MR_small.dcm NO_DEFAULT_PATH
    PATHS /usr/lib/python3/dist-packages/pydicom/data/test_files DOC "The test files of pydicom")
endif ()

# hasp_discover_tests(TestKernelGrid labels…): one CTest test per GoogleTest case.
function (hasp_discover_tests target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF) # test files share names freely
  # A program of many libraries may take seconds to start on a machine that is busy.
  set(timeout 120)
  if ("long" IN_LIST ARGN)
    set(timeout 900)
  endif ()
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${timeout})
  # gtest_discover_tests would take a second label for the name of the next property.
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${target}_labels.cmake")
  # Without times of an earlier run ctest starts first what costs most, so that all cores have work at the end:
  # tests that run bin/hasp, then those that draw or make parts.
  set(cost 1)
  if ("app" IN_LIST ARGN)
    set(cost 20)
  elseif ("module" IN_LIST ARGN)
    set(cost 5)
  endif ()
  file(WRITE "${file}" "if (${target}_TESTS)\n"
    "  set_tests_properties(\${${target}_TESTS} PROPERTIES LABELS \"${ARGN}\" COST ${cost})\nendif ()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${file}")
endfunction ()

# hasp_add_kernel_test(Grid SOURCES Testing/TestGridView.cxx … [LIBRARIES targets…] [LABELS labels…])
#
# One program per kernel, one CTest test per GoogleTest case, labelled kernel. A second call with another
# NAME makes a second program, for cases with labels of their own.
function (hasp_add_kernel_test noun)
  if (NOT HASP_BUILD_TESTING)
    return()
  endif ()
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    set(arg_NAME TestKernel${noun})
  endif ()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE Hasp::Kernel${noun} ${arg_LIBRARIES} GTest::gtest_main)
  hasp_discover_tests(${arg_NAME} kernel ${arg_LABELS})
endfunction ()

# hasp_add_device_test(SOURCES Testing/TestHeadPose.cxx … [NAME TestX] [LIBRARIES targets…] [LABELS labels…])
#
# The same for Modules/Devices; labelled kernel, because they need no more than kernels do, and device.
function (hasp_add_device_test)
  if (NOT HASP_BUILD_TESTING)
    return()
  endif ()
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    set(arg_NAME TestDevices)
  endif ()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE Hasp::Devices ${arg_LIBRARIES} GTest::gtest_main)
  hasp_discover_tests(${arg_NAME} kernel device ${arg_LABELS})
endfunction ()

# hasp_add_studies_test(SOURCES Testing/TestHapticBench.cxx … [NAME TestX] [LIBRARIES targets…] [LABELS labels…])
#
# The same for Modules/Studies; labelled kernel.
function (hasp_add_studies_test)
  if (NOT HASP_BUILD_TESTING)
    return()
  endif ()
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    set(arg_NAME TestStudies)
  endif ()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE Hasp::Studies ${arg_LIBRARIES} GTest::gtest_main)
  hasp_discover_tests(${arg_NAME} kernel ${arg_LABELS})
endfunction ()

# hasp_add_module_test(IOMedical SOURCES Cxx/TestVolumeReader.cxx … [LIBRARIES targets…] [LABELS labels…])
#
# GoogleTest cases of a VTK module that draw nothing. Called from the module's Testing/CMakeLists.txt.
function (hasp_add_module_test module)
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    set(arg_NAME Test${module})
  endif ()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE Hasp::${module} ${arg_LIBRARIES} GTest::gtest_main)
  vtk_module_autoinit(TARGETS ${arg_NAME} MODULES Hasp::${module} ${arg_LIBRARIES})
  hasp_discover_tests(${arg_NAME} module ${arg_LABELS})
endfunction ()

# hasp_can_render(<variable>): is there what render tests need, windows without a display and VTK's pictures?
function (hasp_can_render variable)
  set(${variable} OFF PARENT_SCOPE)
  if (TARGET Hasp::RenderingHeadless AND TARGET VTK::IOImage AND TARGET VTK::ImagingCore)
    set(${variable} ON PARENT_SCOPE)
  endif ()
endfunction ()

# hasp_add_render_test(RenderingStereo SOURCES Cxx/TestStereoEyes.cxx … [NAME TestX] [LIBRARIES targets…] [LABELS labels…])
#
# One program that draws one picture and compares it with Data/Baseline/<NAME>.png beside the calling
# CMakeLists.txt; see HaspRenderTest.h for what the source looks like. NAME is the stem of the first
# source. Without that picture configuring stops: a render test that compares nothing cannot fail.
function (hasp_add_render_test module)
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  if (NOT arg_NAME)
    list(GET arg_SOURCES 0 first)
    cmake_path(GET first STEM arg_NAME)
  endif ()
  set(baseline "${CMAKE_CURRENT_SOURCE_DIR}/Data/Baseline/${arg_NAME}.png")
  if (NOT HASP_RECORD_BASELINES AND NOT EXISTS "${baseline}")
    message(FATAL_ERROR "Render test ${arg_NAME} has no baseline ${baseline}\n"
      "Record it, look at it and commit it: Utilities/Scripts/update-baseline ${arg_NAME}")
  endif ()
  hasp_can_render(can_render)
  if (NOT can_render)
    return()
  endif ()

  set(modules Hasp::${module} Hasp::RenderingHeadless VTK::RenderingOpenGL2 ${arg_LIBRARIES})
  list(REMOVE_DUPLICATES modules)
  add_executable(${arg_NAME} ${arg_SOURCES}
    "${PROJECT_SOURCE_DIR}/Testing/ImageComparison/HaspRenderTestMain.cxx")
  set_target_properties(${arg_NAME} PROPERTIES UNITY_BUILD OFF)
  target_compile_definitions(${arg_NAME} PRIVATE HASP_RENDER_TEST=${arg_NAME})
  target_link_libraries(${arg_NAME} PRIVATE HaspImageComparison ${modules})
  vtk_module_autoinit(TARGETS ${arg_NAME} MODULES ${modules})

  set(pictures "${CMAKE_BINARY_DIR}/Testing/Pictures")
  file(WRITE "${pictures}/${arg_NAME}.baseline" "${baseline}\n") # for update-baseline
  add_test(NAME ${arg_NAME} COMMAND ${arg_NAME} --baseline "${baseline}" --output "${pictures}"
    $<$<BOOL:${HASP_RECORD_BASELINES}>:--record>)
  # What VTK reports as an error is one, also where the picture happens to be right.
  set(labels render ${arg_LABELS})
  set_tests_properties(${arg_NAME} PROPERTIES LABELS "${labels}" TIMEOUT 120
    FAIL_REGULAR_EXPRESSION "ERR\\|;ERROR: In ;GL_INVALID_")
endfunction ()

# hasp_add_older_opengl_test(TestOlderOpenGL 3.2 COMMAND TestOlderOpenGL arguments…)
#
# A test that meets an OpenGL 3.2, 3.3 or 4.1 under the name TestOlderOpenGL.3.2. Mesa reads at a process's first
# context how old it is to be; without its cache of shaders it compiles none that is younger.
function (hasp_add_older_opengl_test name version)
  cmake_parse_arguments(arg "" "" "COMMAND" ${ARGN})
  string(REPLACE "." "" glsl "${version}0")
  set(lacks "-GL_ARB_compute_shader -GL_ARB_shader_storage_buffer_object -GL_ARB_texture_view")
  if (version VERSION_LESS 3.3)
    set(glsl 150)
    string(APPEND lacks " -GL_ARB_explicit_attrib_location")
  endif ()
  add_test(NAME ${name}.${version} COMMAND ${arg_COMMAND})
  set_tests_properties(${name}.${version} PROPERTIES LABELS "module;render" TIMEOUT 120
    ENVIRONMENT "MESA_GL_VERSION_OVERRIDE=${version};MESA_GLSL_VERSION_OVERRIDE=${glsl};\
MESA_EXTENSION_OVERRIDE=${lacks};MESA_SHADER_CACHE_DISABLE=true;HASP_EGL_DEVICE=surfaceless")
endfunction ()

# hasp_add_example(DrawIsosurface MODULES targets…)
#
# The program <module>/Examples/DrawIsosurface.cxx, built with the tests and run by Testing/Examples. Left out
# where one of its modules is.
function (hasp_add_example name)
  cmake_parse_arguments(arg "" "" "MODULES" ${ARGN})
  foreach (module IN LISTS arg_MODULES)
    if (NOT TARGET ${module})
      return()
    endif ()
  endforeach ()
  add_executable(${name} ${name}.cxx)
  target_link_libraries(${name} PRIVATE ${arg_MODULES})
  vtk_module_autoinit(TARGETS ${name} MODULES ${arg_MODULES})
endfunction ()
