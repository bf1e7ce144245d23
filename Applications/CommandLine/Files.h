#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace hasp
{

/// A path's last part, which is all that texts may show: folders carry patients' names.
std::string BaseName(const std::string& path);

/// `text` without the folders of the command line's words, as given and made absolute. A word is a
/// path or --option=path.
std::string WithoutFolders(std::string text, const std::vector<std::string>& words);

/// Call before the work begins. Throws Failure: WrongUse unless the path's ending is one of
/// `endings` (lower case, with the dot; empty: any), its folder exists and can be written to, and
/// what is there already, if anything, is a regular file.
void RequireWritable(const std::string& path, const std::vector<std::string>& endings);

/// Writes all bytes or nothing, as hasp::WriteBytes does. Throws Failure: WrongUse with the
/// system's reason.
void WriteFile(const std::string& path, std::string_view bytes);

/// Throws Failure: BadInput unless the path is a file, or a folder with something in it.
void RequireInput(const std::string& path);

} // namespace hasp
