#pragma once
#include "Volumes/SampleFile.h"

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// Longer headers are refused. A segmentation has hundreds of lines of its own.
constexpr std::size_t NrrdHeaderLimit = 1 << 22;

/// The lines of an NRRD header, as its specification (format versions 1 to 5) has them.
struct NrrdHeader
{
  std::map<std::string, std::string> fields; ///< by the specification's name, in lower case
  std::map<std::string, std::string> pairs;  ///< "key:=value", unescaped
  std::uint64_t bytes = 0;                   ///< up to where attached samples begin

  const std::string& Field(const char* name) const; ///< empty if the header has none
  /// Of that field; 0 if the header has none. Throws unless it is whole and in [least, 1e15].
  std::int64_t WholeNumber(
    const std::filesystem::path& file, const char* name, std::int64_t least) const;
};

/// Throws ThrowFileError, as all of these do.
NrrdHeader ReadNrrdHeader(const std::filesystem::path& file);

/// One axis of the array.
struct NrrdAxis
{
  std::int64_t size = 0;
  std::string kind;               ///< in lower case; empty if the header says none
  std::optional<glm::dvec3> step; ///< of "space directions", in the file's space
};

std::vector<NrrdAxis> NrrdAxes(const std::filesystem::path& file, const NrrdHeader& header);

/// Type, byte order, encoding and place of the samples; not their sizes.
SampleFile NrrdSamples(const std::filesystem::path& file, const NrrdHeader& header);

/// Where the three spatial axes lie, LPS mm, after sizes have been checked; warns in the passport.
void SetNrrdGeometry(const std::filesystem::path& file, const NrrdHeader& header,
  const std::vector<NrrdAxis>& spatial, Passport& passport);

} // namespace hasp
