# hasp_embed_shaders(<sources-variable> <headers-variable> file.glsl …)
#
# Each .glsl file becomes a C string of its own name: glsl/vtkHaspFooFS.glsl -> extern const char* vtkHaspFooFS.
function (hasp_embed_shaders sources_variable headers_variable)
  foreach (shader IN LISTS ARGN)
    vtk_encode_string(INPUT "${shader}" HEADER_OUTPUT header SOURCE_OUTPUT source)
    list(APPEND sources "${source}")
    list(APPEND headers "${header}")
  endforeach ()
  set(${sources_variable} "${sources}" PARENT_SCOPE)
  set(${headers_variable} "${headers}" PARENT_SCOPE)
endfunction ()
