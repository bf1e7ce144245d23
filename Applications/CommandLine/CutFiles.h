#pragma once
#include "FragmentCutter.h"

#include <filesystem>
#include <string>

namespace hasp
{

/// "fragment-1.stl", or "crumb-7.stl"; `format` is the ending without its dot.
std::string NameOfFile(const BoneFragment& fragment, const std::string& format);

/// A file for each fragment, and, as 3mf, fragments.3mf besides: those that are kept, neither
/// resected nor crumbs, as named objects of one file; there is none if none is kept. `hash`: of
/// the recipe they were cut by, for their labels. Throws as WriteSurface.
void WriteFragments(const std::filesystem::path& folder, const CutBone& cut,
  const std::string& format, const std::string& hash);

} // namespace hasp
