#pragma once

#include <filesystem>

namespace hasp
{

struct ImportFormat;
struct ReportContext;

/// Reading each format against other libraries' readers of it: where samples come to lie (mm) and
/// how long it takes, on one volume that lies obliquely in the patient. Throws std::exception if no
/// file can be written to the temporary folder.
void ReportImport(ReportContext& context);

/// A part of it: how many DICOM folders with a fault each reader accepts without a word. Writes
/// into `scratch`, which is the caller's to remove.
void ReportFaultyFolders(
  ReportContext& context, const ImportFormat& dicom, const std::filesystem::path& scratch);

} // namespace hasp
