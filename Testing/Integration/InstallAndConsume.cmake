# cmake -DBUILD=<build tree> -DSOURCE=<this folder> -DWORK=<folder> -DGENERATOR=… -DFLAGS=<compiler flags>
#   -DLAUNCHER=<ccache or nothing> -DHEADERS=<below the prefix> [-DPYTHON_DIR=<below the prefix>
#   -DPYTHON_TEST=<command>] -P InstallAndConsume.cmake
# Installs the build below WORK and uses it as others do: a C++ project, each header alone, a component that
# is not there, Python. The build tree is not on any path: what the install lacks, its users lack.
file(REMOVE_RECURSE "${WORK}")
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
endfunction ()
set(clean "${CMAKE_COMMAND}" -E env --unset=DISPLAY --unset=LD_LIBRARY_PATH)
set(configure -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
# A window is found in the desktop's menu.
if (EXISTS "${WORK}/prefix/bin/hasp-planner")
  foreach (file applications/hasp-planner.desktop icons/hicolor/scalable/apps/hasp-planner.svg)
    if (NOT EXISTS "${WORK}/prefix/share/${file}")
      message(FATAL_ERROR "share/${file} is not installed beside bin/hasp-planner")
    endif ()
  endforeach ()
endif ()
# A device may be used, and is left without force.
if (EXISTS "${WORK}/prefix/bin/hasp")
  foreach (file bin/hasp-device-guard lib/udev/rules.d/60-hasp-devices.rules)
    if (NOT EXISTS "${WORK}/prefix/${file}")
      message(FATAL_ERROR "${file} is not installed beside bin/hasp")
    endif ()
  endforeach ()
endif ()

run("${CMAKE_COMMAND}" -S "${SOURCE}/Consumer" -B "${WORK}/Consumer" ${configure})
file(STRINGS "${WORK}/Consumer/CMakeCache.txt" found REGEX "^Hasp_DIR:")
if (NOT found MATCHES "=${WORK}/prefix/")
  message(FATAL_ERROR "The consumer found another Hasp: ${found}")
endif ()
run("${CMAKE_COMMAND}" --build "${WORK}/Consumer")
run(${clean} "${WORK}/Consumer/Consumer")
message("${output}")

# A component that is not there stops the configuration, and the message says what there is.
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}/Consumer" -B "${WORK}/Nonsense" ${configure}
  -DALSO=Nonsense RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
if (result EQUAL 0 OR NOT output MATCHES "no component Nonsense.*It has.*KernelGrid.*RenderingIsosurfaceOpenGL2")
  message(FATAL_ERROR "find_package with COMPONENTS Nonsense ended with ${result} and said:\n${output}")
endif ()

run("${CMAKE_COMMAND}" -S "${SOURCE}/Headers" -B "${WORK}/Headers" ${configure}
  "-DHASP_HEADERS=${WORK}/prefix/${HEADERS}")
string(REGEX MATCH "[0-9]+ headers" count "${output}")
run("${CMAKE_COMMAND}" --build "${WORK}/Headers" --parallel 2)
message("${count} compile alone")

if (PYTHON_TEST)
  run(${clean} "PYTHONPATH=${WORK}/prefix/${PYTHON_DIR}" ${PYTHON_TEST})
  message("import hasp works")
endif ()
file(REMOVE_RECURSE "${WORK}")
