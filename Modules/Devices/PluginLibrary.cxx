#include "Devices/PluginLibrary.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace hasp
{

void PluginLibrary::Unload::operator()(void* handle) const
{
  dlclose(handle);
}

PluginLibrary::PluginLibrary(const PluginKind& kind, const std::string& file) : Kind(kind)
{
  std::error_code error;
  const auto path = std::filesystem::absolute(file, error); // with a slash: dlopen searches not
  if (error || !std::filesystem::is_regular_file(path, error))
    this->Refuse("there is no such file");
  // dlerror's text names files, so it is not passed on.
  this->Handle.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!this->Handle)
    this->Refuse("the file is no shared library that can be loaded here; ldd says whether it is one"
                 " for this machine and which of its own libraries are missing");
  this->Entry = dlsym(this->Handle.get(), kind.entry);
  if (!this->Entry)
    this->Refuse(std::string("the library has no function ") + kind.entry +
                 "; it is no plugin, or its symbols are hidden");
}

void PluginLibrary::Refuse(const std::string& why) const
{
  throw std::runtime_error(std::string(this->Kind.what) + ": " + why);
}

void PluginLibrary::Check(std::uint32_t size, std::uint32_t version, std::size_t least) const
{
  if (version != this->Kind.version)
    this->Refuse("the plugin is of version " + std::to_string(version) +
                 ", this Hasp loads version " + std::to_string(this->Kind.version) +
                 "; compile it with this Hasp's " + this->Kind.header);
  if (size < least)
    this->Refuse("the plugin's table has " + std::to_string(size) + " bytes, must be " +
                 std::to_string(least) + " or more");
}

std::string PrintableText(const char* text, std::size_t most)
{
  if (!text)
    return {};
  std::string printable(text, strnlen(text, most));
  std::replace_if(
    printable.begin(), printable.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return printable;
}

} // namespace hasp
