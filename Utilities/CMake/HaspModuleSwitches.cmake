# Modules that are nothing without one optional dependency leave the build with it.
# `files` is the list of vtk.module files of Modules/CMakeLists.txt.
function (hasp_module_needs option folder)
  if (NOT HASP_ENABLE_${option})
    list(REMOVE_ITEM files "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/vtk.module")
    set(files "${files}" PARENT_SCOPE)
  endif ()
endfunction ()

hasp_module_needs(EGL Rendering/Headless)
hasp_module_needs(EMBREE Rendering/Light)
