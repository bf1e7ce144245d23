#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace hasp
{

/// What sort of plugin is looked for, for what is said of it. The texts outlive it.
struct PluginKind
{
  const char* what;      ///< begins each sentence: "head pose plugin"
  const char* entry;     ///< the symbol
  const char* header;    ///< what it is compiled with: "HeadPosePlugin.h"
  std::uint32_t version; ///< the one that is loaded
};

/// A shared library of somebody else's, loaded for as long as this lives.
///
/// It is code that runs in this process; load only what the user names. Threads: one at a time.
/// Cost: dlopen, which runs the library's constructors; dlclose at the end.
class PluginLibrary
{
public:
  /// file  a name without a slash is one in the current folder, never searched for
  /// Throws std::runtime_error if there is no such file, it is no library that can be loaded, or
  /// lacks the symbol; says which and what to do. No sentence names the file.
  PluginLibrary(const PluginKind& kind, const std::string& file);

  /// What the symbol gives, a `const Table* (void)` of C, which begins with size and version.
  /// Throws std::runtime_error if it gives none, or one of another version, or too small a one.
  template <typename Table>
  const Table& Get() const
  {
    const Table* table = reinterpret_cast<const Table* (*)()>(this->Entry)();
    if (!table)
      this->Refuse("the plugin gives no table");
    // Size and version stand first in every version.
    this->Check(table->size, table->version, sizeof(Table));
    return *table;
  }

  /// Throws std::runtime_error: what it is, and why.
  [[noreturn]] void Refuse(const std::string& why) const;

private:
  void Check(std::uint32_t size, std::uint32_t version, std::size_t least) const;

  struct Unload
  {
    void operator()(void* handle) const;
  };
  PluginKind Kind;
  std::unique_ptr<void, Unload> Handle;
  void* Entry = nullptr;
};

/// The first `most` characters of a text of somebody else, anything but printable ASCII as question
/// marks: nothing that a terminal would obey. Empty for a null pointer.
std::string PrintableText(const char* text, std::size_t most);

} // namespace hasp
