#pragma once
#include <filesystem>
#include <string>
#include <vector>

/// Files whose every text holds tokens that are in nothing else, for finding where they go.
namespace canary
{

/// The tokens, as a patient's name, number and day of birth would be there: a family name and a
/// given name that no text of ours holds, in any case, joined by "^", "_", Latin-1 or UTF-8 bytes.
inline const std::string Family = "qzvkerika", Given = "wyxjotto", Number = "918273645546372819",
                         Day = "19640229";

/// "qzvkerika_wyxjotto": for names of files and folders.
std::string Name();

/// Tokens in these bytes, or in what is compressed in them (zlib, gzip). Empty: none.
std::string TokensIn(const std::string& bytes);

/// A file or a folder, and whether a reader should take it.
struct Input
{
  std::string path;
  bool opens = true;
};

/// Writes them into the folder. Each is a small ball of 300 in -1000 or a few triangles.
std::vector<Input> MakeDicomFolders(const std::filesystem::path& folder);
std::vector<Input> MakeVolumes(const std::filesystem::path& folder);
std::vector<Input> MakeSurfaces(const std::filesystem::path& folder);

/// 8 x 8 x 8 samples, two bytes each.
std::string Ball();

void WriteTo(const std::filesystem::path& file, const std::string& bytes);

} // namespace canary
