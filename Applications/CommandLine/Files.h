#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Files of the command line. Errors call them by hasp::FileLabel.
namespace hasp
{

/// Call before the work begins. Throws Failure: WrongUse unless the path's ending is one of
/// `endings` (lower case, with the dot; empty: any), its folder exists and takes a file (one is
/// made there and removed), and what is there already, if anything, is a regular file.
void RequireWritable(const std::string& path, const std::vector<std::string>& endings);

/// Call before the work begins that ends in a 3mf file. Throws Failure: WrongUse in a build without
/// lib3mf. RequireWritable has done so of a path that ends in .3mf.
void RequireThreeMf();

/// Call before the work begins. Throws Failure: WrongUse, with `options` ("--sketch and --output"),
/// if both paths are one file, whatever they are spelled like.
void RequireDifferent(
  const std::string& path, const std::string& other, const std::string& options);

/// RequireWritable for a folder that is to be made. Throws Failure: WrongUse unless nothing or an
/// empty folder is there, and the folder it lies in exists and can be written to.
void RequireWritableFolder(const std::string& path, const std::string& called = "the folder");

/// Writes all bytes or nothing, as hasp::WriteBytes does. Throws Failure: WrongUse with the
/// system's reason.
void WriteFile(const std::string& path, std::string_view bytes);

/// SHA-256 of a file's bytes, as sha256sum prints it. Empty without HASP_ENABLE_OPENSSL, without a
/// path, and of a file that cannot be read.
std::string HashOfFile(const std::string& path);

/// A name that nothing in the current folder has: "stem-1.png", or -2 and so on.
std::string FreeName(const std::string& stem, const std::string& ending);

/// Throws Failure: BadInput unless the path is a file, or a folder with something in it.
void RequireInput(const std::string& path);

} // namespace hasp
