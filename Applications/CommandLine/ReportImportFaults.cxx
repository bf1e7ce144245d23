#include "FaultyFolders.h"
#include "ImportMethods.h"
#include "ImportSubject.h"
#include "Pairing.h"
#include "ReportImport.h"
#include "ReportRegistry.h"

#include "vtkImageData.h"

namespace hasp
{

void ReportFaultyFolders(
  ReportContext& context, const ImportFormat& dicom, const std::filesystem::path& scratch)
{
  const ImportSubject subject = MakeImportSubject(context.settings.quick ? 24 : 64);
  const std::string sound = WriteImport(subject.image, dicom, scratch / "sound");
  const auto faults = MakeFaultyFolders(sound, scratch);
  const ImportRival ours{ "Hasp", ReadOurs };
  std::string missed;
  int acceptedByUs = 0;
  const Timing time = TimeOf(
    [&]
    {
      for (const FaultyFolder& faulty : faults)
        if (!Notices(ours, faulty.folder))
        {
          ++acceptedByUs;
          missed += "; accepted: " + faulty.fault;
        }
    });
  for (const ImportRival& rival : dicom.rivals)
  {
    int accepted = 0;
    const Timing rivalTime = TimeOf(
      [&]
      {
        for (const FaultyFolder& faulty : faults)
          accepted += Notices(rival, faulty.folder) ? 0 : 1;
      });
    ReportRow row;
    row.id = "import.faults." + rival.name.substr(0, rival.name.find(' '));
    row.method = "import.faults";
    row.value = acceptedByUs;
    row.unit = "folders";
    row.better = Better::Lower;
    row.rival = rival.name + " accepts " + std::to_string(accepted) + " in " +
                std::to_string(rivalTime.wallS) + " s";
    row.error = acceptedByUs;
    row.errorUnit = "folders accepted with a fault";
    row.timeS = time.wallS;
    row.cpuS = time.cpuS;
    row.n = static_cast<int>(faults.size());
    row.data = std::to_string(faults.size()) + " folders, a fault each" + missed;
    context.report.rows.push_back(row);
  }
}

} // namespace hasp
