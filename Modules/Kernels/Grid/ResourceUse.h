#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace hasp
{

/// One thing a scene may build: a buffer, a shader variant, a texture, a tree, a thread. Owners
/// list what they have *and* what they skipped (bytes 0, milliseconds 0), so that --explain, the
/// planner's panel and the tests of label `minimal` read the same figures.
struct ResourceUse
{
  std::string resource;      ///< stable name, lower case: "cells", "picking buffers", "second eye"
  std::size_t bytes = 0;     ///< held now, on whichever device; 0 = skipped or released
  double milliseconds = 0.0; ///< spent making it since it was last absent; 0 = skipped
  std::string reason;        ///< why it is there, or why not: "mono", "no pick was asked for"
};

using ResourceList = std::vector<ResourceUse>;

} // namespace hasp
