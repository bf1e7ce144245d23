#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace hasp
{

/// A path's last part, which is all that texts may show: folders carry patients' names.
std::string BaseName(const std::string& path);

/// `text` without the folders of `paths`, as given and made absolute.
std::string WithoutFolders(std::string text, const std::vector<std::string>& paths);

/// Call before the work begins. Throws Failure: WrongUse unless the path's ending is one of
/// `endings` (lower case, with the dot; empty: any), its folder exists and can be written to, and
/// what is there already, if anything, is a regular file.
void RequireWritable(const std::string& path, const std::vector<std::string>& endings);

/// Writes all bytes or nothing: into a file beside it, flushed to the disk, then renamed. Whoever
/// reads `path` sees the old file or the new one. Throws Failure: WrongUse with the system's
/// reason; nothing is left behind.
void WriteFileAtomically(const std::string& path, std::string_view bytes);

/// A file that another writer makes and that stays only if it is kept: beside `path`, with the same
/// ending, renamed to it by Keep, else removed.
class PendingFile
{
public:
  explicit PendingFile(const std::string& path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  void operator=(const PendingFile&) = delete;

  const std::string& Path() const { return this->Pending; }

  /// Throws Failure: WrongUse with the system's reason.
  void Keep();

private:
  std::string Target;
  std::string Pending;
};

/// Throws Failure: BadInput unless the path is a file, or a folder with something in it.
void RequireInput(const std::string& path);

} // namespace hasp
